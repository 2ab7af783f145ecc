"""Writes the same messages with each of python-can's writers of text, and prints what they are.

    write_logs.py FOLDER

Each line that is printed is a message of classic CAN that a reader has to find in `log.log`, `log.asc` and `log.csv`:
time in µs, identifier with three or eight digits, `R` and length or the data. Between them the logs have what a reader has
to pass over: CAN FD, error frames.
"""

import random
import sys
from pathlib import Path

import can

START = 1_700_000_000


def messages():
    yield can.Message(timestamp=START, arbitration_id=0x000, is_extended_id=False, data=[1, 0])
    yield can.Message(timestamp=START + 5e-6, arbitration_id=0x7FF, is_extended_id=False, data=[])
    yield can.Message(timestamp=START + 0.5, arbitration_id=0x1FFFFFFF, data=range(8), is_rx=False)
    yield can.Message(timestamp=START + 0.75, arbitration_id=0x5, is_extended_id=True, data=[0xFF])
    yield can.Message(timestamp=START + 1, arbitration_id=0x704, is_extended_id=False, is_remote_frame=True, dlc=0)
    yield can.Message(timestamp=START + 1.25, is_error_frame=True)
    yield can.Message(
        timestamp=START + 1.5, arbitration_id=0x123, is_extended_id=False, is_fd=True, bitrate_switch=True, data=bytes(12)
    )
    chance = random.Random(6)
    for number in range(1000):
        yield can.Message(
            timestamp=START + 2 + number / 1000,
            arbitration_id=chance.randrange(0x800),
            is_extended_id=False,
            is_rx=chance.random() < 0.5,
            channel=chance.randrange(2),
            data=chance.randbytes(chance.randrange(9)),
        )


def line(message):
    digits = 8 if message.is_extended_id else 3
    what = f"R{message.dlc}" if message.is_remote_frame else message.data.hex().upper()
    micros = round(message.timestamp * 1_000_000)
    return f"{micros} {message.arbitration_id:0{digits}X}#{what}"


def main(folder):
    writers = [
        can.CanutilsLogWriter(folder / "log.log"),
        can.ASCWriter(folder / "log.asc"),
        can.CSVWriter(folder / "log.csv"),
    ]
    for message in messages():
        for writer in writers:
            # CSV knows no FD.
            if not (message.is_fd and isinstance(writer, can.CSVWriter)):
                writer.on_message_received(message)
        if not message.is_fd and not message.is_error_frame:
            print(line(message))
    for writer in writers:
        writer.stop()


main(Path(sys.argv[1]))
