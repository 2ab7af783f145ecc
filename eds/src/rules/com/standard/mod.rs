//! What the standards say of the objects 1000h to 1FFFh: what kind of object each is, which sub-indices it has, of which
//! type its values are, who may write them, and whether a PDO may carry them.

mod table;

use crate::ir::{AccessType, Address, DataType, ObjectCode};
use table::STANDARD;

/// What a standard says of an object, or of all in a range.
pub(super) struct Standard {
    first: u16,
    last: u16,
    pub(super) name: &'static str,
    /// The standard: `CiA 301`.
    pub(super) document: &'static str,
    pub(super) code: ObjectCode,
    /// Sub-index 0, where the object has sub-indices; `None` where it is left open.
    zero: Option<Field>,
    fields: Fields,
    /// The sub-indices from 1 to this one are in each device that has the object.
    pub(super) mandatory: u8,
    /// The highest sub-index that there can be.
    pub(super) highest: u8,
}

/// The values: a single one, or those at sub-indices from 1.
enum Fields {
    Alike(Field),
    Each(&'static [Field]),
    /// Left open.
    Any,
}

/// A value.
#[derive(Clone, Copy)]
pub(super) struct Field {
    /// `None` where versions of the standard differ.
    pub(super) data_type: Option<DataType>,
    pub(super) access: Access,
    /// Whether a PDO may carry it.
    pub(super) mappable: bool,
}

/// What a client may do, as the standards have it: mostly a device may offer less than full access.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Access {
    /// `ro` or `const`.
    Read,
    /// `rw`, or less when the device does not let it be changed.
    Configure,
    /// `rw` and nothing less.
    ReadWrite,
    /// `wo`; a device may let it be read back.
    Write,
}

impl Access {
    /// Whether the standard allows a value to be `access`.
    pub(super) const fn allows(self, access: AccessType) -> bool {
        match self {
            Self::Read => !access.writable(),
            Self::Configure => access.readable(),
            Self::ReadWrite => access.readable() && access.writable(),
            Self::Write => access.writable(),
        }
    }

    /// As an EDS writes it best.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Read => "ro",
            Self::Configure | Self::ReadWrite => "rw",
            Self::Write => "wo",
        }
    }
}

/// What the standards say of the object at `index`.
pub(super) fn standard(index: u16) -> Option<&'static Standard> {
    let at = STANDARD.partition_point(|object| object.last < index);
    STANDARD.get(at).filter(|object| object.first <= index)
}

/// What the standards say of the value at `address`.
pub(super) fn field(address: Address) -> Option<Field> {
    standard(address.index)?.field(address.sub)
}

impl Standard {
    /// Whether a client sees no difference between this and an object of `code`: an array is as good as a record.
    pub(super) fn is_like(&self, code: ObjectCode) -> bool {
        has_sub_indices(self.code) == has_sub_indices(code)
    }

    pub(super) const fn has_sub_indices(&self) -> bool {
        has_sub_indices(self.code)
    }

    /// The value at `sub`; `None` when the standard leaves it open.
    pub(super) fn field(&self, sub: u8) -> Option<Field> {
        match (&self.fields, sub) {
            (_, 0) if self.has_sub_indices() => self.zero,
            (Fields::Any, _) => None,
            (Fields::Alike(field), _) => Some(*field),
            (Fields::Each(fields), sub) => fields.get(usize::from(sub).checked_sub(1)?).copied(),
        }
    }
}

const fn has_sub_indices(code: ObjectCode) -> bool {
    matches!(code, ObjectCode::Array | ObjectCode::Record | ObjectCode::DefStruct)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_objects_stand_in_the_order_of_their_index() {
        assert!(STANDARD.is_sorted_by(|one, other| one.first <= one.last && one.last < other.first));
        assert!(STANDARD.iter().all(|object| object.mandatory <= object.highest));
    }

    #[test]
    fn an_object_of_a_range_is_found_and_one_between_ranges_is_not() {
        let name = |index| standard(index).map(|object| object.name);
        assert_eq!(name(0x1423), Some("RPDO communication parameter"));
        assert_eq!(name(0x1FFF), Some("Object dispatching list"));
        assert_eq!([name(0x0FFF), name(0x101A), name(0x1C00)], [None; 3]);
    }

    #[test]
    fn each_sub_index_of_a_record_has_its_own_type() {
        let of = |index, sub| field(Address::new(index, sub)).and_then(|field| field.data_type);
        assert_eq!(of(0x1800, 0), Some(DataType::Unsigned8));
        assert_eq!(of(0x1800, 3), Some(DataType::Unsigned16));
        assert_eq!(of(0x1800, 7), None);
        assert_eq!(of(0x1017, 0), Some(DataType::Unsigned16));
        assert_eq!(of(0x1018, 4), Some(DataType::Unsigned32));
    }

    #[test]
    fn what_may_be_changed_may_also_be_fixed_unless_the_standard_says_more() {
        let allows = |index, access| field(Address::new(index, 0)).is_some_and(|field| field.access.allows(access));
        assert!(allows(0x1014, AccessType::Const) && allows(0x1014, AccessType::Rw));
        assert!(
            !allows(0x1017, AccessType::Const) && !allows(0x1000, AccessType::Rw) && !allows(0x1005, AccessType::Wo)
        );
    }
}
