//! The check value of block transfers (CiA 301, 7.2.4.3.16): polynomial 1021h, from 0, the highest bit first.

/// Words of a block: 512 bits.
const BLOCK: usize = 16;

/// The CRC of what `crc` is the CRC of, and then `bytes`; begin with 0.
///
/// Without a table. Whole blocks are first added up to one that has the same remainder, which takes a few XORs a word.
///
/// ```
/// assert_eq!(lexican_runtime::sdo::crc(0, b"123456789"), 0x31C3);
/// ```
#[must_use]
pub fn crc(crc: u16, bytes: &[u8]) -> u16 {
    let mut crc = crc;
    let mut sum = [0; BLOCK];
    let mut blocks = bytes.chunks_exact(4 * BLOCK);
    let has_blocks = blocks.len() != 0;
    for block in &mut blocks {
        add(&mut sum, block);
        // What came before stands in the first two bytes of what follows.
        if let Some(first) = sum.first_mut() {
            *first ^= u32::from(crc.swap_bytes());
        }
        crc = 0;
    }
    if has_blocks {
        crc = sum.iter().fold(0, |crc, word| after_word(crc, word.swap_bytes()));
    }
    let mut words = blocks.remainder().chunks_exact(4);
    for word in &mut words {
        if let Some(word) = word.first_chunk() {
            crc = after_word(crc, u32::from_be_bytes(*word));
        }
    }
    words.remainder().iter().fold(crc, |crc, byte| after_byte(crc, *byte))
}

/// Makes of `sum` and `block` behind it one block with the same remainder.
///
/// `sum` stands 512 bits higher than `block`, and x⁵¹² ≡ x³⁸⁴ + x¹⁶⁰ + 1, as P to the power of 32 has the same coefficients
/// as P: so each word of `sum` is added 4, 11 and 16 words further down. Those that fall into `sum` itself go on from there.
#[inline]
fn add(sum: &mut [u32; BLOCK], block: &[u8]) {
    // The mask says to the compiler what the range says to a reader: that no index is out of bounds.
    const LAST: usize = BLOCK - 1;
    for at in 4..BLOCK {
        let far = if at < 11 { 0 } else { sum[(at - 11) & LAST] };
        sum[at & LAST] ^= sum[(at - 4) & LAST] ^ far;
    }
    for (at, word) in block.chunks_exact(4).enumerate() {
        let near = if at < 4 { sum[(at + 12) & LAST] } else { 0 };
        let far = if at < 11 { sum[(at + 5) & LAST] } else { 0 };
        let word = word.first_chunk().map_or(0, |word| u32::from_le_bytes(*word));
        sum[at & LAST] ^= word ^ near ^ far;
    }
}

/// The CRC after four bytes more, the first the highest.
#[inline]
#[allow(clippy::cast_possible_truncation)] // A remainder has 16 bits.
const fn after_word(crc: u16, word: u32) -> u16 {
    remainder((crc as u32) << 16 ^ word) as u16
}

/// The CRC after one byte more.
#[inline]
#[allow(clippy::cast_possible_truncation)] // A remainder has 16 bits.
const fn after_byte(crc: u16, byte: u8) -> u16 {
    crc << 8 ^ remainder((crc >> 8) as u32 ^ byte as u32) as u16
}

/// `word` · x¹⁶ modulo P = x¹⁶ + x¹² + x⁵ + 1.
///
/// The quotient is `word` · (1 + a)⁻¹ with a = x⁻⁴ + x⁻¹¹ + x⁻¹⁶, and (1 + a)⁻¹ = (1 + a)(1 + a²)(1 + a⁴) as far as 32 bits
/// see. Of the quotient times P only the lowest 16 bits are left.
#[inline(never)]
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
        let bytes: [u8; 200] = core::array::from_fn(|at| (at * at * 7 + at * 31 + 5).to_le_bytes()[0]);
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
