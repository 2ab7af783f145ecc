//! The bit rates of CANopen.

/// In kbit/s (CiA 301, 5.4; CiA 305, table of bit timings).
pub(super) const BIT_RATES: [u16; 8] = [10, 20, 50, 125, 250, 500, 800, 1000];
