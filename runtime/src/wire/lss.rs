//! LSS messages (CiA 305, clause 6): always eight bytes, the first one says which service.
//!
//! ```text
//! 7E5#0401000000000000   switch state global: configuration      no answer
//! 7E5#1155000000000000   configure node-ID 85                    7E4#1100000000000000
//! 7E5#5E00000000000000   inquire node-ID                         7E4#5E04000000000000
//! ```

/// What an LSS master asks for, on [`CanId::LSS_REQUEST`](super::CanId::LSS_REQUEST).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Request {
    /// 04h: switch state global; mode 0 for waiting, 1 for configuration.
    SwitchGlobal(u8),
    /// 40h to 43h: switch state selective: a part of the LSS address, to be equal.
    SwitchSelective(Part, u32),
    /// 11h: configure node-ID, 1 to 127, or 255 for none.
    ConfigureNodeId(u8),
    /// 13h: configure bit timing parameters.
    ConfigureBitTiming {
        /// 0 for the table of CiA 305.
        table: u8,
        /// The row of it.
        index: u8,
    },
    /// 15h: activate bit timing parameters, with a switch delay in ms.
    ActivateBitTiming(u16),
    /// 17h: store configuration.
    Store,
    /// 46h to 4Bh: identify remote slave: a bound of the LSS address.
    Identify(Bound, u32),
    /// 4Ch: identify non-configured remote slave.
    IdentifyNonConfigured,
    /// 51h: fastscan.
    FastScan(FastScan),
    /// 5Ah to 5Dh: inquire a part of the LSS address.
    Inquire(Part),
    /// 5Eh: inquire node-ID.
    InquireNodeId,
}

/// A part of the LSS address: a sub-index of the identity object (1018h).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Part {
    /// 1018h:01
    VendorId,
    /// 1018h:02
    ProductCode,
    /// 1018h:03
    RevisionNumber,
    /// 1018h:04
    SerialNumber,
}

/// What a part of the LSS address is held against to identify a slave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Bound {
    /// The vendor-ID is to be this.
    VendorId,
    /// The product code is to be this.
    ProductCode,
    /// The revision number is to be this or higher.
    RevisionLow,
    /// The revision number is to be this or lower.
    RevisionHigh,
    /// The serial number is to be this or higher.
    SerialLow,
    /// The serial number is to be this or lower.
    SerialHigh,
}

/// One question of a fastscan (CiA 305, 6.5.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FastScan {
    /// The number that the part of the LSS address is held against.
    pub id_number: u32,
    /// From which bit on upwards it is, 0 to 31; 128 asks every slave, and starts a scan.
    pub bit_check: u8,
    /// Which part it is, 0 for the vendor-ID to 3.
    pub sub: u8,
    /// Which part is next.
    pub next: u8,
}

impl FastScan {
    /// [`FastScan::bit_check`] of the question that starts a scan.
    pub const START: u8 = 128;
}

/// What an LSS slave answers, on [`CanId::LSS_RESPONSE`](super::CanId::LSS_RESPONSE).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Response {
    /// 44h: this slave is the selected one, and in configuration state.
    Selected,
    /// 11h: configure node-ID, its error code: 0 done, 1 out of range.
    NodeIdConfigured(u8),
    /// 13h: configure bit timing parameters, its error code: 0 done, 1 not supported.
    BitTimingConfigured(u8),
    /// 17h: store configuration, its error code: 0 done, 1 not supported, 2 storage access error.
    Stored(u8),
    /// 4Fh: this slave is identified, or answers a fastscan.
    Identified,
    /// 50h: this slave has no node-ID.
    NonConfigured,
    /// 5Ah to 5Dh: a part of the LSS address.
    Identity(Part, u32),
    /// 5Eh: the node-ID, 255 for none.
    NodeId(u8),
}

impl Part {
    /// All, in the order of their numbers.
    pub const ALL: [Self; 4] = [
        Self::VendorId,
        Self::ProductCode,
        Self::RevisionNumber,
        Self::SerialNumber,
    ];

    /// Its number, 0 to 3.
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8
    }

    /// The part with this number; higher bits than the two lowest are ignored.
    #[must_use]
    pub const fn from_number(number: u8) -> Self {
        match number & 3 {
            0 => Self::VendorId,
            1 => Self::ProductCode,
            2 => Self::RevisionNumber,
            _ => Self::SerialNumber,
        }
    }
}

impl Bound {
    /// Its number, 0 to 5, in the order in which a master sends them.
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8
    }

    /// The part of the LSS address that it bounds.
    #[must_use]
    pub const fn part(self) -> Part {
        match self {
            Self::VendorId => Part::VendorId,
            Self::ProductCode => Part::ProductCode,
            Self::RevisionLow | Self::RevisionHigh => Part::RevisionNumber,
            Self::SerialLow | Self::SerialHigh => Part::SerialNumber,
        }
    }

    const fn from_number(number: u8) -> Self {
        match number {
            0 => Self::VendorId,
            1 => Self::ProductCode,
            2 => Self::RevisionLow,
            3 => Self::RevisionHigh,
            4 => Self::SerialLow,
            _ => Self::SerialHigh,
        }
    }
}

