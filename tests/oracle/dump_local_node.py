"""Dumps a device that python-canopen makes of an EDS, over a virtual bus.

    dump_local_node.py SCRIPT EDS OUT

SCRIPT defines dump(node), as docs/dump-format.md shows it.
"""

import json
import runpy
import sys

import canopen

NODE = 5


def main(script, eds, out):
    dump = runpy.run_path(script)["dump"]
    here, there = canopen.Network(), canopen.Network()
    for network in (here, there):
        network.connect(interface="virtual", channel="lexican-dump")
    try:
        there.create_node(NODE, eds)
        with open(out, "w", encoding="utf-8") as file:
            json.dump(dump(here.add_node(NODE, eds)), file)
    finally:
        here.disconnect()
        there.disconnect()


main(*sys.argv[1:])
