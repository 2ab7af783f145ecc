//! `[DeviceInfo]` (CiA 306-1, 4.4.2).

use super::Problem;
use super::field::{Fields, first};
use crate::document::{Entry, Keyword, Section};
use crate::span::{Span, Spanned};

/// `[DeviceInfo]`: about the device.
#[derive(Clone, Debug, Default)]
pub struct DeviceInfo {
    /// The section's header.
    pub header: Span,
    /// VendorName
    pub vendor_name: Option<Spanned<String>>,
    /// VendorNumber: 1018h sub 1.
    pub vendor_number: Option<Spanned<u32>>,
    /// ProductName
    pub product_name: Option<Spanned<String>>,
    /// ProductNumber: 1018h sub 2.
    pub product_number: Option<Spanned<u32>>,
    /// RevisionNumber: 1018h sub 3.
    pub revision_number: Option<Spanned<u32>>,
    /// OrderCode
    pub order_code: Option<Spanned<String>>,
    /// `BaudRate_xxx`, in the order of the file.
    pub baud_rates: Vec<BaudRate>,
    /// SimpleBootUpMaster
    pub simple_boot_up_master: Option<Spanned<bool>>,
    /// SimpleBootUpSlave
    pub simple_boot_up_slave: Option<Spanned<bool>>,
    /// Granularity of a PDO mapping in bits.
    pub granularity: Option<Spanned<u8>>,
    /// DynamicChannelsSupported
    pub dynamic_channels_supported: Option<Spanned<u32>>,
    /// GroupMessaging
    pub group_messaging: Option<Spanned<bool>>,
    /// NrOfRXPDO
    pub nr_of_rx_pdo: Option<Spanned<u16>>,
    /// NrOfTXPDO
    pub nr_of_tx_pdo: Option<Spanned<u16>>,
    /// LSS_Supported
    pub lss_supported: Option<Spanned<bool>>,
    /// LSS_Master
    pub lss_master: Option<Spanned<bool>>,
    /// BaudRate_auto: the device finds out the bit rate.
    pub baud_rate_auto: Option<Spanned<bool>>,
    /// CANopenSafetySupported (EN 50325-5)
    pub canopen_safety_supported: Option<Spanned<bool>>,
    /// LSS_SerialNumber: 1018h sub 4.
    pub lss_serial_number: Option<Spanned<u32>>,
    /// CompactPDO: a bit for each sub-index of the communication parameters that have no section.
    pub compact_pdo: Option<Spanned<u8>>,
    /// NG_Slave: node guarding as NMT slave.
    pub ng_slave: Option<Spanned<bool>>,
    /// NG_Master: node guarding as NMT master.
    pub ng_master: Option<Spanned<bool>>,
    /// NrOfNG_MonitoredNodes
    pub nr_of_ng_monitored_nodes: Option<Spanned<u8>>,
}

/// `BaudRate_500=1`
#[derive(Clone, Copy, Debug)]
pub struct BaudRate {
    /// In kbit/s.
    pub rate: u16,
    /// The keyword.
    pub key: Span,
    /// Whether the device knows it.
    pub supported: Spanned<bool>,
}

pub(super) fn read(fields: &mut Fields<'_>, section: &Section) -> DeviceInfo {
    let mut info = DeviceInfo {
        header: section.header,
        ..DeviceInfo::default()
    };
    for entry in &section.entries {
        read_product(fields, entry, &mut info);
    }
    info
}

/// What the device is.
fn read_product(fields: &mut Fields<'_>, entry: &Entry, info: &mut DeviceInfo) {
    match entry.keyword {
        Keyword::VendorName => first(&mut info.vendor_name, fields.text(entry)),
        Keyword::VendorNumber => first(&mut info.vendor_number, fields.number(entry)),
        Keyword::ProductName => first(&mut info.product_name, fields.text(entry)),
        Keyword::ProductNumber => first(&mut info.product_number, fields.number(entry)),
        Keyword::RevisionNumber => first(&mut info.revision_number, fields.number(entry)),
        Keyword::OrderCode => first(&mut info.order_code, fields.text(entry)),
        Keyword::LssSerialNumber => first(&mut info.lss_serial_number, fields.number(entry)),
        _ => read_ability(fields, entry, info),
    }
}

/// What the device can do.
fn read_ability(fields: &mut Fields<'_>, entry: &Entry, info: &mut DeviceInfo) {
    match entry.keyword {
        Keyword::BaudRate(rate) => info.baud_rates.extend(fields.flag(entry).map(|supported| BaudRate {
            rate,
            key: entry.key,
            supported,
        })),
        Keyword::SimpleBootUpMaster => first(&mut info.simple_boot_up_master, fields.flag(entry)),
        Keyword::SimpleBootUpSlave => first(&mut info.simple_boot_up_slave, fields.flag(entry)),
        Keyword::Granularity => first(&mut info.granularity, fields.number(entry)),
        Keyword::DynamicChannelsSupported => first(&mut info.dynamic_channels_supported, fields.number(entry)),
        Keyword::GroupMessaging => first(&mut info.group_messaging, fields.flag(entry)),
        Keyword::NrOfRxPdo => first(&mut info.nr_of_rx_pdo, fields.number(entry)),
        Keyword::NrOfTxPdo => first(&mut info.nr_of_tx_pdo, fields.number(entry)),
        Keyword::LssSupported => first(&mut info.lss_supported, fields.flag(entry)),
        Keyword::LssMaster => first(&mut info.lss_master, fields.flag(entry)),
        Keyword::BaudRateAuto => first(&mut info.baud_rate_auto, fields.flag(entry)),
        Keyword::CanopenSafetySupported => first(&mut info.canopen_safety_supported, fields.flag(entry)),
        Keyword::CompactPdo => first(&mut info.compact_pdo, fields.number(entry)),
        Keyword::NgSlave => first(&mut info.ng_slave, fields.flag(entry)),
        Keyword::NgMaster => first(&mut info.ng_master, fields.flag(entry)),
        Keyword::NrOfNgMonitoredNodes => first(&mut info.nr_of_ng_monitored_nodes, fields.number(entry)),
        keyword if is_legacy(keyword) => fields.problems.push(Problem::LegacyKeyword { keyword, at: entry.key }),
        _ => fields.misplaced(entry),
    }
}

const fn is_legacy(keyword: Keyword) -> bool {
    matches!(
        keyword,
        Keyword::ProductVersion
            | Keyword::ProductRevision
            | Keyword::ExtendedBootUpMaster
            | Keyword::ExtendedBootUpSlave
            | Keyword::LmtManufacturerName
            | Keyword::LmtProductName
    )
}
