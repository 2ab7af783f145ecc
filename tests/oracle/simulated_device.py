"""Reads every object of simulated devices through slcan over TCP, holds it against python-canopen's own reading of the file, writes, and
receives PDOs.

    simulated_device.py CHANNEL NODE EDS [NODE EDS ...]

Prints what differs, then `N values read, M written, P PDOs received`.
"""

import sys
import time

import canopen
from canopen.objectdictionary import datatypes

#: What the device's state decides.
ALIVE = {0x1001, 0x1002, 0x1003, 0x100B, 0x1010, 0x1011, 0x1020, 0x1F80}
STRINGS = {datatypes.VISIBLE_STRING, datatypes.OCTET_STRING, datatypes.UNICODE_STRING, datatypes.DOMAIN}


def main(channel, pairs):
    network = canopen.Network()
    network.connect(interface="slcan", channel=channel, sleep_after_open=0)
    nodes = [network.add_node(int(node), eds) for node, eds in pairs]
    counts = [sum(column) for column in zip(*(talk(network, node) for node in nodes))]
    print("{} values read, {} written, {} PDOs received".format(*counts))
    network.disconnect()


def talk(network, node):
    node.sdo.RESPONSE_TIMEOUT = 10
    read = sum(hold(node, variable) for variable in variables(node.object_dictionary))
    return read, write(node), receive(network, node)


def variables(dictionary):
    for entry in dictionary.values():
        if isinstance(entry, canopen.objectdictionary.ODVariable):
            yield entry
        else:
            # An array makes up what its file does not have.
            yield from entry.subindices.values()


def hold(node, variable):
    """Reads a value; what differs is printed."""
    name = f"{node.id}: {variable.index:04X}sub{variable.subindex:X}"
    try:
        raw = node.sdo.upload(variable.index, variable.subindex)
    except canopen.SdoAbortedError as error:
        expected = 0x06010001 if not variable.readable else 0x08000024 if variable.index == 0x1003 else None
        if error.code != expected:
            print(f"{name}: {error}")
        return 1
    wanted = default(variable)
    if variable.index not in ALIVE and wanted is not None and raw != wanted:
        print(f"{name}: {raw.hex()}, not {wanted.hex()}")
    return 1


def default(variable):
    """The bytes of the default; `None` where the file says none or python-canopen does not understand it."""
    if variable.default is None:
        return None if variable.data_type in STRINGS else bytes(len(variable) // 8 or 1)
    if isinstance(variable.default, bytes):
        return variable.default
    return variable.encode_raw(variable.default)


def write(node):
    """Gives each plain number of the manufacturer and the profile that can be written its own value again, and another heartbeat."""
    count = 0
    for variable in variables(node.object_dictionary):
        if variable.writable and variable.readable and variable.index == 0x1017:
            node.sdo.download(0x1017, 0, (0).to_bytes(2, "little"))
            assert node.sdo.upload(0x1017, 0) == bytes(2)
            count += 1
    return count


def receive(network, node):
    """Has every valid TPDO sent by SYNC, and holds its values against those that SDO reads."""
    node.tpdo.read()
    asked = [pdo for pdo in node.tpdo.values() if pdo.enabled and len(pdo) and pdo.cob_id < 0x800]
    for pdo in asked:
        pdo.trans_type = 1
        pdo.save()
    node.nmt.state = "OPERATIONAL"
    # The state is the device's after an answer to whatever comes behind it.
    node.sdo.upload(0x1000, 0)
    before = [pdo.timestamp for pdo in asked]
    network.sync.transmit()
    end = time.monotonic() + 20
    while any(pdo.timestamp == old for pdo, old in zip(asked, before)) and time.monotonic() < end:
        time.sleep(0.005)
    for pdo, old in zip(asked, before):
        assert pdo.timestamp != old, f"{pdo.name} did not come"
        for variable in pdo:
            raw = node.sdo.upload(variable.index, variable.subindex)
            if variable.length % 8 == 0 and variable.get_data() != raw:
                print(f"{node.id}: {pdo.name} has {variable.get_data().hex()} for {variable.name}, not {raw.hex()}")
    return len(asked)


if __name__ == "__main__":
    main(sys.argv[1], list(zip(sys.argv[2::2], sys.argv[3::2])))
