//! Which of the encoders it is: what differs from one order code to the other.

use lexican_runtime::{NodeId, profile::encoder::Shaft};

/// Steps of a revolution (6501h).
pub const RESOLUTION: u32 = 16_384;

/// How far an encoder counts (manual, 4.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// One revolution.
    SingleTurn,
    /// 16 revolutions.
    MultiTurn4,
    /// 256 revolutions.
    MultiTurn8,
    /// 4096 revolutions.
    MultiTurn12,
}

impl Variant {
    /// All of them, the one that counts least first.
    pub const ALL: [Self; 4] = [Self::SingleTurn, Self::MultiTurn4, Self::MultiTurn8, Self::MultiTurn12];

    /// How many revolutions it tells apart (6502h).
    #[must_use]
    pub const fn revolutions(self) -> u16 {
        match self {
            Self::SingleTurn => 1,
            Self::MultiTurn4 => 16,
            Self::MultiTurn8 => 256,
            Self::MultiTurn12 => 4096,
        }
    }

    /// What its sensor can tell apart: 16,384 steps of each revolution.
    #[must_use]
    pub const fn shaft(self) -> Option<Shaft> {
        Shaft::new(RESOLUTION, self.revolutions() as u64)
    }

    /// The variant with this shaft; `None` for a sensor of another encoder.
    #[must_use]
    pub fn of(shaft: Shaft) -> Option<Self> {
        Self::ALL.into_iter().find(|variant| variant.shaft() == Some(shaft))
    }

    /// 1000h: the profile's number, 406, and the encoder type: 1 single-turn, 2 multi-turn.
    #[must_use]
    pub const fn device_type(self) -> u32 {
        match self {
            Self::SingleTurn => 0x0001_0196,
            _ => 0x0002_0196,
        }
    }

    /// How many positions there are with so many measuring units per revolution (6001h).
    #[must_use]
    pub const fn range(self, units_per_revolution: u32) -> u32 {
        units_per_revolution.saturating_mul(self.revolutions() as u32)
    }

    /// Whether an application offset (2001h) is within the physical range, in either direction.
    #[must_use]
    pub const fn allows_offset(self, offset: i32) -> bool {
        let steps = (RESOLUTION * self.revolutions() as u32).cast_signed();
        -steps <= offset && offset < steps
    }
}

/// The design of the shaft, as 1008h names it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Model {
    /// Solid shaft.
    #[default]
    Wv58mr,
    /// Hollow shaft.
    Wh58mr,
}

impl Model {
    /// 1008h: manufacturer device name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Wv58mr => "WV58MR",
            Self::Wh58mr => "WH58MR",
        }
    }
}

/// Which of the two encoders of a housing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Channel {
    /// The encoder: node 1 as delivered.
    #[default]
    First,
    /// The redundant encoder: node 2 as delivered.
    Second,
}

impl Channel {
    /// 1 or 2.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::First => 1,
            Self::Second => 2,
        }
    }

    /// The node-ID as delivered (manual, 5.1).
    #[must_use]
    pub const fn node_id(self) -> Option<NodeId> {
        NodeId::new(self.number())
    }
}

/// What a device was given when it was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Identity {
    /// Solid or hollow shaft.
    pub model: Model,
    /// Which of the two encoders.
    pub channel: Channel,
    /// The serial number that is imprinted on the housing; 0 while there is none.
    pub imprinted: u32,
}

impl Identity {
    /// 1018h:04: the imprinted number with the digit 1 or 2 after it, so that both encoders have an LSS address of their own
    /// (manual, 5.7.2.50). A number of more than 429,496,728 keeps its last digits only.
    #[must_use]
    pub const fn serial_number(self) -> u32 {
        self.imprinted
            .wrapping_mul(10)
            .wrapping_add(self.channel.number() as u32)
    }

    /// 650Bh: the same, and 0, its default, while there is no imprinted number.
    #[must_use]
    pub const fn encoder_serial_number(self) -> u32 {
        match self.imprinted {
            0 => 0,
            _ => self.serial_number(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Channel, Identity, Variant};

    #[test]
    fn ranges_are_those_of_chapter_4_1() {
        let ranges = Variant::ALL.map(|variant| (variant.range(16_384) - 1, variant.range(65_535) - 1));
        let printed = [
            (16_383, 65_534),
            (262_143, 1_048_559),
            (4_194_303, 16_776_959),
            (67_108_863, 268_431_359),
        ];
        assert_eq!(ranges, printed);
    }

    #[test]
    fn application_offsets_are_within_the_limits_of_chapter_5_7_2_21() {
        for (variant, limit) in Variant::ALL.into_iter().zip([16_384, 262_144, 4_194_304, 67_108_864]) {
            assert!(variant.allows_offset(-limit) && variant.allows_offset(limit - 1));
            assert!(!variant.allows_offset(-limit - 1) && !variant.allows_offset(limit));
        }
    }

    #[test]
    fn both_encoders_of_a_housing_have_a_serial_number_of_their_own() {
        let [first, second] = [Channel::First, Channel::Second].map(|channel| Identity {
            channel,
            imprinted: 4711,
            ..Identity::default()
        });
        assert_eq!((first.serial_number(), second.serial_number()), (47_111, 47_112));
        assert_eq!(second.encoder_serial_number(), 47_112);
        assert_eq!(Identity::default().encoder_serial_number(), 0);
    }
}
