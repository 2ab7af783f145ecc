//! Bit rates, by their number in the table of CiA 305.

/// A bit rate: its row in the standard's table of bit timing parameters (CiA 305, table 0).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BitRate(u8);

impl BitRate {
    /// 0: 1000 kbit/s
    pub const KBIT_1000: Self = Self(0);
    /// 1: 800 kbit/s
    pub const KBIT_800: Self = Self(1);
    /// 2: 500 kbit/s
    pub const KBIT_500: Self = Self(2);
    /// 3: 250 kbit/s
    pub const KBIT_250: Self = Self(3);
    /// 4: 125 kbit/s
    pub const KBIT_125: Self = Self(4);
    /// 6: 50 kbit/s
    pub const KBIT_50: Self = Self(6);
    /// 7: 20 kbit/s
    pub const KBIT_20: Self = Self(7);
    /// 8: 10 kbit/s
    pub const KBIT_10: Self = Self(8);
    /// 9: found out by listening.
    pub const AUTOMATIC: Self = Self(9);

    /// The bit rate in this row; `None` for the reserved row 5, and above 9.
    #[must_use]
    pub const fn from_index(index: u8) -> Option<Self> {
        match index {
            0..=4 | 6..=9 => Some(Self(index)),
            _ => None,
        }
    }

    /// The row, 0 to 9.
    #[must_use]
    pub const fn index(self) -> u8 {
        self.0
    }

    /// In kbit/s; `None` for [`BitRate::AUTOMATIC`].
    #[must_use]
    pub const fn kbit_per_s(self) -> Option<u16> {
        Some(match self.0 {
            0 => 1000,
            1 => 800,
            2 => 500,
            3 => 250,
            4 => 125,
            6 => 50,
            7 => 20,
            8 => 10,
            _ => return None,
        })
    }
}

/// The bit rates that a device can be set to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BitRates(pub u16);

impl BitRates {
    /// 10 to 1000 kbit/s, all of the table.
    pub const ALL: Self = Self(0x01DF);

    /// Whether `bit_rate` is among them: bit 0 stands for row 0.
    #[must_use]
    pub const fn has(self, bit_rate: BitRate) -> bool {
        self.0 >> bit_rate.index() & 1 != 0
    }
}
