//! What is printed on an encoder's label: what tells one WDGA from another.

use lexican_runtime::profile::encoder::Shaft;

use crate::wdga::Dictionary;

/// Whether an encoder counts revolutions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Variant {
    /// One revolution: `WDGA-ST-CO`, device type 0001 0196h.
    Singleturn,
    /// As many as 6510h says: `WDGA-MT-CO`, device type 0002 0196h.
    #[default]
    Multiturn,
}

impl Variant {
    /// 1000h: the profile 406, and the kind of encoder.
    pub(crate) const fn device_type(self) -> u32 {
        match self {
            Self::Singleturn => 0x0001_0196,
            Self::Multiturn => 0x0002_0196,
        }
    }

    /// 1008h
    pub(crate) const fn device_name(self) -> &'static str {
        match self {
            Self::Singleturn => "WDGA-ST-CO",
            Self::Multiturn => "WDGA-MT-CO",
        }
    }

    /// 6502h
    pub(crate) const fn revolutions(self) -> u16 {
        match self {
            Self::Singleturn => 1,
            Self::Multiturn => 0xFFFF,
        }
    }

    /// Of a shaft with so many revolutions.
    pub(crate) fn of(shaft: Shaft) -> Self {
        if shaft.revolutions() == 1 {
            Self::Singleturn
        } else {
            Self::Multiturn
        }
    }
}

/// The shaft that the manual describes: 6501h steps a revolution; of a multiturn encoder 6510h revolutions.
#[must_use]
pub fn shaft(variant: Variant) -> Shaft {
    let revolutions = match variant {
        Variant::Singleturn => 1,
        Variant::Multiturn => Dictionary::NUMBER_OF_HIGH_PRECISION_REVOLUTIONS,
    };
    // 2¹⁴ steps, 2³⁹ revolutions.
    Shaft::new(Dictionary::SINGLETURN_RESOLUTION, revolutions).unwrap_or(Shaft::ONE)
}

/// What is individual to an encoder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// 1018h:04 and 650Bh:01.
    pub serial_number: u32,
    /// 1009h, up to 16 bytes of ASCII.
    pub hardware_version: &'static str,
    /// 100Ah, up to 16 bytes of ASCII.
    pub software_version: &'static str,
}

impl Default for Label {
    /// Serial number 0, hardware `AA`, software `2.08`.
    fn default() -> Self {
        Self {
            serial_number: 0,
            hardware_version: "AA",
            software_version: "2.08",
        }
    }
}
