//! Files that are no EDS: what their first bytes say.

/// What a file is that is not an EDS or DCF.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Nothing: no bytes, or blanks only.
    Empty,
    /// More than 1 GiB.
    TooLarge,
    /// UTF-16 text, with or without a byte order mark.
    Utf16,
    /// Bytes that are no text.
    Binary,
    /// A CANopen device description in XML: XDD, XDC, XPD (CiA 311).
    CanopenXml,
    /// An Ethernet POWERLINK device description in XML.
    PowerlinkXml,
    /// A web page; a download that went wrong.
    Html,
    /// XML of another kind.
    Xml,
    /// An EDS of ODVA: EtherNet/IP, DeviceNet, ControlNet.
    Odva,
    /// Sections and keywords, but no section that CiA 306-1 knows.
    Ini,
    /// Text without a single section.
    Text,
}

/// How much of a file is looked at.
const HEAD: usize = 64 * 1024;

impl Format {
    /// What `bytes` are, when they cannot be an EDS.
    pub(super) fn recognise(bytes: &[u8]) -> Option<Self> {
        let head = bytes.get(..HEAD).unwrap_or(bytes);
        let ends_of_old = |byte: &u8| matches!(byte, 0 | 0x1A) || byte.is_ascii_whitespace();
        let filled = head.len() - head.iter().rev().take_while(|byte| ends_of_old(byte)).count();
        let text = head.get(..filled).unwrap_or_default().trim_ascii_start();
        if text.is_empty() {
            Some(if bytes.len() > HEAD { Self::Binary } else { Self::Empty })
        } else if is_utf16(head) {
            Some(Self::Utf16)
        } else if is_binary(text) {
            Some(Self::Binary)
        } else if text.starts_with(b"<") {
            Some(markup(text))
        } else {
            None
        }
    }
}

/// A byte order mark, or every other byte zero.
fn is_utf16(head: &[u8]) -> bool {
    let zeros = |offset| head.iter().skip(offset).step_by(2).filter(|byte| **byte == 0).count();
    let (high, low) = (zeros(0), zeros(1));
    let most_of_half = head.len() / 2 - head.len() / 8;
    let one_half = high.max(low) > most_of_half && high.min(low) <= head.len() / 64;
    head.starts_with(b"\xFF\xFE") || head.starts_with(b"\xFE\xFF") || (head.len() >= 8 && one_half)
}

/// One byte in twenty, and no less than four, is a control character that no editor writes.
fn is_binary(text: &[u8]) -> bool {
    let is_control = |byte: &&u8| matches!(byte, 0..=8 | 0x0E..=0x19 | 0x1B..=0x1F | 0x7F);
    text.iter().filter(is_control).count() >= (text.len() / 20).max(4)
}

fn markup(text: &[u8]) -> Format {
    let text = text.to_ascii_lowercase();
    let has = |word: &[u8]| text.windows(word.len()).any(|window| window == word);
    if has(b"powerlink") {
        Format::PowerlinkXml
    } else if has(b"canopen") {
        Format::CanopenXml
    } else if has(b"<html") || has(b"<!doctype html") {
        Format::Html
    } else {
        Format::Xml
    }
}
