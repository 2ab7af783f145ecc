"""Compares Lexican's reading of EDS and DCF files with python-canopen's.

    python_canopen.py READINGS.jsonl KNOWN.md

READINGS.jsonl: a line for each file, {"path": ..., "entries": [{"index", "sub", "data_type", "access", ...}]}.
KNOWN.md: the known differences; its tables have a row `| class | number | ... |` for each.

Exits with 1, and says why, when a difference belongs to no class, or when a class has another number of differences than
KNOWN.md says. Needs canopen 2.4.1; installs nothing.
"""

import collections
import io
import json
import logging
import re
import sys

import canopen
from canopen.objectdictionary import ODArray, ODRecord, ODVariable

NODE_ID = 1
SIGNED = {0x02: 8, 0x03: 16, 0x04: 32, 0x10: 24, 0x12: 40, 0x13: 48, 0x14: 56, 0x15: 64}
DOMAIN = 0x0F
ABSENT = object()


def main(readings, known):
    logging.disable(logging.CRITICAL)
    found = collections.Counter()
    examples = collections.defaultdict(list)
    files = entries = agreed = 0
    with open(readings, encoding="utf-8") as lines:
        for line in lines:
            reading = json.loads(line)
            path = reading["path"]
            text = decode(path)
            theirs = read(path, text)
            if isinstance(theirs, str):
                note(found, examples, theirs, path)
                continue
            files += 1
            sections = sections_of(text)
            ours = {(e["index"], e["sub"]): e for e in reading["entries"]}
            for address in sorted(set(ours) | set(theirs)):
                entries += 1
                differences = list(compare(ours.get(address), theirs.get(address)))
                agreed += not differences
                for field, our, their in differences:
                    name = classify(field, our, their, address, sections, ours.get(address), theirs.get(address))
                    where = f"{path.rsplit('/')[-1]} {address[0]:04X}sub{address[1]:X} {field}: {our!r} / {their!r}"
                    note(found, examples, name, where)
    print(f"{files} files read by both, {entries} entries, {agreed} of them the same in every field")
    return verdict(found, examples, expected(known))


def note(found, examples, name, where):
    found[name] += 1
    examples[name].append(where)


