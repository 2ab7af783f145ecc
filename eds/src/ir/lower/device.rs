//! The sections that are not objects.

use super::entry::text;
use crate::ir::{BaudRates, Commissioning, DataType, DeviceInfo, FileInfo, NodeId};
use crate::model::{self, Eds};
use crate::span::Spanned;

pub(super) fn file(eds: &Eds) -> FileInfo {
    let Some(info) = &eds.file_info else {
        return FileInfo::default();
    };
    FileInfo {
        file_name: text(info.file_name.as_ref()),
        file_version: number(info.file_version),
        file_revision: number(info.file_revision),
        eds_version: eds_version(info),
        description: text(info.description.as_ref()),
    }
}

/// EDSVersion; a file without it is of version 3.0 (CiA 306-1, table 1).
fn eds_version(info: &model::FileInfo) -> String {
    let stated = text(info.eds_version.as_ref());
    if stated.is_empty() { "3.0".to_owned() } else { stated }
}

pub(super) fn device(eds: &Eds) -> DeviceInfo {
    let Some(info) = &eds.device_info else {
        return DeviceInfo::default();
    };
    DeviceInfo {
        vendor_name: text(info.vendor_name.as_ref()),
        vendor_number: optional(info.vendor_number),
        product_name: text(info.product_name.as_ref()),
        product_number: optional(info.product_number),
        revision_number: optional(info.revision_number),
        order_code: text(info.order_code.as_ref()),
        baud_rates: baud_rates(info),
        simple_boot_up_master: number(info.simple_boot_up_master),
        simple_boot_up_slave: number(info.simple_boot_up_slave),
        granularity: number(info.granularity),
        dynamic_channels_supported: number(info.dynamic_channels_supported),
        group_messaging: number(info.group_messaging),
        nr_of_rx_pdo: optional(info.nr_of_rx_pdo),
        nr_of_tx_pdo: optional(info.nr_of_tx_pdo),
        lss_supported: number(info.lss_supported),
        lss_serial_number: optional(info.lss_serial_number),
        ng_slave: number(info.ng_slave),
        compact_pdo: number(info.compact_pdo),
    }
}

pub(super) fn commissioning(eds: &Eds) -> Option<Commissioning> {
    let commissioning = eds.commissioning.as_ref()?;
    Some(Commissioning {
        node_id: optional(commissioning.node_id).and_then(NodeId::new),
        node_name: text(commissioning.node_name.as_ref()),
        baud_rate: optional(commissioning.baud_rate),
        net_number: optional(commissioning.net_number),
        network_name: text(commissioning.network_name.as_ref()),
        canopen_manager: number(commissioning.canopen_manager),
        lss_serial_number: optional(commissioning.lss_serial_number),
    })
}

/// The used types, each once, in the order of their index.
pub(super) fn dummies(eds: &Eds) -> Vec<DataType> {
    let usage = eds.dummy_usage.iter().flat_map(|usage| &usage.types);
    let used = usage.filter(|used| used.used.value);
    let mut dummies: Vec<DataType> = used.filter_map(|used| DataType::from_index(used.data_type)).collect();
    dummies.sort_by_key(|data_type| data_type.index());
    dummies.dedup();
    dummies
}

fn baud_rates(info: &model::DeviceInfo) -> BaudRates {
    let supported = info.baud_rates.iter().filter(|rate| rate.supported.value);
    let mut rates: Vec<u16> = supported.map(|rate| rate.rate).collect();
    rates.sort_unstable();
    rates.dedup();
    BaudRates(rates)
}

fn optional<T: Copy>(value: Option<Spanned<T>>) -> Option<T> {
    value.map(|value| value.value)
}

fn number<T: Copy + Default>(value: Option<Spanned<T>>) -> T {
    optional(value).unwrap_or_default()
}
