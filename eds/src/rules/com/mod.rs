//! The communication objects of CiA 301.

mod cob_ids;
mod duplicate_cob_id;
mod missing_mandatory_object;
mod restricted_can_id;
mod standard;
mod writable_standard_object;
mod wrong_highest_sub_index;
mod wrong_standard_code;
mod wrong_standard_type;

pub(super) use duplicate_cob_id::DuplicateCobId;
pub(super) use missing_mandatory_object::MissingMandatoryObject;
pub(super) use restricted_can_id::RestrictedCanId;
pub(super) use writable_standard_object::WritableStandardObject;
pub(super) use wrong_highest_sub_index::WrongHighestSubIndex;
pub(super) use wrong_standard_code::WrongStandardCode;
pub(super) use wrong_standard_type::WrongStandardType;
