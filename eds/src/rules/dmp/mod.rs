//! The device: what it answers against its file.
//!
//! Each difference is one finding: a value of which several rules could say something is left to the one that says most.

mod answers;
mod changed_constant;
mod changed_default;
mod cob_id_of_another_node;
mod difference;
mod failed_read;
mod impossible_mapping;
mod missing_object;
mod mixed_devices;
mod readable_write_only;
mod shown;
mod silent_object;
mod unapplied_parameter;
mod undeclared_object;
mod unprintable_string;
mod unread_object;
mod unreadable_object;
mod value_beyond_limits;
mod wrong_abort_code;
mod wrong_highest_sub_index;
mod wrong_identity;
mod wrong_length;
mod wrong_sdo_cob_id;

pub(super) use changed_constant::ChangedConstant;
pub(super) use changed_default::ChangedDefault;
pub(super) use cob_id_of_another_node::CobIdOfAnotherNode;
pub(super) use failed_read::FailedRead;
pub(super) use impossible_mapping::ImpossibleMapping;
pub(super) use missing_object::MissingObject;
pub(super) use mixed_devices::MixedDevices;
pub(super) use readable_write_only::ReadableWriteOnly;
pub(super) use silent_object::SilentObject;
pub(super) use unapplied_parameter::UnappliedParameter;
pub(super) use undeclared_object::UndeclaredObject;
pub(super) use unprintable_string::UnprintableString;
pub(super) use unread_object::UnreadObject;
pub(super) use unreadable_object::UnreadableObject;
pub(super) use value_beyond_limits::ValueBeyondLimits;
pub(super) use wrong_abort_code::WrongAbortCode;
pub(super) use wrong_highest_sub_index::WrongHighestSubIndex;
pub(super) use wrong_identity::WrongIdentity;
pub(super) use wrong_length::WrongLength;
pub(super) use wrong_sdo_cob_id::WrongSdoCobId;
