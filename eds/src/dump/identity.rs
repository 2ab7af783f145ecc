//! Who a device says it is.

/// The device type and the identity object; `None` for what the device does not tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// 1000h: device profile number in the low half, additional information in the high half.
    pub device_type: Option<u32>,
    /// 1018h:01: Vendor-ID
    pub vendor_id: Option<u32>,
    /// 1018h:02: Product code
    pub product_code: Option<u32>,
    /// 1018h:03: Revision number
    pub revision_number: Option<u32>,
    /// 1018h:04: Serial number
    pub serial_number: Option<u32>,
}
