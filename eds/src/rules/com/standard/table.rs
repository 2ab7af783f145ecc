//! The objects by index.

use super::{Access, Field, Fields, Standard};
use crate::ir::{DataType, ObjectCode};

/// CiA 301, clause 7.5.2. 1004h, 100Bh, 100Eh and 100Fh are of version 3.
const CIA_301: &str = "CiA 301";
/// CiA 302: part 2, network management; part 3, configuration and program download.
const CIA_302: &str = "CiA 302";
/// CANopen Safety.
const SAFETY: &str = "EN 50325-5";

const U8: DataType = DataType::Unsigned8;
const U16: DataType = DataType::Unsigned16;
const U32: DataType = DataType::Unsigned32;
const U64: DataType = DataType::Unsigned64;
const TEXT: DataType = DataType::VisibleString;
const DOMAIN: DataType = DataType::Domain;

const fn read(data_type: DataType) -> Field {
    field(data_type, Access::Read)
}

const fn configure(data_type: DataType) -> Field {
    field(data_type, Access::Configure)
}

const fn read_write(data_type: DataType) -> Field {
    field(data_type, Access::ReadWrite)
}

const fn write(data_type: DataType) -> Field {
    field(data_type, Access::Write)
}

const fn field(data_type: DataType, access: Access) -> Field {
    Field {
        data_type: Some(data_type),
        access,
        mappable: false,
    }
}

/// A PDO may carry it.
const fn mappable(field: Field) -> Field {
    Field {
        mappable: true,
        ..field
    }
}

/// Versions of the standard give it different types.
const fn of_any_type(access: Access) -> Field {
    Field {
        data_type: None,
        access,
        mappable: false,
    }
}

const fn var(index: u16, name: &'static str, field: Field) -> Standard {
    Standard {
        first: index,
        last: index,
        name,
        document: CIA_301,
        code: ObjectCode::Var,
        zero: None,
        fields: Fields::Alike(field),
        mandatory: 0,
        highest: 0,
    }
}

/// Elements from sub-index 1, of which the first is mandatory.
const fn array(index: u16, name: &'static str, highest: u8, field: Field) -> Standard {
    Standard {
        code: ObjectCode::Array,
        zero: Some(read(U8)),
        mandatory: 1,
        highest,
        ..var(index, name, field)
    }
}

const fn record(first: u16, last: u16, name: &'static str, mandatory: u8, fields: &'static [Field]) -> Standard {
    #[expect(clippy::cast_possible_truncation, reason = "no record here has 255 fields")]
    let highest = fields.len() as u8;
    Standard {
        first,
        last,
        name,
        document: CIA_301,
        code: ObjectCode::Record,
        zero: Some(read(U8)),
        fields: Fields::Each(fields),
        mandatory,
        highest,
    }
}

/// A mapping of PDOs: sub-index 0 is the number of objects in force, which may be 0.
const fn mapping(first: u16, last: u16, name: &'static str) -> Standard {
    Standard {
        last,
        code: ObjectCode::Record,
        zero: Some(configure(U8)),
        mandatory: 0,
        ..array(first, name, 64, configure(U32))
    }
}

/// The object of another standard.
const fn of(document: &'static str, object: Standard) -> Standard {
    Standard { document, ..object }
}

/// Several objects alike, up to `last`.
const fn up_to(last: u16, object: Standard) -> Standard {
    Standard { last, ..object }
}

/// CiA 301, 7.4.8.4.
const IDENTITY: [Field; 4] = [read(U32); 4];
/// CiA 301, 7.4.8.1. Sub-index 4 of an RPDO, 6 too, are not used.
const PDO: [Field; 6] = [
    configure(U32),
    configure(U8),
    configure(U16),
    configure(U8),
    configure(U16),
    configure(U8),
];
/// CiA 301, 7.4.8.3: the server of the predefined connection set has COB-IDs that cannot be changed.
const DEFAULT_SDO: [Field; 3] = [mappable(read(U32)), mappable(read(U32)), configure(U8)];
const SDO: [Field; 3] = [mappable(configure(U32)), mappable(configure(U32)), configure(U8)];
/// CiA 301, 7.4.8.5 and 7.4.8.6: a command, its status, the reply.
const COMMAND: [Field; 3] = [of_any_type(Access::Write), read(U8), of_any_type(Access::Read)];
/// Standard input, output, and errors.
const PROMPT: [Field; 3] = [mappable(write(U8)), mappable(read(U8)), mappable(read(U8))];
/// Direction, refresh time, validation time, transmission type, two COB-IDs.
const SRDO: [Field; 6] = [
    configure(U8),
    configure(U16),
    configure(U8),
    configure(U8),
    configure(U32),
    configure(U32),
];

