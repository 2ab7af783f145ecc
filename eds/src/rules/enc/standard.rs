//! The objects of CiA 406: what kind of object each is, of which types its values are, and who must have it.
//!
//! Sources: the text of V2.0 (chapter 8); of V3.0 and V3.1 what their histories say (6005h:03 and :04, 6008h, 6009h, 6040h, 6050h,
//! 650Ch and 6510h are new, the values of 6010h are INTEGER32); two encoders of V3.2. Where these differ all of them are accepted;
//! what they leave open nobody is held to. Of V4.x we have no text.

use crate::ir::{DataType, ObjectCode};

/// What CiA 406 says of an object, or of all in a range.
pub(super) struct Standard {
    first: u16,
    last: u16,
    pub(super) name: &'static str,
    shape: Shape,
    /// The types that a value may have, the usual one first; none when it is open.
    pub(super) types: &'static [DataType],
    pub(super) access: Access,
    pub(super) mapping: Mapping,
    demand: Demand,
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Single,
    /// The values start at sub-index 1.
    Several,
    Open,
}

/// What a client may do with a value.
#[derive(Clone, Copy)]
pub(super) enum Access {
    /// It is measured, or tells of the device.
    ReadOnly,
    /// It is a setting.
    Writable,
    Open,
}

/// Whether a PDO may hold a value.
#[derive(Clone, Copy)]
pub(super) enum Mapping {
    Possible,
    Impossible,
    Open,
}

/// Which encoders must have an object.
#[derive(Clone, Copy)]
enum Demand {
    Optional,
    OfClass(Class, Kind),
}

/// A device class (CiA 406, chapter 5).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Class {
    /// The position and what it is measured in.
    C1,
    /// Also scaling, preset and diagnostics.
    C2,
}

/// Which encoders an object is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Any,
    Rotary,
    Linear,
    /// One sensor, rotary or linear.
    Single,
    /// Several sensors.
    Multiple,
}

/// The objects of the profile, of one module (6000h to 67FFh).
pub(super) fn standards() -> &'static [Standard] {
    STANDARD
}

/// What CiA 406 says of the object at `index`.
pub(super) fn standard(index: u16) -> Option<&'static Standard> {
    let at = STANDARD.partition_point(|object| object.last < index);
    STANDARD.get(at).filter(|object| object.first <= index)
}

impl Standard {
    /// The object's index; the first of a range.
    pub(super) const fn index(&self) -> u16 {
        self.first
    }

    /// Whether an object of `code` may stand for it: an array is as good as a record.
    pub(super) fn may_be(&self, code: ObjectCode) -> bool {
        let several = matches!(code, ObjectCode::Array | ObjectCode::Record | ObjectCode::DefStruct);
        match self.shape {
            Shape::Single => !several,
            Shape::Several => several,
            Shape::Open => true,
        }
    }

    /// As a message says it: `a single value`.
    pub(super) const fn shape(&self) -> &'static str {
        match self.shape {
            Shape::Single => "a single value",
            Shape::Several => "an array",
            Shape::Open => "a single value or an array",
        }
    }

    /// The lowest class whose encoders of `kind` must have it.
    pub(super) fn demanded_of(&self, kind: Kind) -> Option<Class> {
        let Demand::OfClass(class, of) = self.demand else {
            return None;
        };
        let one_sensor = of == Kind::Single && matches!(kind, Kind::Rotary | Kind::Linear);
        (of == Kind::Any || of == kind || one_sensor).then_some(class)
    }
}

const U8: &[DataType] = &[DataType::Unsigned8];
const U16: &[DataType] = &[DataType::Unsigned16];
const U32: &[DataType] = &[DataType::Unsigned32];
const U64: &[DataType] = &[DataType::Unsigned64];
const I16: &[DataType] = &[DataType::Integer16];
const I32: &[DataType] = &[DataType::Integer32];
/// UNSIGNED32 in V2.0, INTEGER32 from V3.1 on.
const I32_OR_U32: &[DataType] = &[DataType::Integer32, DataType::Unsigned32];
/// UNSIGNED16 in V2.0, UNSIGNED32 on an encoder of V3.2.
const U16_OR_U32: &[DataType] = &[DataType::Unsigned16, DataType::Unsigned32];
const OPEN: &[DataType] = &[];

const fn object(first: u16, last: u16, name: &'static str, shape: Shape, types: &'static [DataType]) -> Standard {
    Standard {
        first,
        last,
        name,
        shape,
        types,
        access: Access::Open,
        mapping: Mapping::Impossible,
        demand: Demand::Optional,
    }
}

const fn var(index: u16, name: &'static str, types: &'static [DataType]) -> Standard {
    object(index, index, name, Shape::Single, types)
}

const fn array(index: u16, name: &'static str, types: &'static [DataType]) -> Standard {
    object(index, index, name, Shape::Several, types)
}

/// The same of cam 1 to cam 8.
const fn cams(first: u16, name: &'static str, types: &'static [DataType]) -> Standard {
    object(first, first + 7, name, Shape::Several, types).rw()
}

impl Standard {
    const fn ro(mut self) -> Self {
        self.access = Access::ReadOnly;
        self
    }

    const fn rw(mut self) -> Self {
        self.access = Access::Writable;
        self
    }

    const fn mappable(mut self, mapping: Mapping) -> Self {
        self.mapping = mapping;
        self
    }

    const fn of(mut self, class: Class, kind: Kind) -> Self {
        self.demand = Demand::OfClass(class, kind);
        self
    }
}

