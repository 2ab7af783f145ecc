//! Room for the PDOs of a device: as many as its dictionary has.

use super::{Mapped, Rpdo, Tpdo};

/// What keeps the state of a device's PDOs.
pub trait Room {
    /// The room.
    fn parts(&mut self) -> Parts<'_>;
}

/// The room in parts.
#[derive(Debug)]
pub struct Parts<'a> {
    /// One for each TPDO.
    pub tpdos: &'a mut [Tpdo],
    /// One for each RPDO.
    pub rpdos: &'a mut [Rpdo],
    /// One for each sub-index, from 1 on, of their mapping parameters.
    pub mapped: &'a mut [Mapped],
}

/// Room for a number of TPDOs, of RPDOs, and of sub-indices of their mapping parameters together.
#[derive(Clone, Debug)]
pub struct Pdos<const TPDOS: usize, const RPDOS: usize, const MAPPED: usize> {
    tpdos: [Tpdo; TPDOS],
    rpdos: [Rpdo; RPDOS],
    mapped: [Mapped; MAPPED],
}

impl<const TPDOS: usize, const RPDOS: usize, const MAPPED: usize> Pdos<TPDOS, RPDOS, MAPPED> {
    /// The room before a node uses it.
    pub const EMPTY: Self = Self {
        tpdos: [Tpdo::EMPTY; TPDOS],
        rpdos: [Rpdo::EMPTY; RPDOS],
        mapped: [Mapped::EMPTY; MAPPED],
    };
}

impl<const TPDOS: usize, const RPDOS: usize, const MAPPED: usize> Room for Pdos<TPDOS, RPDOS, MAPPED> {
    fn parts(&mut self) -> Parts<'_> {
        Parts {
            tpdos: &mut self.tpdos,
            rpdos: &mut self.rpdos,
            mapped: &mut self.mapped,
        }
    }
}
