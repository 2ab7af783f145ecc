//! Words of the file inside of a message.

/// `text` in backticks, cut when it would hide the message.
pub(crate) fn quoted(text: &str) -> String {
    const LONGEST: usize = 48;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("`{}…`", text.get(..end).unwrap_or_default()),
        None => format!("`{text}`"),
    }
}

/// What a finding that stands for several says at the end.
pub(crate) fn more(number: usize) -> String {
    match number {
        0 => String::new(),
        number => format!(" (and {number} more)"),
    }
}

/// The one of `candidates` that `text` was probably meant to be.
pub(crate) fn similar<'a>(text: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let text = text.to_ascii_lowercase();
    let furthest = text.chars().count() / 3;
    let distance = |candidate: &str| strsim::osa_distance(&text, &candidate.to_ascii_lowercase());
    let measured = candidates.into_iter().map(|candidate| (distance(candidate), candidate));
    let near = measured.filter(|(distance, _)| *distance <= furthest);
    near.min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_value_is_cut_in_a_message() {
        assert_eq!(quoted("0x10"), "`0x10`");
        assert_eq!(quoted(&"ä".repeat(20_000)).chars().count(), 51);
    }

    #[test]
    fn a_slip_of_the_finger_is_recognised_and_another_word_is_not() {
        let keywords = ["ParameterName", "DefaultValue", "LowLimit"];
        assert_eq!(similar("PrameterNaem", keywords), Some("ParameterName"));
        assert_eq!(similar("lowlimt", keywords), Some("LowLimit"));
        assert_eq!(similar("Category", keywords), None);
        assert_eq!(similar("", keywords), None);
    }
}
