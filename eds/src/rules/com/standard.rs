//! The communication objects of CiA 301: what kind of object each is, and of which types its values are.

use crate::ir::{Address, DataType, ObjectCode};

/// What CiA 301 says of an object, or of all in a range.
pub(super) struct Standard {
    first: u16,
    last: u16,
    pub(super) name: &'static str,
    pub(super) code: ObjectCode,
    values: Values,
    /// Whether no client may ever write it.
    pub(super) read_only: bool,
}

/// The types of the values: of a single one, of the elements from sub-index 1, or of each sub-index from 1.
enum Values {
    Alike(DataType),
    Each(&'static [DataType]),
    Any,
}

/// What CiA 301 says of the object at `index`.
pub(super) fn standard(index: u16) -> Option<&'static Standard> {
    let at = STANDARD.partition_point(|object| object.last < index);
    STANDARD.get(at).filter(|object| object.first <= index)
}

impl Standard {
    /// Whether a client sees no difference between this and an object of `code`: an array is as good as a record.
    pub(super) fn is_like(&self, code: ObjectCode) -> bool {
        has_sub_indices(self.code) == has_sub_indices(code)
    }

    /// The type of the value at `address`; `None` when CiA 301 leaves it open.
    pub(super) fn data_type(&self, address: Address) -> Option<DataType> {
        match (&self.values, address.sub) {
            (Values::Any, _) => None,
            (_, 0) if has_sub_indices(self.code) => Some(U8),
            (Values::Alike(data_type), _) => Some(*data_type),
            (Values::Each(types), sub) => types.get(usize::from(sub).checked_sub(1)?).copied(),
        }
    }
}

const fn has_sub_indices(code: ObjectCode) -> bool {
    matches!(code, ObjectCode::Array | ObjectCode::Record | ObjectCode::DefStruct)
}

const U8: DataType = DataType::Unsigned8;
const U16: DataType = DataType::Unsigned16;
const U32: DataType = DataType::Unsigned32;
const TEXT: DataType = DataType::VisibleString;

/// 1200h to 12FFh (CiA 301, 7.4.8.3).
const SDO: Values = Values::Each(&[U32, U32, U8]);
/// 1400h to 15FFh and 1800h to 19FFh (CiA 301, 7.4.8.1).
const PDO: Values = Values::Each(&[U32, U8, U16, U8, U16, U8]);
/// 1018h (CiA 301, 7.4.8.4).
const IDENTITY: Values = Values::Alike(U32);

const fn var(index: u16, name: &'static str, data_type: DataType) -> Standard {
    range(index, index, name, ObjectCode::Var, Values::Alike(data_type))
}

const fn array(index: u16, name: &'static str, data_type: DataType) -> Standard {
    range(index, index, name, ObjectCode::Array, Values::Alike(data_type))
}

const fn range(first: u16, last: u16, name: &'static str, code: ObjectCode, values: Values) -> Standard {
    Standard {
        first,
        last,
        name,
        code,
        values,
        read_only: false,
    }
}

const fn read_only(object: Standard) -> Standard {
    Standard {
        read_only: true,
        ..object
    }
}

/// CiA 301, 7.5.2, by index. 1004h, 100Eh and 100Fh are of version 3.
static STANDARD: [Standard; 41] = [
    read_only(var(0x1000, "Device type", U32)),
    read_only(var(0x1001, "Error register", U8)),
    read_only(var(0x1002, "Manufacturer status register", U32)),
    array(0x1003, "Pre-defined error field", U32),
    // Its sub-index 0 is a value of its own.
    range(
        0x1004,
        0x1004,
        "Number of PDOs supported",
        ObjectCode::Array,
        Values::Any,
    ),
    var(0x1005, "COB-ID SYNC message", U32),
    var(0x1006, "Communication cycle period", U32),
    var(0x1007, "Synchronous window length", U32),
    read_only(var(0x1008, "Manufacturer device name", TEXT)),
    read_only(var(0x1009, "Manufacturer hardware version", TEXT)),
    read_only(var(0x100A, "Manufacturer software version", TEXT)),
    var(0x100C, "Guard time", U16),
    var(0x100D, "Life time factor", U8),
    var(0x100E, "COB-ID guarding protocol", U32),
    var(0x100F, "Number of SDOs supported", U32),
    array(0x1010, "Store parameters", U32),
    array(0x1011, "Restore default parameters", U32),
    var(0x1012, "COB-ID time stamp object", U32),
    var(0x1013, "High resolution time stamp", U32),
    var(0x1014, "COB-ID EMCY", U32),
    var(0x1015, "Inhibit time EMCY", U16),
    array(0x1016, "Consumer heartbeat time", U32),
    var(0x1017, "Producer heartbeat time", U16),
    read_only(range(0x1018, 0x1018, "Identity object", ObjectCode::Record, IDENTITY)),
    var(0x1019, "Synchronous counter overflow value", U8),
    array(0x1020, "Verify configuration", U32),
    range(0x1021, 0x1021, "Store EDS", ObjectCode::Domain, Values::Any),
    range(0x1022, 0x1022, "Store format", ObjectCode::Var, Values::Any),
    range(0x1023, 0x1023, "OS command", ObjectCode::Record, Values::Any),
    var(0x1024, "OS command mode", U8),
    range(0x1025, 0x1025, "OS debugger interface", ObjectCode::Record, Values::Any),
    array(0x1026, "OS prompt", U8),
    array(0x1027, "Module list", U16),
    array(0x1028, "Emergency consumer object", U32),
    array(0x1029, "Error behavior object", U8),
    range(0x1200, 0x127F, "SDO server parameter", ObjectCode::Record, SDO),
    range(0x1280, 0x12FF, "SDO client parameter", ObjectCode::Record, SDO),
    range(0x1400, 0x15FF, "RPDO communication parameter", ObjectCode::Record, PDO),
    range(
        0x1600,
        0x17FF,
        "RPDO mapping parameter",
        ObjectCode::Record,
        Values::Alike(U32),
    ),
    range(0x1800, 0x19FF, "TPDO communication parameter", ObjectCode::Record, PDO),
    range(
        0x1A00,
        0x1BFF,
        "TPDO mapping parameter",
        ObjectCode::Record,
        Values::Alike(U32),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_objects_stand_in_the_order_of_their_index() {
        assert!(STANDARD.is_sorted_by(|one, other| one.first <= one.last && one.last < other.first));
    }

    #[test]
    fn an_object_of_a_range_is_found_and_one_between_ranges_is_not() {
        assert_eq!(
            standard(0x1423).map(|object| object.name),
            Some("RPDO communication parameter")
        );
        assert!(standard(0x0FFF).is_none() && standard(0x101A).is_none() && standard(0x1C00).is_none());
    }

    #[test]
    fn each_sub_index_of_a_record_has_its_own_type() {
        let of = |index, sub| standard(index).and_then(|object| object.data_type(Address::new(index, sub)));
        assert_eq!(of(0x1800, 0), Some(U8));
        assert_eq!(of(0x1800, 3), Some(U16));
        assert_eq!(of(0x1800, 7), None);
        assert_eq!(of(0x1017, 0), Some(U16));
        assert_eq!(of(0x1018, 4), Some(U32));
    }
}