/// As many nodes as a network has; sub-index 128 of a request stands for all of them.
const NODES: u8 = 127;
const ALL_NODES: u8 = 128;

/// By index.
pub(super) static STANDARD: [Standard; 81] = [
    var(0x1000, "Device type", read(U32)),
    var(0x1001, "Error register", mappable(read(U8))),
    var(0x1002, "Manufacturer status register", mappable(read(U32))),
    // A client clears the errors by writing 0 to sub-index 0.
    Standard {
        zero: Some(read_write(U8)),
        ..array(0x1003, "Pre-defined error field", 254, read(U32))
    },
    // Its sub-index 0 is a value of its own.
    Standard {
        zero: None,
        fields: Fields::Any,
        mandatory: 0,
        ..array(0x1004, "Number of PDOs supported", 2, read(U32))
    },
    var(0x1005, "COB-ID SYNC message", configure(U32)),
    var(0x1006, "Communication cycle period", read_write(U32)),
    var(0x1007, "Synchronous window length", configure(U32)),
    var(0x1008, "Manufacturer device name", read(TEXT)),
    var(0x1009, "Manufacturer hardware version", read(TEXT)),
    var(0x100A, "Manufacturer software version", read(TEXT)),
    var(0x100B, "Node-ID", of_any_type(Access::Configure)),
    var(0x100C, "Guard time", configure(U16)),
    var(0x100D, "Life time factor", configure(U8)),
    var(0x100E, "COB-ID guarding protocol", configure(U32)),
    var(0x100F, "Number of SDOs supported", configure(U32)),
    array(0x1010, "Store parameters", NODES, configure(U32)),
    array(0x1011, "Restore default parameters", NODES, configure(U32)),
    var(0x1012, "COB-ID time stamp object", configure(U32)),
    var(0x1013, "High resolution time stamp", mappable(configure(U32))),
    var(0x1014, "COB-ID EMCY", configure(U32)),
    var(0x1015, "Inhibit time EMCY", read_write(U16)),
    array(0x1016, "Consumer heartbeat time", NODES, read_write(U32)),
    var(0x1017, "Producer heartbeat time", read_write(U16)),
    record(0x1018, 0x1018, "Identity object", 1, &IDENTITY),
    var(0x1019, "Synchronous counter overflow value", configure(U8)),
    Standard {
        mandatory: 2,
        ..array(0x1020, "Verify configuration", 2, read_write(U32))
    },
    Standard {
        code: ObjectCode::Domain,
        ..var(0x1021, "Store EDS", of_any_type(Access::Read))
    },
    var(0x1022, "Store format", of_any_type(Access::Read)),
    record(0x1023, 0x1023, "OS command", 3, &COMMAND),
    var(0x1024, "OS command mode", write(U8)),
    record(0x1025, 0x1025, "OS debugger interface", 3, &COMMAND),
    record(0x1026, 0x1026, "OS prompt", 2, &PROMPT),
    array(0x1027, "Module list", 254, read(U16)),
    array(0x1028, "Emergency consumer object", NODES, configure(U32)),
    array(0x1029, "Error behavior object", 254, configure(U8)),
    of(CIA_302, var(0x102A, "NMT inhibit time", configure(U16))),
    record(0x1200, 0x1200, "SDO server parameter", 2, &DEFAULT_SDO),
    record(0x1201, 0x127F, "SDO server parameter", 2, &SDO),
    record(0x1280, 0x12FF, "SDO client parameter", 3, &SDO),
    of(SAFETY, var(0x1300, "Global fail-safe command parameter", configure(U8))),
    of(SAFETY, record(0x1301, 0x1340, "SRDO communication parameter", 6, &SRDO)),
    of(SAFETY, mapping(0x1381, 0x13C0, "SRDO mapping parameter")),
    of(SAFETY, var(0x13FE, "Configuration valid", configure(U8))),
    of(
        SAFETY,
        array(0x13FF, "Safety configuration signature", 64, configure(U16)),
    ),
    record(0x1400, 0x15FF, "RPDO communication parameter", 2, &PDO),
    mapping(0x1600, 0x17FF, "RPDO mapping parameter"),
    record(0x1800, 0x19FF, "TPDO communication parameter", 2, &PDO),
    mapping(0x1A00, 0x1BFF, "TPDO mapping parameter"),
    of_nodes(0x1F20, "Store DCF", of_any_type(Access::Configure)),
    of_nodes(0x1F21, "Storage format", configure(U8)),
    of_nodes(0x1F22, "Concise DCF", of_any_type(Access::Configure)),
    of_nodes(0x1F23, "Store EDS NMT slave", of_any_type(Access::Configure)),
    of_nodes(0x1F24, "Storage format EDS NMT slave", configure(U8)),
    of_nodes(0x1F25, "Configuration request", of_any_type(Access::Write)),
    of_nodes(0x1F26, "Expected configuration date", configure(U32)),
    of_nodes(0x1F27, "Expected configuration time", configure(U32)),
    of(CIA_302, array(0x1F50, "Program data", 254, write(DOMAIN))),
    of(CIA_302, array(0x1F51, "Program control", 254, read_write(U8))),
    of(
        CIA_302,
        array(0x1F52, "Verify application software", 254, configure(U32)),
    ),
    of_nodes(0x1F53, "Expected application software date", configure(U32)),
    of_nodes(0x1F54, "Expected application software time", configure(U32)),
    of_nodes(0x1F55, "Expected software identification", configure(U32)),
    of(
        CIA_302,
        array(0x1F56, "Program software identification", 254, read(U32)),
    ),
    of(CIA_302, array(0x1F57, "Flash status identification", 254, read(U32))),
    of_nodes(0x1F58, "Program data of NMT slaves", of_any_type(Access::Configure)),
    of(CIA_302, var(0x1F80, "NMT startup", configure(U32))),
    of_nodes(0x1F81, "NMT slave assignment", configure(U32)),
    of_all_nodes(0x1F82, "Request NMT", configure(U8)),
    of_all_nodes(0x1F83, "Request node guarding", configure(U8)),
    of_nodes(0x1F84, "Device type identification", configure(U32)),
    of_nodes(0x1F85, "Vendor identification", configure(U32)),
    of_nodes(0x1F86, "Product code", configure(U32)),
    of_nodes(0x1F87, "Revision number", configure(U32)),
    of_nodes(0x1F88, "Serial number", configure(U32)),
    of(CIA_302, var(0x1F89, "Boot time", configure(U32))),
    of_nodes(0x1F8A, "Restore configuration", configure(U8)),
    of(
        CIA_302,
        array(0x1F90, "NMT flying master timing parameters", 254, configure(U16)),
    ),
    of(
        CIA_302,
        array(0x1F91, "Self starting node timing parameters", 254, configure(U16)),
    ),
    up_to(0x1FCF, array(0x1FA0, "Object scanner list", 254, configure(U32))),
    up_to(0x1FFF, array(0x1FD0, "Object dispatching list", 254, configure(U64))),
];

/// An element for each node that the master knows, at the sub-index of its node-ID.
const fn of_nodes(index: u16, name: &'static str, field: Field) -> Standard {
    Standard {
        mandatory: 0,
        ..of(CIA_302, array(index, name, NODES, field))
    }
}

const fn of_all_nodes(index: u16, name: &'static str, field: Field) -> Standard {
    Standard {
        highest: ALL_NODES,
        ..of_nodes(index, name, field)
    }
}
