"""A bus of lines: each frame goes to standard output as `7E5#0401000000000000`; what answers comes on standard input, a frame a
line, and `.` after the last.
"""

import sys
import time

import canopen


class LineNetwork(canopen.Network):
    """A network whose bus is this process' standard input and output."""

    #: Answers still to come until one gets lost.
    until_loss = None

    def send_message(self, can_id, data, remote=False):
        print(f"{can_id:03X}#{bytes(data).hex().upper()}", flush=True)
        for line in iter(lambda: sys.stdin.readline().strip(), "."):
            assert line, "the slave has gone"
            if self.is_lost():
                continue
            answer_id, answer = line.split("#")
            self.notify(int(answer_id, 16), bytearray.fromhex(answer), time.time())

    def is_lost(self):
        if self.until_loss is None:
            return False
        self.until_loss -= 1
        if self.until_loss >= 0:
            return False
        self.until_loss = None
        return True
