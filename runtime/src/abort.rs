//! Why an access to the object dictionary was refused.

/// An SDO abort code (CiA 301, table 22). Any number may come from the bus, hence a newtype with constants.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct AbortCode(pub u32);

impl AbortCode {
    /// 0503 0000h: toggle bit not alternated.
    pub const TOGGLE_NOT_ALTERNATED: Self = Self(0x0503_0000);
    /// 0504 0000h: SDO protocol timed out.
    pub const TIMED_OUT: Self = Self(0x0504_0000);
    /// 0504 0001h: client/server command specifier not valid or unknown.
    pub const UNKNOWN_COMMAND: Self = Self(0x0504_0001);
    /// 0504 0002h: invalid block size (block transfer).
    pub const INVALID_BLOCK_SIZE: Self = Self(0x0504_0002);
    /// 0504 0003h: invalid sequence number (block transfer).
    pub const INVALID_SEQUENCE_NUMBER: Self = Self(0x0504_0003);
    /// 0504 0004h: CRC error (block transfer).
    pub const CRC_ERROR: Self = Self(0x0504_0004);
    /// 0504 0005h: out of memory.
    pub const OUT_OF_MEMORY: Self = Self(0x0504_0005);
    /// 0601 0000h: unsupported access to an object.
    pub const UNSUPPORTED_ACCESS: Self = Self(0x0601_0000);
    /// 0601 0001h: attempt to read a write-only object.
    pub const WRITE_ONLY: Self = Self(0x0601_0001);
    /// 0601 0002h: attempt to write a read-only object.
    pub const READ_ONLY: Self = Self(0x0601_0002);
    /// 0602 0000h: object does not exist in the object dictionary.
    pub const NO_SUCH_OBJECT: Self = Self(0x0602_0000);
    /// 0604 0041h: object cannot be mapped to the PDO.
    pub const NOT_MAPPABLE: Self = Self(0x0604_0041);
    /// 0604 0042h: the mapped objects would exceed the PDO's length.
    pub const PDO_TOO_LONG: Self = Self(0x0604_0042);
    /// 0604 0043h: general parameter incompatibility.
    pub const PARAMETER_INCOMPATIBLE: Self = Self(0x0604_0043);
    /// 0604 0047h: general internal incompatibility in the device.
    pub const INTERNAL_INCOMPATIBILITY: Self = Self(0x0604_0047);
    /// 0606 0000h: access failed due to a hardware error.
    pub const HARDWARE_ERROR: Self = Self(0x0606_0000);
    /// 0607 0010h: data type does not match, length does not match.
    pub const LENGTH_MISMATCH: Self = Self(0x0607_0010);
    /// 0607 0012h: data type does not match, length too high.
    pub const TOO_LONG: Self = Self(0x0607_0012);
    /// 0607 0013h: data type does not match, length too low.
    pub const TOO_SHORT: Self = Self(0x0607_0013);
    /// 0609 0011h: sub-index does not exist.
    pub const NO_SUCH_SUB_INDEX: Self = Self(0x0609_0011);
    /// 0609 0030h: invalid value for the parameter (download only).
    pub const INVALID_VALUE: Self = Self(0x0609_0030);
    /// 0609 0031h: value of the parameter written too high (download only).
    pub const VALUE_TOO_HIGH: Self = Self(0x0609_0031);
    /// 0609 0032h: value of the parameter written too low (download only).
    pub const VALUE_TOO_LOW: Self = Self(0x0609_0032);
    /// 0609 0036h: maximum value is less than minimum value.
    pub const MAXIMUM_BELOW_MINIMUM: Self = Self(0x0609_0036);
    /// 060A 0023h: resource not available: SDO connection.
    pub const NO_SDO_CONNECTION: Self = Self(0x060A_0023);
    /// 0800 0000h: general error.
    pub const GENERAL: Self = Self(0x0800_0000);
    /// 0800 0020h: data cannot be transferred or stored to the application.
    pub const NOT_STORED: Self = Self(0x0800_0020);
    /// 0800 0021h: data cannot be transferred or stored because of local control.
    pub const LOCAL_CONTROL: Self = Self(0x0800_0021);
    /// 0800 0022h: data cannot be transferred or stored because of the present device state.
    pub const DEVICE_STATE: Self = Self(0x0800_0022);
    /// 0800 0023h: dynamic generation of the object dictionary failed, or there is none.
    pub const NO_DICTIONARY: Self = Self(0x0800_0023);
    /// 0800 0024h: no data available.
    pub const NO_DATA: Self = Self(0x0800_0024);
}

impl core::fmt::Debug for AbortCode {
    /// `AbortCode(0602_0000h)`, grouped as the standard prints it.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "AbortCode({:04X}_{:04X}h)", self.0 >> 16, self.0 & 0xFFFF)
    }
}
