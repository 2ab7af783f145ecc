//! Emergency messages (CiA 301, 7.2.7.3): eight bytes from a node that has an error, on the CAN-ID that 1014h says.
//!
//! ```text
//! 081#00 30 05 01 02 03 04 05     node 1: error code 3000h (voltage), error register 05h, five bytes of the manufacturer's
//! 081#00 00 00 00 00 00 00 00     error reset: nothing is wrong any more
//! ```

/// What an emergency message says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Emergency {
    /// The error code: class in the high byte (CiA 301, table 26), detail in the low byte; 0000h says that an error is gone.
    pub code: u16,
    /// Bits of the error register (1001h): 0 generic, 1 current, 2 voltage, 3 temperature, 4 communication, 5 of the
    /// device profile, 7 of the manufacturer.
    pub register: u8,
    /// Of the manufacturer's own meaning.
    pub manufacturer: [u8; 5],
}

impl Emergency {
    /// 0000h: an error is gone.
    pub const ERROR_RESET: u16 = 0x0000;
    /// 8110h: frames were lost, because they came faster than they were taken.
    pub const CAN_OVERRUN: u16 = 0x8110;
    /// 8120h: the CAN controller is error passive.
    pub const CAN_PASSIVE: u16 = 0x8120;
    /// 8130h: a heartbeat that is watched, or node guarding, has ceased.
    pub const LIFE_GUARD: u16 = 0x8130;
    /// 8140h: the node was off the bus, and is back.
    pub const BUS_OFF_RECOVERED: u16 = 0x8140;
    /// 8210h: an RPDO was not processed, because it was too short.
    pub const PDO_LENGTH_ERROR: u16 = 0x8210;
    /// 8240h: a SYNC message had another length than 1019h asks for.
    pub const UNEXPECTED_SYNC_LENGTH: u16 = 0x8240;
    /// 8250h: an RPDO did not come within its event timer.
    pub const RPDO_TIMEOUT: u16 = 0x8250;
    /// Bit 4 of the error register: communication.
    pub const COMMUNICATION: u8 = 0x10;

    /// The emergency `code` with these bits of the error register, and with 0 in the manufacturer's bytes.
    #[must_use]
    pub const fn new(code: u16, register: u8) -> Self {
        Self {
            code,
            register,
            manufacturer: [0; 5],
        }
    }

    /// The same with these bytes of the manufacturer.
    #[must_use]
    pub const fn with(self, manufacturer: [u8; 5]) -> Self {
        Self { manufacturer, ..self }
    }

    /// What eight bytes say.
    #[must_use]
    pub const fn parse(bytes: [u8; 8]) -> Self {
        let [c0, c1, register, m0, m1, m2, m3, m4] = bytes;
        Self {
            code: u16::from_le_bytes([c0, c1]),
            register,
            manufacturer: [m0, m1, m2, m3, m4],
        }
    }

    /// The eight bytes.
    #[must_use]
    pub const fn emit(self) -> [u8; 8] {
        let [c0, c1] = self.code.to_le_bytes();
        let [m0, m1, m2, m3, m4] = self.manufacturer;
        [c0, c1, self.register, m0, m1, m2, m3, m4]
    }
}

#[cfg(test)]
mod tests {
    use super::Emergency;

    #[test]
    fn what_is_emitted_is_parsed_again() {
        let emergency = Emergency::new(0x3000, 0x05).with([1, 2, 3, 4, 5]);
        assert_eq!(emergency.emit(), [0x00, 0x30, 0x05, 1, 2, 3, 4, 5]);
        assert_eq!(Emergency::parse(emergency.emit()), emergency);
    }
}
