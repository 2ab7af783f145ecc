//! The values after power-on as flash holds them: without the zeros that they end with.

/// How many of `bytes` there are up to the last that is not 0.
#[must_use]
pub const fn written(bytes: &[u8]) -> usize {
    let mut length = bytes.len();
    while length > 0 && bytes[length - 1] == 0 {
        length -= 1;
    }
    length
}

/// The first `N` of `bytes`, and zeros in place of those that there are not.
#[must_use]
pub const fn resized<const N: usize>(bytes: &[u8]) -> [u8; N] {
    let mut resized = [0; N];
    let mut at = 0;
    while at < N && at < bytes.len() {
        resized[at] = bytes[at];
        at += 1;
    }
    resized
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_cut_off_is_back() {
        let values = [0, 7, 0, 9, 0, 0];
        assert_eq!(written(&values), 4);
        let image: [u8; 4] = resized(&values);
        assert_eq!((image, resized(&image)), ([0, 7, 0, 9], values));
        assert_eq!((written(&[]), written(&[0, 0])), (0, 0));
    }
}
