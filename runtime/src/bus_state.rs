//! What a CAN controller says of itself.

/// The error state of a CAN controller (ISO 11898-1): how much it trusts itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BusState {
    /// Error active: as it should be.
    #[default]
    Active,
    /// Error passive: an error counter is above 127.
    Passive,
    /// Bus off: the transmit error counter is above 255, and nothing is sent or received.
    Off,
}
