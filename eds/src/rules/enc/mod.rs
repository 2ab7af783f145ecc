//! Encoders (CiA 406): heard when 1000h names profile 406, or when the caller does.

mod encoder;
mod incomplete_class;
mod missing_encoder_object;
mod standard;
mod unknown_encoder_type;
mod wrong_encoder_access;
mod wrong_encoder_code;
mod wrong_encoder_mapping;
mod wrong_encoder_type;

pub(crate) use encoder::Encoder;
pub(super) use incomplete_class::IncompleteClass;
pub(super) use missing_encoder_object::MissingEncoderObject;
pub(super) use unknown_encoder_type::UnknownEncoderType;
pub(super) use wrong_encoder_access::WrongEncoderAccess;
pub(super) use wrong_encoder_code::WrongEncoderCode;
pub(super) use wrong_encoder_mapping::WrongEncoderMapping;
pub(super) use wrong_encoder_type::WrongEncoderType;
