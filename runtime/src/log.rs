//! How values look in a log of the crate defmt, where they do not look as their parts do.

use defmt::{write, Format, Formatter};

use crate::{
    od::TimeOfDay,
    wire::{CanId, CobId, Frame},
    AbortCode, Address, Instant, NodeId,
};

impl Format for Frame {
    /// As the tools of can-utils write it: `601#4000100000000000`, `704#R1`.
    fn format(&self, f: Formatter<'_>) {
        number(self.id(), f);
        write!(f, "#");
        if self.is_remote() {
            write!(f, "R{=usize}", self.length());
        }
        for byte in self.data() {
            write!(f, "{=u8:02X}", *byte);
        }
    }
}

impl Format for CanId {
    /// `601h` or `00000601h`.
    fn format(&self, f: Formatter<'_>) {
        number(*self, f);
        write!(f, "h");
    }
}

impl Format for CobId {
    /// `40000181h`.
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=u32:08X}h", self.0);
    }
}

impl Format for Address {
    /// `1018sub1`, as an EDS file names it.
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=u16:04X}sub{=u8:X}", self.index, self.sub);
    }
}

impl Format for AbortCode {
    /// `0602_0000h`, grouped as the standard prints it.
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=u32:04X}_{=u32:04X}h", self.0 >> 16, self.0 & 0xFFFF);
    }
}

impl Format for NodeId {
    /// The number.
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=u8}", self.get());
    }
}

impl Format for Instant {
    /// In µs, `never` for [`Instant::NEVER`].
    fn format(&self, f: Formatter<'_>) {
        match *self {
            Self::NEVER => write!(f, "never"),
            instant => write!(f, "{=u64} µs", instant.as_micros()),
        }
    }
}

impl Format for TimeOfDay {
    /// Days since 1 January 1984, and milliseconds.
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=u16} d {=u32} ms", self.days(), self.milliseconds());
    }
}

/// Three digits, or eight of an identifier of 29 bits.
fn number(id: CanId, f: Formatter<'_>) {
    if id.is_extended() {
        write!(f, "{=u32:05X}", id.number() >> 12);
    }
    write!(f, "{=u32:03X}", id.number() & 0xFFF);
}
