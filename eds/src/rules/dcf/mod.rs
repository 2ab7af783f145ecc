//! Configured devices: what a DCF adds to an EDS.

mod absolute_path;
mod bit_rates;
mod changed_constant_parameter;
mod commissioned_eds;
mod contrary_file;
mod file_entries;
mod file_for_value;
mod files;
mod impossible_net_number;
mod impossible_node_id;
mod incomplete_commissioning;
mod missing_commissioning;
mod missing_last_eds;
mod unknown_bit_rate;
mod unsupported_bit_rate;

pub(super) use absolute_path::AbsolutePath;
pub(super) use changed_constant_parameter::ChangedConstantParameter;
pub(super) use commissioned_eds::CommissionedEds;
pub(super) use contrary_file::ContraryFile;
pub(super) use file_for_value::FileForValue;
pub(super) use impossible_net_number::ImpossibleNetNumber;
pub(super) use impossible_node_id::ImpossibleNodeId;
pub(super) use incomplete_commissioning::IncompleteCommissioning;
pub(super) use missing_commissioning::MissingCommissioning;
pub(super) use missing_last_eds::MissingLastEds;
pub(super) use unknown_bit_rate::UnknownBitRate;
pub(super) use unsupported_bit_rate::UnsupportedBitRate;
