//! What an object that configures a message's identifier holds.

use super::CanId;
use crate::AbortCode;

/// The value of an object of type COB-ID: bits 0 to 28 the identifier, bit 29 set for one of 29 bits. Bits 30 and 31 mean
/// something else in each service (CiA 301, 7.5.2.5, 7.5.2.17, 7.5.2.35, 7.5.2.37).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CobId(pub u32);

impl CobId {
    /// Bit 31: in EMCY and PDO objects the message does not exist.
    const INVALID: u32 = 1 << 31;
    /// Bit 30: in a TPDO's object it may not be asked for by RTR; in 1005h this node produces SYNC.
    const BIT_30: u32 = 1 << 30;
    /// Bit 29: the identifier has 29 bits.
    const EXTENDED: u32 = 1 << 29;
    /// Bits 0 to 28.
    const NUMBER: u32 = 0x1FFF_FFFF;

    /// Whether bit 31 is clear: the message exists.
    #[inline]
    #[must_use]
    pub const fn is_valid(self) -> bool {
        self.0 & Self::INVALID == 0
    }

    /// Whether bit 30 is set.
    #[inline]
    #[must_use]
    pub const fn has_bit_30(self) -> bool {
        self.0 & Self::BIT_30 != 0
    }

    /// The identifier; `None` when it is meant to have 11 bits and has more.
    #[inline]
    #[must_use]
    pub const fn can_id(self) -> Option<CanId> {
        let number = self.0 & Self::NUMBER;
        if self.0 & Self::EXTENDED == 0 {
            CanId::standard(number)
        } else {
            CanId::extended(number)
        }
    }

    /// Whether bits 0 to 29 are those of `other`: the same identifier.
    #[must_use]
    pub const fn has_identifier_of(self, other: Self) -> bool {
        (self.0 ^ other.0) & (Self::NUMBER | Self::EXTENDED) == 0
    }

    /// Refuses a value that a client may not configure in the place of `old`, where bit 31 says whether the message exists.
    ///
    /// # Errors
    /// [`AbortCode::INVALID_VALUE`] when bits 0 to 29 change while it is valid before and after, and for an identifier that
    /// [`CobId::check`] refuses. A value that is not valid is never refused.
    pub fn check_change(self, old: Self) -> Result<(), AbortCode> {
        if !self.is_valid() {
            return Ok(());
        }
        if old.is_valid() && !self.has_identifier_of(old) {
            return Err(AbortCode::INVALID_VALUE);
        }
        self.check()
    }

    /// Refuses an identifier that a client may not configure.
    ///
    /// # Errors
    /// [`AbortCode::INVALID_VALUE`] for more than 11 bits without bit 29, and for an identifier that CiA 301 (table 40)
    /// keeps for a service that cannot be configured.
    pub fn check(self) -> Result<(), AbortCode> {
        match self.can_id() {
            Some(id) if !id.is_restricted() => Ok(()),
            _ => Err(AbortCode::INVALID_VALUE),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::CobId;
    use crate::{wire::CanId, AbortCode};

    #[test]
    fn an_identifier_has_as_many_bits_as_bit_29_says() {
        assert_eq!(CobId(0xC000_0181).can_id(), CanId::standard(0x181));
        assert_eq!(CobId(0x2000_0181).can_id(), CanId::extended(0x181));
        assert_eq!(CobId(0x0000_0800).can_id(), None);
    }

    #[test]
    fn what_belongs_to_a_fixed_service_is_refused() {
        for taken in [0x000, 0x07F, 0x101, 0x180, 0x581, 0x67F, 0x6E0, 0x701, 0x7FF, 0x800] {
            assert_eq!(CobId(taken).check(), Err(AbortCode::INVALID_VALUE), "{taken:03X}");
        }
        for free in [0x080, 0x0FF, 0x100, 0x181, 0x57F, 0x580, 0x680, 0x700, 0x2000_0001] {
            assert_eq!(CobId(free).check(), Ok(()), "{free:03X}");
        }
    }
}
