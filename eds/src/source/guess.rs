//! Windows-1252 or CP850: which reading of a line makes words.
//!
//! Both give every byte a meaning, so only plausibility tells them apart. Each character beyond ASCII is judged by its
//! neighbours: a letter belongs next to letters, and in a word of small letters it is a small one; a sign such as `°`
//! does not stand between letters; the frames of DOS do not stand in an EDS at all. `Sch\x94naich` is `Schönaich` in
//! CP850 and `Sch”naich` in Windows-1252; `Nyk\xE4nen` is `Nykänen` in Windows-1252 and `Nykõnen` in CP850.
//!
//! A line that reads equally well both ways (`Stra\xE1e`) takes the encoding that the other lines of the file speak for,
//! and Windows-1252 when they say nothing.

use super::encoding::Encoding;
use super::lines::split;

/// The encoding of a line that is not UTF-8. `balance` is [that of its file](balance_of_file).
pub(super) fn encoding(line: &[u8], balance: i64) -> Encoding {
    let own = balance_of_line(line);
    let decisive = if own == 0 { balance } else { own };
    if decisive > 0 {
        Encoding::Cp850
    } else {
        Encoding::Windows1252
    }
}

/// How much the lines that are not UTF-8 speak for CP850; negative for Windows-1252.
pub(super) fn balance_of_file(bytes: &[u8]) -> i64 {
    let lines = split(bytes).filter_map(|line| bytes.get(line.range()));
    lines
        .filter(|line| str::from_utf8(line).is_err())
        .map(|line| balance_of_line(line).signum())
        .sum()
}

fn balance_of_line(line: &[u8]) -> i64 {
    plausibility(line, Encoding::Cp850) - plausibility(line, Encoding::Windows1252)
}

/// How much a line looks like text when read as `encoding`.
fn plausibility(line: &[u8], encoding: Encoding) -> i64 {
    let at = |at: usize| line.get(at).map_or('\n', |byte| encoding.decode_byte(*byte));
    (0..line.len())
        .filter(|position| !at(*position).is_ascii())
        .map(|position| weight(at(position.wrapping_sub(1)), at(position), at(position + 1)))
        .sum()
}

/// How well a character beyond ASCII fits between its neighbours.
fn weight(before: char, character: char, after: char) -> i64 {
    let in_word = before.is_alphabetic() || after.is_alphabetic();
    let within_word = before.is_alphabetic() && after.is_alphabetic();
    match character {
        '\u{80}'..='\u{9F}' | '─'..='▟' | '■' | '‗' => -4,
        '’' if within_word => 3,
        'µ' if !before.is_alphabetic() => 5,
        '™' | '®' | '©' if !after.is_alphabetic() => 5,
        _ if SIGNS.contains(character) && !within_word => 5,
        _ if character.is_uppercase() && before.is_lowercase() => 0,
        _ if COMMON.contains(character) && in_word => 4,
        _ if character.is_alphabetic() && in_word => 2,
        _ if character.is_alphabetic() || within_word => 0,
        _ => 1,
    }
}

/// The letters of the languages that EDS files are written in.
const COMMON: &str = "äöüßéèêëàâáåçñíóúôîïûùæøÄÖÜÉÈÀÁÅÇÑÆØ";

/// What stands beside numbers and units.
const SIGNS: &str = "°±²³½¼§–—“”„×÷€";

#[cfg(test)]
mod tests {
    use super::*;

    fn guessed(line: &[u8]) -> (Encoding, String) {
        let encoding = encoding(line, 0);
        let text = line.iter().map(|byte| encoding.decode_byte(*byte)).collect();
        (encoding, text)
    }

    #[test]
    fn german_of_dos_is_cp850() {
        for (line, text) in [
            (&b"Line3=71101 Sch\x94naich"[..], "Line3=71101 Schönaich"),
            (b"ParameterName=L\x81fter", "ParameterName=Lüfter"),
            (b"ParameterName=\x8Enderung", "ParameterName=Änderung"),
            (b"ParameterName=\x99l", "ParameterName=Öl"),
            (
                b"ParameterName=Temperatur 0..85 \xF8C",
                "ParameterName=Temperatur 0..85 °C",
            ),
        ] {
            assert_eq!(guessed(line), (Encoding::Cp850, text.into()));
        }
    }

    #[test]
    fn names_of_windows_are_windows_1252() {
        for (line, text) in [
            (
                &b"ModifiedBy=Matti Nyk\xE4nen, ABB Oy"[..],
                "ModifiedBy=Matti Nykänen, ABB Oy",
            ),
            (b"ParameterName=L\xFCfter", "ParameterName=Lüfter"),
            (b"ParameterName=\xD6l", "ParameterName=Öl"),
            (
                b"VendorName=Soci\xE9t\xE9 G\xE9n\xE9rale",
                "VendorName=Société Générale",
            ),
            (
                b"ParameterName=Temperature 0..85 \xB0C",
                "ParameterName=Temperature 0..85 °C",
            ),
            (b"ParameterName=0.1 \xB5m", "ParameterName=0.1 µm"),
            (
                b"Description=the drive\x92s \x93Stop\x94 input",
                "Description=the drive’s “Stop” input",
            ),
        ] {
            assert_eq!(guessed(line), (Encoding::Windows1252, text.into()));
        }
    }

    #[test]
    fn a_line_that_reads_both_ways_follows_the_file() {
        let line = b"Line1=Stra\xE1e 1";
        assert_eq!(encoding(line, 0), Encoding::Windows1252);
        assert_eq!(encoding(line, 1), Encoding::Cp850);
        let file = b"Line1=Stra\xE1e 1\r\nLine2=M\x81nchen\r\n";
        assert_eq!(balance_of_file(file), 1);
    }
}
