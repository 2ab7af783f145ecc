//! Facts about the file and the device that are not objects.

use super::NodeId;

/// `[FileInfo]` (CiA 306-1, 4.4.1), as far as a back end needs it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FileInfo {
    /// FileName
    pub file_name: String,
    /// FileVersion
    pub file_version: u32,
    /// FileRevision
    pub file_revision: u32,
    /// EDSVersion, `4.0`; `3.0` when the file does not say
    pub eds_version: String,
    /// Description
    pub description: String,
}

/// The bit rates that a device knows, of `BaudRate_xxx`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BaudRates(pub Vec<u16>);

/// `[DeviceInfo]` (CiA 306-1, 4.4.2).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceInfo {
    /// VendorName
    pub vendor_name: String,
    /// VendorNumber: 1018h:01
    pub vendor_number: Option<u32>,
    /// ProductName
    pub product_name: String,
    /// ProductNumber: 1018h:02
    pub product_number: Option<u32>,
    /// RevisionNumber: 1018h:03
    pub revision_number: Option<u32>,
    /// OrderCode
    pub order_code: String,
    /// `BaudRate_xxx=1`, in kbit/s, ascending.
    pub baud_rates: BaudRates,
    /// SimpleBootUpMaster
    pub simple_boot_up_master: bool,
    /// SimpleBootUpSlave
    pub simple_boot_up_slave: bool,
    /// Granularity of a PDO mapping in bits, 0 to 64; 0: no mapping can be changed.
    pub granularity: u8,
    /// DynamicChannelsSupported
    pub dynamic_channels_supported: u32,
    /// GroupMessaging: multiplexed PDOs.
    pub group_messaging: bool,
    /// NrOfRXPDO
    pub nr_of_rx_pdo: Option<u16>,
    /// NrOfTXPDO
    pub nr_of_tx_pdo: Option<u16>,
    /// LSS_Supported
    pub lss_supported: bool,
    /// LSS_SerialNumber: 1018h:04
    pub lss_serial_number: Option<u32>,
    /// NG_Slave: node guarding
    pub ng_slave: bool,
    /// CompactPDO: the sub-indices that a PDO communication record without own section has, a bit each.
    pub compact_pdo: u8,
}

/// `[DeviceComissioning]` of a DCF (CiA 306-1, 5.3).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Commissioning {
    /// NodeID
    pub node_id: Option<NodeId>,
    /// NodeName
    pub node_name: String,
    /// Baudrate in kbit/s
    pub baud_rate: Option<u16>,
    /// NetNumber
    pub net_number: Option<u32>,
    /// NetworkName
    pub network_name: String,
    /// CANopenManager
    pub canopen_manager: bool,
    /// LSS_SerialNumber: 1018h:04
    pub lss_serial_number: Option<u32>,
}
