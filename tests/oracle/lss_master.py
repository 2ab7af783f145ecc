"""python-canopen's LSS master on a bus of lines (`line_network.py`).

The slave on the other end has no node-ID. Every step asserts what a master expects of CiA 305.
"""

import sys

from canopen.lss import LssError
from line_network import LineNetwork

IDENTITY = [int(number, 16) for number in sys.argv[1:5]]


def refused(call, *arguments):
    try:
        call(*arguments)
    except LssError:
        return True
    return False


network = LineNetwork()
lss = network.lss
# The answers come before `send_message` returns: there is nothing to wait for.
lss.RESPONSE_TIMEOUT = 0.001

assert refused(lss.inquire_node_id), "waiting state answers nothing"
found, identity = lss.fast_scan()
assert found and identity == IDENTITY, identity
assert lss.inquire_node_id() == 255
for command, number in zip((0x5A, 0x5B, 0x5C, 0x5D), IDENTITY):
    assert lss.inquire_lss_address(command) == number
assert refused(lss.configure_node_id, 128)
lss.configure_node_id(42)
assert refused(lss.configure_bit_timing, 5)
lss.configure_bit_timing(2)
lss.store_configuration()
lss.send_switch_state_global(lss.WAITING_STATE)

assert not lss.fast_scan()[0], "it has a node-ID now"
assert lss.send_switch_state_selective(*IDENTITY)
assert lss.inquire_node_id() == 42
lss.activate_bit_timing(10)
