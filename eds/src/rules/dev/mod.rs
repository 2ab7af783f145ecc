//! The device: what `[DeviceInfo]` says of it, held against the dictionary.

mod fixed_and_extended_object;
mod half_a_module_list;
mod hidden_dynamic_channels;
mod idle_compact_pdo;
mod incomplete_lss_address;
mod missing_bit_rate;
mod missing_boot_up_role;
mod oversized_granularity;
mod twice_described_object;
mod unequal_fixed_object;
mod unknown_bit_rate;
mod wrong_identity;
mod wrong_number_of_pdos;
mod wrong_pdo_count;
mod wrong_serial_number;

pub(super) use fixed_and_extended_object::FixedAndExtendedObject;
pub(super) use half_a_module_list::HalfAModuleList;
pub(super) use hidden_dynamic_channels::HiddenDynamicChannels;
pub(super) use idle_compact_pdo::IdleCompactPdo;
pub(super) use incomplete_lss_address::IncompleteLssAddress;
pub(super) use missing_bit_rate::MissingBitRate;
pub(super) use missing_boot_up_role::MissingBootUpRole;
pub(super) use oversized_granularity::OversizedGranularity;
pub(super) use twice_described_object::TwiceDescribedObject;
pub(super) use unequal_fixed_object::UnequalFixedObject;
pub(super) use unknown_bit_rate::UnknownBitRate;
pub(super) use wrong_identity::WrongIdentity;
pub(super) use wrong_number_of_pdos::WrongNumberOfPdos;
pub(super) use wrong_pdo_count::WrongPdoCount;
pub(super) use wrong_serial_number::WrongSerialNumber;
