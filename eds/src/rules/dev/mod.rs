//! The device: what `[DeviceInfo]` says of it, held against the dictionary.

mod incomplete_lss_address;
mod wrong_identity;
mod wrong_number_of_pdos;
mod wrong_pdo_count;
mod wrong_serial_number;

pub(super) use incomplete_lss_address::IncompleteLssAddress;
pub(super) use wrong_identity::WrongIdentity;
pub(super) use wrong_number_of_pdos::WrongNumberOfPdos;
pub(super) use wrong_pdo_count::WrongPdoCount;
pub(super) use wrong_serial_number::WrongSerialNumber;