def verdict(found, examples, expected):
    wrong = 0
    for name in sorted(set(found) | set(expected)):
        if found[name] == expected.get(name, 0):
            continue
        wrong += 1
        print(f"{name}: {found[name]} differences, {expected.get(name, 0)} known; such as")
        step = max(1, len(examples[name]) // 12)
        for where in examples[name][::step][:12]:
            print(f"    {where}")
    return 1 if wrong else 0


def expected(known):
    """The rows of the tables: | `class` | number | ..."""
    with open(known, encoding="utf-8") as lines:
        rows = (re.match(r"\| `([a-z0-9-]+)` \| (\d+) \|", line) for line in lines)
        return {row[1]: int(row[2]) for row in rows if row}


def decode(path):
    with open(path, "rb") as file:
        data = file.read()
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def read(path, text):
    """python-canopen's entries by address, or the class of its failure."""
    file = io.StringIO(text)
    file.name = "device.eds"  # it goes by the extension, and some files have another one behind it
    try:
        dictionary = canopen.import_od(file, NODE_ID)
    except Exception as error:  # it raises whatever its parts raise
        return failure(error)
    entries = {}
    for item in dictionary.values():
        if isinstance(item, ODVariable):
            entries[item.index, 0] = item
        else:
            for variable in item.subindices.values():
                entries[item.index, variable.subindex] = variable
    # Dummy types are no objects of the device.
    return {address: entry for address, entry in entries.items() if address[0] >= 0x20}


def failure(error):
    """The class of a file that python-canopen refuses."""
    message = str(error)
    for name, pattern in [
        ("refused-duplicate-keyword", "option .* already exists"),
        ("refused-duplicate-section", "section .* already exists"),
        ("refused-missing-comment", "No option 'Line"),
        ("refused-missing-dummy", "No option 'Dummy"),
        ("refused-unreadable-number", "invalid literal for int"),
        ("refused-control-z", r"\\x1a"),
    ]:
        if re.search(pattern, message):
            return name
    return "refused-otherwise"


def sections_of(text):
    """The file's sections, in lower case, for telling why readings differ; the first of each name and key."""
    sections = {}
    section = None
    for line in text.splitlines():
        line = line.strip()
        if line.startswith("["):
            name = line[1:].split("]")[0].strip().lower()
            section = None if name in sections else sections.setdefault(name, {})
        elif section is not None and "=" in line and not line.startswith((";", "#")):
            key, value = line.split("=", 1)
            section.setdefault(key.strip().lower(), value.strip())
    return sections


def compare(ours, theirs):
    if ours is None or theirs is None:
        yield "entry", ours and "there", theirs and "there"
        return
    configured = ours["configured"] or theirs.value is not None
    for field, our, their in [
        ("data type", ours["data_type"], theirs.data_type),
        ("access", ours["access"], theirs.access_type),
        ("pdo mapping", ours["pdo_mapping"], theirs.pdo_mappable),
        ("default", ours["default"], theirs.value if configured else theirs.default),
        ("low", ours["low"], theirs.min),
        ("high", ours["high"], theirs.max),
    ]:
        if not same(our, their):
            yield field, our, their


def same(our, their):
    if isinstance(our, dict):
        return their == bytes(our["bytes"])
    if isinstance(our, float) and isinstance(their, (int, float)):
        return abs(our - their) <= 1e-6 * abs(their)
    return our == their


def classify(field, our, their, address, sections, ours, theirs):
    """The class of a difference, by what the file says there; KNOWN.md has the reasons."""
    index, sub = address
    whole = sections.get(f"{index:04x}", {})
    section = sections.get(f"{index:04x}sub{sub:x}") or sections.get(f"{index:04x}sub{sub:02x}")
    if section is None and (sub or whole_number(whole.get("objecttype")) in (8, 9)):
        return "compact-form" if "compactsubobj" in whole else "missing-sub-zero" if sub == 0 else "unknown"
    section = section or whole
    if field == "entry":
        return "unknown-object-type" if theirs is None and whole_number(whole["objecttype"]) > 9 else "unknown"
    if field == "access":
        return "unknown-access-type" if section["accesstype"] not in ACCESS_TYPES else "unknown"
    if field == "pdo mapping":
        return classify_mapping(their, section)
    if field == "default":
        return classify_default(our, their, section, ours["data_type"])
    if field in ("low", "high"):
        return classify_limit(our, section[f"{field}limit"], whole_number(section["datatype"]))
    return "unknown"


ACCESS_TYPES = ("ro", "rw", "wo", "rwr", "rww", "const")


def classify_mapping(their, section):
    value = section["pdomapping"]
    if value not in ("0", "1"):
        return "mapping-not-0-or-1"
    return "keyword-in-another-case" if value == "1" and not their else "unknown"


def classify_default(our, their, section, data_type):
    text = section.get("parametervalue") or section.get("defaultvalue") or ""
    number = whole_number(text)
    if their in ("", b""):
        return "empty-value"
    if their == f'"{our}"':
        return "quotes"
    if data_type in SIGNED and their is not None and their - our == 1 << SIGNED[data_type]:
        return "twos-complement-default"
    if data_type == 0x01 and our is None and number not in (0, 1):
        return "boolean-not-0-or-1"
    if data_type in BYTES and their is None and text.startswith("0x"):
        return "bytes-with-0x"
    if data_type in REALS and their is None:
        return "real-in-hex" if number is not None else "real-with-suffix"
    if data_type in TIMES and their == whole_number(text.replace(" ", "")):
        return "time"
    if text.upper() == "$NODEID" and their is None:
        return "bare-node-id"
    return "unknown"


def classify_limit(our, text, data_type):
    if data_type in TEXTS:
        return "limit-of-text"
    if data_type > 0x1B:
        return "limit-of-unknown-type"
    if "$NODEID" in text.upper():
        return "limit-formula"
    if data_type in REALS:
        return "limit-with-fraction"
    if data_type in SIGNED and SIGNED[data_type] not in (8, 16, 32, 64):
        return "limit-of-24-to-56-bits"
    number = whole_number(text)
    if our is None and number is not None and not in_range(number, data_type):
        return "limit-out-of-range"
    return "unknown"


BYTES = (0x0A, DOMAIN)
TEXTS = (0x09, 0x0B)
REALS = (0x08, 0x11)
TIMES = (0x0C, 0x0D)
UNSIGNED = {0x01: 1, 0x05: 8, 0x06: 16, 0x07: 32, 0x16: 24, 0x18: 40, 0x19: 48, 0x1A: 56, 0x1B: 64}


def in_range(number, data_type):
    """Whether a limit as written is of the type; by two's complement, if need be."""
    bits = SIGNED.get(data_type) or UNSIGNED[data_type]
    lowest = -(1 << bits - 1) if data_type in SIGNED else 0
    highest = (1 << bits - 1) - 1 if data_type in SIGNED else (1 << bits) - 1
    return lowest <= number <= highest


def whole_number(text):
    try:
        return int(text, 0)
    except (TypeError, ValueError):
        return None


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