/// CiA 406 V2.0, chapter 8, and the later objects that we know of, by index.
///
/// Where the overview of V2.0 calls an object mandatory and the text says no class (6000h, 6500h, 6503h to 6506h), it is demanded
/// of C2, which has all that C1 has. 6001h and 6502h mean something for rotary encoders only; 6005h, 6010h, 6020h and 6030h are
/// mandatory for the encoders that the text names; 6003h and 6004h give way to 6010h and 6020h where there are several sensors.
static STANDARD: &[Standard] = &{
    use Class::{C1, C2};
    use Kind::{Any, Linear, Multiple, Rotary, Single};
    use Mapping::{Open, Possible};
    [
        var(0x6000, "Operating parameters", U16).rw().of(C2, Any),
        var(0x6001, "Measuring units per revolution", U32).rw().of(C2, Rotary),
        var(0x6002, "Total measuring range in measuring units", U32)
            .rw()
            .of(C2, Any),
        var(0x6003, "Preset value", U32).rw().of(C2, Single),
        var(0x6004, "Position value", U32)
            .ro()
            .mappable(Possible)
            .of(C1, Single),
        array(0x6005, "Linear encoder measuring step settings", U32)
            .rw()
            .of(C2, Linear),
        var(0x6008, "High precision position value", U64)
            .ro()
            .mappable(Possible),
        var(0x6009, "High precision preset value", U64).rw(),
        object(0x600C, 0x600C, "Position raw value", Shape::Open, OPEN)
            .ro()
            .mappable(Open),
        array(0x6010, "Preset values for multi-sensor devices", I32_OR_U32)
            .rw()
            .of(C2, Multiple),
        // ro in the overview, rw in the text.
        array(0x6020, "Position values for multi-sensor devices", I32)
            .mappable(Possible)
            .of(C1, Multiple),
        array(0x6030, "Speed value", I16)
            .ro()
            .mappable(Possible)
            .of(C2, Multiple),
        object(0x6031, 0x6031, "Speed parameters", Shape::Open, OPEN).mappable(Open),
        array(0x6040, "Acceleration value", I16).ro().mappable(Possible),
        array(0x6050, "Jerk value", I16).ro().mappable(Possible),
        var(0x6200, "Cyclic timer", U16).rw().of(C2, Any),
        array(0x6300, "Cam state register", U8).ro().mappable(Possible),
        // Mappable in V2.0, not so on an encoder of V3.2.
        array(0x6301, "Cam enable register", U8).rw().mappable(Open),
        array(0x6302, "Cam polarity register", U8).rw().mappable(Open),
        cams(0x6310, "Cam low limit", I32),
        cams(0x6320, "Cam high limit", I32),
        cams(0x6330, "Cam hysteresis", U16_OR_U32),
        array(0x6400, "Area state register", U8).ro().mappable(Possible),
        array(0x6401, "Work area low limit", I32).rw(),
        array(0x6402, "Work area high limit", I32).rw(),
        var(0x6500, "Operating status", U16).ro().of(C2, Any),
        var(0x6501, "Single-turn resolution or measuring step", U32)
            .ro()
            .of(C1, Any),
        var(0x6502, "Number of distinguishable revolutions", U16)
            .ro()
            .of(C1, Rotary),
        // Not mappable in V2.0, mappable on encoders of V3.2.
        var(0x6503, "Alarms", U16).ro().mappable(Open).of(C2, Any),
        var(0x6504, "Supported alarms", U16).ro().of(C2, Any),
        var(0x6505, "Warnings", U16).ro().mappable(Open).of(C2, Any),
        var(0x6506, "Supported warnings", U16).ro().of(C2, Any),
        var(0x6507, "Profile and software version", U32).ro().of(C2, Any),
        var(0x6508, "Operating time", U32).ro().of(C2, Any),
        var(0x6509, "Offset value", I32).ro().of(C2, Any),
        array(0x650A, "Module identification", I32).ro().of(C2, Any),
        // A single value in V2.0, an array on an encoder of V3.2.
        object(0x650B, 0x650B, "Serial number", Shape::Open, U32)
            .ro()
            .of(C2, Any),
        array(0x650C, "Offset values for multi-sensor devices", I32).ro(),
        object(0x650D, 0x650D, "Absolute accuracy", Shape::Open, OPEN).ro(),
        var(0x650E, "Device functionality", U32).ro(),
        // UNSIGNED40 on one encoder of V3.2, UNSIGNED64 on another.
        object(
            0x6510,
            0x6510,
            "Number of high precision revolutions",
            Shape::Single,
            OPEN,
        )
        .ro(),
    ]
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_objects_stand_in_the_order_of_their_index() {
        assert!(STANDARD.is_sorted_by(|one, other| one.first <= one.last && one.last < other.first));
    }

    #[test]
    fn a_cam_is_found_and_what_lies_between_cams_is_not() {
        assert_eq!(standard(0x6327).map(|object| object.name), Some("Cam high limit"));
        assert!(standard(0x6328).is_none() && standard(0x5FFF).is_none() && standard(0x6511).is_none());
    }

    #[test]
    fn an_object_is_demanded_of_the_encoders_that_it_is_for() {
        let class = |index, kind| standard(index).and_then(|object| object.demanded_of(kind));
        assert_eq!(class(0x6004, Kind::Linear), Some(Class::C1));
        assert_eq!(class(0x6004, Kind::Multiple), None);
        assert_eq!(class(0x6501, Kind::Multiple), Some(Class::C1));
        assert_eq!(class(0x6502, Kind::Linear), None);
        assert_eq!(class(0x6300, Kind::Rotary), None);
    }
}
