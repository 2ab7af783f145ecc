"""Dumps a device that python-canopen makes of an EDS, over a virtual bus.

    dump_local_node.py SCRIPT EDS OUT [LOG]

SCRIPT defines dump(node), as docs/dump-format.md shows it. LOG gets what happens on the bus meanwhile: `.log` as candump
writes it, `.asc` as Vector does, `.csv` as python-can does.
"""

import json
import runpy
import sys

import can
import canopen

NODE = 5


def main(script, eds, out, log=None):
    dump = runpy.run_path(script)["dump"]
    here, there = canopen.Network(), canopen.Network()
    for network in (here, there):
        network.connect(interface="virtual", channel="lexican-dump")
    listener = can.Bus(interface="virtual", channel="lexican-dump")
    logger = can.Logger(log) if log else None
    recorder = can.Notifier(listener, [logger.on_message_received]) if log else None
    try:
        there.create_node(NODE, eds)
        with open(out, "w", encoding="utf-8") as file:
            json.dump(dump(here.add_node(NODE, eds)), file)
    finally:
        if recorder:
            recorder.stop()
            # What came while it stopped.
            while (message := listener.recv(0)) is not None:
                logger(message)
            logger.stop()
        listener.shutdown()
        here.disconnect()
        there.disconnect()


main(*sys.argv[1:])
