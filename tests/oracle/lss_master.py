"""python-canopen's LSS master on a bus of lines: each frame goes to standard output as `7E5#0401000000000000`; what
answers comes on standard input, a frame a line, and `.` after the last.

The slave on the other end has no node-ID. Every step asserts what a master expects of CiA 305.
"""

import sys
import time

import canopen
from canopen.lss import LssError

IDENTITY = [int(number, 16) for number in sys.argv[1:5]]


class LineNetwork(canopen.Network):
    """A network whose bus is this process' standard input and output."""

    def send_message(self, can_id, data, remote=False):
        print(f"{can_id:03X}#{bytes(data).hex().upper()}", flush=True)
        for line in iter(lambda: sys.stdin.readline().strip(), "."):
            assert line, "the slave has gone"
            answer_id, answer = line.split("#")
            self.notify(int(answer_id, 16), bytearray.fromhex(answer), time.time())


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
