//! A frame as one line of text, as candump and cansend write it: `601#4004600000000000`, `704#R`.

use lexican_runtime::{CanId, Frame};

/// The frame that `text` says.
///
/// # Panics
/// When it says none: a test is wrong then.
#[must_use]
#[track_caller]
pub fn frame(text: &str) -> Frame {
    let (id, data) = text
        .trim()
        .split_once('#')
        .unwrap_or_else(|| panic!("`{text}` is not ID#DATA"));
    let number = u32::from_str_radix(id, 16).unwrap_or_else(|_| panic!("`{id}` is not a CAN-ID"));
    let id = if id.len() > 3 {
        CanId::extended(number)
    } else {
        CanId::standard(number)
    };
    let id = id.unwrap_or_else(|| panic!("{number:X} is too great for a CAN-ID"));
    if let Some(length) = data.strip_prefix('R') {
        return Frame::remote(id, length.parse().unwrap_or(0)).expect("up to eight bytes");
    }
    Frame::new(id, &bytes(data)).expect("up to eight bytes")
}

/// The bytes that `hex` says; blanks and dots between them mean nothing.
///
/// # Panics
/// When they are not hexadecimal.
#[must_use]
#[track_caller]
pub fn bytes(hex: &str) -> Vec<u8> {
    let digits: Vec<char> = hex.chars().filter(|c| !matches!(c, ' ' | '.' | '_')).collect();
    assert!(digits.len().is_multiple_of(2), "`{hex}` has half a byte");
    let byte = |pair: &[char]| u8::from_str_radix(&pair.iter().collect::<String>(), 16);
    digits
        .chunks(2)
        .map(|pair| byte(pair).unwrap_or_else(|_| panic!("`{hex}` is not hexadecimal")))
        .collect()
}

/// `bytes` in hexadecimal digits.
#[must_use]
pub fn hex(bytes: &[u8]) -> String {
    bytes
        .iter()
        .fold(String::new(), |text, byte| text + &format!("{byte:02X}"))
}
