//! Frames and identifiers of the crate embedded-can, which the CAN drivers of HALs speak.

use embedded_can::{ExtendedId, Id, StandardId};

use super::{can_id, CanId, Frame};

impl embedded_can::Frame for Frame {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        Self::new(id.into().into(), data)
    }

    fn new_remote(id: impl Into<Id>, dlc: usize) -> Option<Self> {
        Self::remote(id.into().into(), u8::try_from(dlc).ok()?)
    }

    fn is_extended(&self) -> bool {
        Self::id(self).is_extended()
    }

    fn is_remote_frame(&self) -> bool {
        self.is_remote()
    }

    fn id(&self) -> Id {
        Self::id(self).into()
    }

    fn dlc(&self) -> usize {
        self.length()
    }

    fn data(&self) -> &[u8] {
        Self::data(self)
    }
}

impl From<Id> for CanId {
    fn from(id: Id) -> Self {
        match id {
            Id::Standard(id) => id.into(),
            Id::Extended(id) => id.into(),
        }
    }
}

impl From<StandardId> for CanId {
    fn from(id: StandardId) -> Self {
        Self::from_bits(u32::from(id.as_raw()))
    }
}

impl From<ExtendedId> for CanId {
    fn from(id: ExtendedId) -> Self {
        Self::from_bits(id.as_raw() | can_id::EXTENDED)
    }
}

impl From<CanId> for Id {
    fn from(id: CanId) -> Self {
        let standard = u16::try_from(id.number()).ok().and_then(StandardId::new);
        match standard.filter(|_| !id.is_extended()) {
            Some(id) => Self::Standard(id),
            // Every number of a `CanId` has 29 bits; there is no other way to say so without `unsafe`.
            None => Self::Extended(ExtendedId::new(id.number()).unwrap_or(ExtendedId::MAX)),
        }
    }
}