impl Request {
    /// The request in a frame's eight bytes; `None` for a service that CiA 305 does not define.
    #[inline]
    #[must_use]
    pub const fn parse(data: [u8; 8]) -> Option<Self> {
        let [command, b1, b2, b3, b4, b5, b6, b7] = data;
        let number = u32::from_le_bytes([b1, b2, b3, b4]);
        Some(match command {
            0x04 => Self::SwitchGlobal(b1),
            0x11 => Self::ConfigureNodeId(b1),
            0x13 => Self::ConfigureBitTiming { table: b1, index: b2 },
            0x15 => Self::ActivateBitTiming(u16::from_le_bytes([b1, b2])),
            0x17 => Self::Store,
            0x40..=0x43 => Self::SwitchSelective(Part::from_number(command), number),
            0x46..=0x4B => Self::Identify(Bound::from_number(command - 0x46), number),
            0x4C => Self::IdentifyNonConfigured,
            0x51 => Self::FastScan(FastScan {
                id_number: number,
                bit_check: b5,
                sub: b6,
                next: b7,
            }),
            0x5A..=0x5D => Self::Inquire(Part::from_number(command - 0x5A)),
            0x5E => Self::InquireNodeId,
            _ => return None,
        })
    }

    /// The eight bytes of the request.
    #[must_use]
    pub const fn emit(self) -> [u8; 8] {
        match self {
            Self::SwitchGlobal(mode) => message(0x04, mode as u32),
            Self::ConfigureNodeId(node_id) => message(0x11, node_id as u32),
            Self::ConfigureBitTiming { table, index } => message(0x13, u32::from_le_bytes([table, index, 0, 0])),
            Self::ActivateBitTiming(delay) => message(0x15, delay as u32),
            Self::Store => message(0x17, 0),
            Self::SwitchSelective(part, number) => message(0x40 + part.number(), number),
            Self::Identify(bound, number) => message(0x46 + bound.number(), number),
            Self::IdentifyNonConfigured => message(0x4C, 0),
            Self::FastScan(scan) => {
                let [command, b1, b2, b3, b4, ..] = message(0x51, scan.id_number);
                [command, b1, b2, b3, b4, scan.bit_check, scan.sub, scan.next]
            }
            Self::Inquire(part) => message(0x5A + part.number(), 0),
            Self::InquireNodeId => message(0x5E, 0),
        }
    }
}

impl Response {
    /// The response in a frame's eight bytes; `None` for a service that CiA 305 does not define.
    #[must_use]
    pub const fn parse(data: [u8; 8]) -> Option<Self> {
        let [command, b1, b2, b3, b4, ..] = data;
        Some(match command {
            0x11 => Self::NodeIdConfigured(b1),
            0x13 => Self::BitTimingConfigured(b1),
            0x17 => Self::Stored(b1),
            0x44 => Self::Selected,
            0x4F => Self::Identified,
            0x50 => Self::NonConfigured,
            0x5A..=0x5D => Self::Identity(Part::from_number(command - 0x5A), u32::from_le_bytes([b1, b2, b3, b4])),
            0x5E => Self::NodeId(b1),
            _ => return None,
        })
    }

    /// The eight bytes of the response.
    #[inline]
    #[must_use]
    pub const fn emit(self) -> [u8; 8] {
        match self {
            Self::NodeIdConfigured(code) => message(0x11, code as u32),
            Self::BitTimingConfigured(code) => message(0x13, code as u32),
            Self::Stored(code) => message(0x17, code as u32),
            Self::Selected => message(0x44, 0),
            Self::Identified => message(0x4F, 0),
            Self::NonConfigured => message(0x50, 0),
            Self::Identity(part, number) => message(0x5A + part.number(), number),
            Self::NodeId(node_id) => message(0x5E, node_id as u32),
        }
    }
}

/// A command with its number.
const fn message(command: u8, number: u32) -> [u8; 8] {
    let [b1, b2, b3, b4] = number.to_le_bytes();
    [command, b1, b2, b3, b4, 0, 0, 0]
}

#[cfg(test)]
mod tests {
    use super::{Request, Response};

    /// Bytes that mean nothing in a request are 0 when it is emitted.
    const DATA: [u8; 7] = [0x12, 0x34, 0x56, 0x78, 0x1F, 0x03, 0x02];

    #[test]
    fn what_is_emitted_is_parsed_again() {
        for command in 0..=0xFF {
            let [b1, b2, b3, b4, b5, b6, b7] = DATA;
            let bytes = [command, b1, b2, b3, b4, b5, b6, b7];
            if let Some(request) = Request::parse(bytes) {
                assert_eq!(Request::parse(request.emit()), Some(request));
                assert_eq!(request.emit()[0], command);
            }
            if let Some(response) = Response::parse(bytes) {
                assert_eq!(Response::parse(response.emit()), Some(response));
                assert_eq!(response.emit()[0], command);
            }
        }
    }

    #[test]
    fn each_service_of_cia_305_has_its_number() {
        let known = |command: &u8| Request::parse([*command, 0, 0, 0, 0, 0, 0, 0]).is_some();
        let services = (0..=0xFF).filter(known);
        let expected = [
            0x04, 0x11, 0x13, 0x15, 0x17, 0x40, 0x41, 0x42, 0x43, 0x46, 0x47, 0x48, 0x49, 0x4A, 0x4B, 0x4C, 0x51, 0x5A,
            0x5B, 0x5C, 0x5D, 0x5E,
        ];
        assert!(services.eq(expected));
    }
}
