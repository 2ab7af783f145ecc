//! UTF-8, Windows-1252 or CP850, line by line.

use super::guess;
use super::lines::split;

/// How a line's bytes become characters.
///
/// Windows-1252 and CP850 map every byte to a character of its own: the five bytes that Windows-1252 leaves free are the
/// control characters of the same number, as browsers have it. So a line goes back to the bytes that it came from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8, and with it ASCII.
    #[default]
    Utf8,
    /// Windows-1252, the superset of ISO 8859-1 that Windows programs write.
    Windows1252,
    /// CP850, what DOS programs wrote.
    Cp850,
}

impl Encoding {
    /// What people call it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "UTF-8",
            Self::Windows1252 => "Windows-1252",
            Self::Cp850 => "CP850",
        }
    }

    /// The character of `byte` in an encoding of single bytes.
    pub(super) fn decode_byte(self, byte: u8) -> char {
        let table: &[char] = match self {
            Self::Utf8 => &[],
            Self::Windows1252 => &WINDOWS_1252,
            Self::Cp850 => &CP850,
        };
        let high = usize::from(byte).checked_sub(0x80).and_then(|at| table.get(at));
        high.copied().unwrap_or(char::from(byte))
    }

    /// The byte of `character` in an encoding of single bytes; `None` when it has none.
    pub(crate) fn encode_byte(self, character: char) -> Option<u8> {
        (0..=u8::MAX).find(|byte| self.decode_byte(*byte) == character)
    }
}

/// The lines that are not UTF-8.
#[derive(Clone, Debug, Default)]
pub(super) struct Legacy {
    /// Line, from 1, and its encoding; ascending.
    lines: Vec<(u32, Encoding)>,
}

impl Legacy {
    pub(super) fn of_line(&self, line: u32) -> Encoding {
        let at = self.lines.binary_search_by_key(&line, |(line, _)| *line).ok();
        at.and_then(|at| self.lines.get(at))
            .map_or(Encoding::Utf8, |(_, encoding)| *encoding)
    }

    /// The encoding that most lines beyond ASCII have; a file without any is UTF-8.
    pub(super) fn prevailing(&self, text: &str) -> Encoding {
        let lines = split(text.as_bytes()).filter_map(|line| text.get(line.range()));
        let beyond_ascii = lines.filter(|line| !line.is_ascii()).count();
        let count = |wanted| self.lines.iter().filter(|(_, encoding)| *encoding == wanted).count();
        let (windows, dos) = (count(Encoding::Windows1252), count(Encoding::Cp850));
        let utf8 = beyond_ascii.saturating_sub(windows + dos);
        if utf8 >= windows.max(dos) {
            Encoding::Utf8
        } else if windows >= dos {
            Encoding::Windows1252
        } else {
            Encoding::Cp850
        }
    }

    /// Appends the bytes that `text` was decoded from.
    pub(super) fn encode(&self, text: &str, bytes: &mut Vec<u8>) {
        if self.lines.is_empty() {
            bytes.extend(text.as_bytes());
            return;
        }
        for (number, line) in (1..).zip(split(text.as_bytes())) {
            let line = text.get(line.range()).unwrap_or_default();
            match self.of_line(number) {
                Encoding::Utf8 => bytes.extend(line.as_bytes()),
                encoding => bytes.extend(line.chars().filter_map(|character| encoding.encode_byte(character))),
            }
        }
    }
}

/// The text of `bytes`, and which lines of it are not UTF-8.
pub(super) fn decode(bytes: Vec<u8>) -> (String, Legacy) {
    match String::from_utf8(bytes) {
        Ok(text) => (text, Legacy::default()),
        Err(error) => decode_by_line(error.as_bytes()),
    }
}

fn decode_by_line(bytes: &[u8]) -> (String, Legacy) {
    let mut text = String::with_capacity(bytes.len() + bytes.len() / 8);
    let mut legacy = Legacy::default();
    let balance = guess::balance_of_file(bytes);
    for (number, line) in (1..).zip(split(bytes)) {
        let line = bytes.get(line.range()).unwrap_or_default();
        if let Ok(line) = str::from_utf8(line) {
            text.push_str(line);
        } else {
            let encoding = guess::encoding(line, balance);
            text.extend(line.iter().map(|byte| encoding.decode_byte(*byte)));
            legacy.lines.push((number, encoding));
        }
    }
    (text, legacy)
}

/// The bytes 80h to FFh in CP850.
const CP850: [char; 128] = [
    'Ç', 'ü', 'é', 'â', 'ä', 'à', 'å', 'ç', 'ê', 'ë', 'è', 'ï', 'î', 'ì', 'Ä', 'Å', 'É', 'æ', 'Æ', 'ô', 'ö', 'ò', 'û',
    'ù', 'ÿ', 'Ö', 'Ü', 'ø', '£', 'Ø', '×', 'ƒ', 'á', 'í', 'ó', 'ú', 'ñ', 'Ñ', 'ª', 'º', '¿', '®', '¬', '½', '¼', '¡',
    '«', '»', '░', '▒', '▓', '│', '┤', 'Á', 'Â', 'À', '©', '╣', '║', '╗', '╝', '¢', '¥', '┐', '└', '┴', '┬', '├', '─',
    '┼', 'ã', 'Ã', '╚', '╔', '╩', '╦', '╠', '═', '╬', '¤', 'ð', 'Ð', 'Ê', 'Ë', 'È', 'ı', 'Í', 'Î', 'Ï', '┘', '┌', '█',
    '▄', '¦', 'Ì', '▀', 'Ó', 'ß', 'Ô', 'Ò', 'õ', 'Õ', 'µ', 'þ', 'Þ', 'Ú', 'Û', 'Ù', 'ý', 'Ý', '¯', '´', '\u{AD}', '±',
    '‗', '¾', '¶', '§', '÷', '¸', '°', '¨', '·', '¹', '³', '²', '■', '\u{A0}',
];

/// The bytes 80h to 9Fh in Windows-1252; from A0h on a byte is the character of the same number.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8D}', 'Ž', '\u{8F}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9D}', 'ž', 'Ÿ',
];
