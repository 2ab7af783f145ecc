//! 5F0Ah:02: the bit rate, by a number of the manufacturer's own.

use lexican_runtime::lss::BitRate;

/// 500 kbit/s, as delivered.
pub(crate) const DELIVERED: BitRate = BitRate::KBIT_500;

/// The bit rates from 5F0Ah:02 = 1 on (manual, 5.7.2.26).
const RATES: [BitRate; 7] = [
    BitRate::KBIT_20,
    BitRate::KBIT_50,
    BitRate::KBIT_125,
    BitRate::KBIT_250,
    BitRate::KBIT_500,
    BitRate::KBIT_800,
    BitRate::KBIT_1000,
];

/// The bit rate of this number.
pub(crate) fn bit_rate(number: u8) -> Option<BitRate> {
    RATES.get(usize::from(number).checked_sub(1)?).copied()
}

/// The number of this bit rate; 0 of one that the encoder does not have.
pub(crate) fn number(bit_rate: BitRate) -> u8 {
    let known = (1..).zip(RATES).find(|(_, known)| *known == bit_rate);
    known.map_or(0, |(number, _)| number)
}
