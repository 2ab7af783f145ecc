//! The check value of block transfers (CiA 301, 7.2.4.3.16): polynomial 1021h, from 0, the highest bit first.

/// The CRC of what `crc` is the CRC of, and then `bytes`; begin with 0.
///
/// Four bytes at a time without a table: a few shifts of a word do what four look-ups in 512 bytes of flash would.
///
/// ```
/// assert_eq!(lexican_runtime::sdo::crc(0, b"123456789"), 0x31C3);
/// ```
#[must_use]
#[allow(clippy::cast_possible_truncation)] // A remainder has 16 bits.
pub fn crc(crc: u16, bytes: &[u8]) -> u16 {
    let mut words = bytes.chunks_exact(4);
    let mut crc = u32::from(crc);
    for word in &mut words {
        if let Some(word) = word.first_chunk() {
            crc = remainder(crc << 16 ^ u32::from_be_bytes(*word));
        }
    }
    for byte in words.remainder() {
        crc = crc << 8 & 0xFF00 ^ remainder(crc >> 8 ^ u32::from(*byte));
    }
    crc as u16
}

/// `word` · x¹⁶ modulo P = x¹⁶ + x¹² + x⁵ + 1.
///
/// The quotient is `word` · (1 + a)⁻¹ with a = x⁻⁴ + x⁻¹¹ + x⁻¹⁶, and (1 + a)⁻¹ = (1 + a)(1 + a²)(1 + a⁴) as far as 32 bits
/// see. Of the quotient times P only the lowest 16 bits are left.
#[inline]
const fn remainder(word: u32) -> u32 {
    let quotient = word ^ word >> 16;
    let quotient = quotient ^ quotient >> 8 ^ quotient >> 22;
    let quotient = quotient ^ quotient >> 4 ^ quotient >> 11 ^ quotient >> 16;
    (quotient ^ quotient << 5 ^ quotient << 12) & 0xFFFF
}

#[cfg(test)]
mod tests {
    use super::crc;

    /// As the standard draws it: a register, bit by bit.
    fn bit_by_bit(bytes: &[u8]) -> u16 {
        bytes.iter().fold(0, |crc, byte| {
            (0..8).fold(crc ^ u16::from(*byte) << 8, |crc, _| {
                crc << 1 ^ if crc & 0x8000 == 0 { 0 } else { 0x1021 }
            })
        })
    }

    #[test]
    fn it_is_that_of_the_shift_register_for_every_length_and_cut() {
        let bytes: [u8; 64] = core::array::from_fn(|at| (at * at * 7 + at * 31 + 5).to_le_bytes()[0]);
        for length in 0..=bytes.len() {
            let expected = bit_by_bit(&bytes[..length]);
            for cut in 0..=length {
                assert_eq!(crc(crc(0, &bytes[..cut]), &bytes[cut..length]), expected);
            }
        }
    }

    #[test]
    fn every_word_has_the_remainder_of_its_bits() {
        for bit in 0..32 {
            let word = (1u32 << bit).to_be_bytes();
            assert_eq!(crc(0, &word), bit_by_bit(&word));
        }
        assert_eq!(crc(0, &[]), 0);
        assert_eq!(crc(0, b"123456789"), 0x31C3);
    }
}
