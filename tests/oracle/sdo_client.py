"""python-canopen's SDO client on a bus of lines (`line_network.py`): long values go there and back in segments and in blocks, on
the node's first SDO server and on its second.

Node 1 has 2001h, a VISIBLE_STRING, and 2002h, a DOMAIN, of 5000 bytes at most, and its second server on 680h and 690h.
"""

import canopen
from canopen.objectdictionary import DOMAIN, VISIBLE_STRING, ODVariable, ObjectDictionary
from canopen.sdo import SdoAbortedError
from line_network import LineNetwork

LONGEST = 5000
# None, one segment, the segments of a block, one more, and as much as fits.
LENGTHS = [1, 6, 7, 8, 126 * 7, 127 * 7, 127 * 7 + 1, 254 * 7, LONGEST]
SEGMENTED = {}
BLOCK_WITH_CRC = {"block_transfer": True, "request_crc_support": True}
BLOCK_WITHOUT_CRC = {"block_transfer": True, "request_crc_support": False}


def dictionary():
    objects = ObjectDictionary()
    for name, index, data_type in [("Text", 0x2001, VISIBLE_STRING), ("File", 0x2002, DOMAIN)]:
        variable = ODVariable(name, index)
        variable.data_type = data_type
        variable.access_type = "rw"
        objects.add_object(variable)
    return objects


def write(sdo, name, data, manner):
    with sdo[name].open("wb", size=len(data), **manner) as stream:
        stream.write(data)


def read(sdo, name, manner):
    with sdo[name].open("rb", **manner) as stream:
        return stream.read()


def bytes_of(name, length, seed):
    """Bytes that differ from one segment to the next; characters for a text."""
    numbers = (seed + at * at // 7 for at in range(length))
    return bytes(0x20 + number % 95 if name == "Text" else number % 256 for number in numbers)


def there_and_back(sdo, name, length, seed):
    """What is written in each manner is what is read in each manner."""
    manners = [SEGMENTED, BLOCK_WITH_CRC, BLOCK_WITHOUT_CRC]
    for number, manner in enumerate(manners):
        data = bytes_of(name, length, seed + number)
        write(sdo, name, data, manner)
        for other in manners:
            assert read(sdo, name, other) == data, (name, length, manner, other)


def refused(code, call, *arguments):
    try:
        call(*arguments)
    except SdoAbortedError as error:
        assert error.code == code, error
    else:
        raise AssertionError(f"{call} is taken")


network = LineNetwork()
node = canopen.RemoteNode(1, dictionary())
network.add_node(node)
second = node.add_sdo(0x680, 0x690)
# canopen 2.4.1 leaves this to its user.
second.network = network
for sdo in (node.sdo, second):
    sdo.RESPONSE_TIMEOUT = 0.05
    for name in ("Text", "File"):
        for seed, length in enumerate(LENGTHS):
            there_and_back(sdo, name, length, 17 * seed)
    for manner in (SEGMENTED, BLOCK_WITH_CRC, BLOCK_WITHOUT_CRC):
        refused(0x06070012, write, sdo, "File", bytes(LONGEST + 1), manner)

# A segment of the block that is read gets lost: what follows it comes again.
data = bytes_of("File", LONGEST, 5)
write(node.sdo, "File", data, BLOCK_WITH_CRC)
for lost in (1, 2, 64, 126, 128, 300):
    network.until_loss = lost
    assert read(node.sdo, "File", BLOCK_WITH_CRC) == data, lost
    assert network.until_loss is None

# What one server has open is none of the other's business.
stream = node.sdo["File"].open("wb", size=LONGEST, buffering=0, **BLOCK_WITH_CRC)
stream.write(data[:7])
write(second, "File", b"short", BLOCK_WITH_CRC)
assert read(second, "File", SEGMENTED) == b"short"
at = 7
while at < LONGEST:
    at += stream.write(data[at : at + 7])
stream.close()
assert read(second, "File", BLOCK_WITH_CRC) == data
