//! From the text of an EDS to a Rust identifier.

use deunicode::deunicode;

/// The longest part that an object's or a sub-index's name gives to an identifier, in bytes.
const LONGEST: usize = 60;

/// The words that Rust keeps for itself in any edition, and those that are no field even as `r#self`.
const KEYWORDS: [&str; 52] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod",
    "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super", "trait", "true",
    "try", "type", "typeof", "union", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// The words of `text` in snake case: ASCII letters, digits and single underscores between them; possibly nothing.
///
/// Other scripts are transliterated: `Größe [µs]` is `grosse_us`.
pub(crate) fn snake(text: &str) -> String {
    let ascii = deunicode(text);
    let words = ascii.split(|c: char| !c.is_ascii_alphanumeric()).flat_map(humps);
    let mut snake = String::new();
    for word in words {
        if !snake.is_empty() {
            snake.push('_');
        }
        snake.push_str(&word.to_ascii_lowercase());
    }
    snake
}

/// `snake` cut to a length that one can still read, and whether something was cut off.
pub(super) fn cut(mut snake: String) -> (String, bool) {
    if snake.len() <= LONGEST {
        return (snake, false);
    }
    let end = snake[..=LONGEST].rfind('_').filter(|&end| end > 0).unwrap_or(LONGEST);
    snake.truncate(end);
    (snake, true)
}

/// `name` with a letter at its start.
pub(crate) fn letter_first(name: String) -> String {
    if name.starts_with(|c: char| c.is_ascii_lowercase()) {
        name
    } else {
        format!("object_{name}")
    }
}

/// `name` as a field or a module: not a keyword.
pub(crate) fn field_ident(name: &str) -> String {
    match KEYWORDS.binary_search(&name) {
        Ok(_) => format!("{name}_"),
        Err(_) => name.to_owned(),
    }
}

/// The words that are written together in `word`: `ProducerHeartbeatTime`, `NMTState`.
fn humps(word: &str) -> impl Iterator<Item = &str> {
    let starts: Vec<usize> = (1..word.len()).filter(|&at| starts_hump(word, at)).collect();
    let ends = starts.clone().into_iter().chain([word.len()]);
    let begins = [0].into_iter().chain(starts);
    begins
        .zip(ends)
        .map(|(begin, end)| &word[begin..end])
        .filter(|hump| !hump.is_empty())
}

/// Whether a new word starts at `at`: at a capital letter after a small one, or before one.
///
/// Digits belong to what stands before them, a unit's prefix (`kHz`) to its unit.
fn starts_hump(word: &str, at: usize) -> bool {
    let (before, rest) = word.split_at(at);
    let letters = before.trim_end_matches(|c: char| c.is_ascii_digit());
    match letters.chars().next_back() {
        _ if !rest.starts_with(|c: char| c.is_ascii_uppercase()) => false,
        Some(last) if last.is_ascii_lowercase() => before.len() > 1,
        Some(_) => starts_small(&rest[1..]),
        None => false,
    }
}

/// Whether `rest` goes on in small letters, other than the `s` of several: `PDOs`.
fn starts_small(rest: &str) -> bool {
    let small = |text: &str| text.starts_with(|c: char| c.is_ascii_lowercase());
    match rest.strip_prefix('s') {
        Some(after) => small(after),
        None => small(rest),
    }
}

#[cfg(test)]
mod tests {
    use super::{KEYWORDS, cut, field_ident, letter_first, snake};

    #[test]
    fn words_are_found_as_a_reader_finds_them() {
        for (text, expected) in [
            ("Producer heartbeat time", "producer_heartbeat_time"),
            ("ProducerHeartbeatTime", "producer_heartbeat_time"),
            ("COB-ID used by RxPDO1", "cob_id_used_by_rx_pdo1"),
            ("NMTState", "nmt_state"),
            ("Number of mapped TPDOs", "number_of_mapped_tpdos"),
            ("IDsOfNodes", "ids_of_nodes"),
            ("Frequency [kHz]", "frequency_khz"),
            ("X1Speed 3D", "x1_speed_3d"),
            ("  --a__b--  ", "a_b"),
        ] {
            assert_eq!(snake(text), expected, "{text}");
        }
    }

    #[test]
    fn other_scripts_become_ascii() {
        for (text, expected) in [
            ("Größe", "grosse"),
            ("DRIVE TEMP [°C]", "drive_temp_deg_c"),
            ("Tn [µs]", "tn_us"),
            ("速度", "su_du"),
            ("\u{202E}\n\0", ""),
            ("", ""),
        ] {
            assert_eq!(snake(text), expected, "{text:?}");
        }
    }

    #[test]
    fn an_identifier_is_no_keyword_and_starts_with_a_letter() {
        assert_eq!(field_ident("type"), "type_");
        assert_eq!(field_ident("self"), "self_");
        assert_eq!(field_ident("speed"), "speed");
        assert_eq!(letter_first("2nd_encoder".to_owned()), "object_2nd_encoder");
    }

    #[test]
    fn the_keywords_can_be_searched() {
        assert!(KEYWORDS.is_sorted());
    }

    #[test]
    fn a_long_name_is_cut_between_words() {
        let (name, was_cut) = cut(snake(&"seven letters ".repeat(20)));
        assert!(was_cut);
        assert_eq!(name, "seven_letters_seven_letters_seven_letters_seven_letters");
        assert_eq!(cut("x".repeat(200)).0.len(), 60);
        assert!(!cut("x".repeat(60)).1);
    }
}
