//! rust-ini reads `key=value`, each different line once.

use std::borrow::Cow;

use ini::{Ini, ParseOption};

use crate::span::Span;

/// Values are taken as they are written: no quotes, no escapes, no value of several lines.
const AS_WRITTEN: ParseOption = ParseOption {
    enabled_quote: false,
    enabled_escape: false,
    enabled_indented_mutiline_value: false,
    enabled_preserve_key_leading_whitespace: false,
};

/// How many lines are remembered, to be known again. A power of two.
const REMEMBERED: usize = 4096;

/// The lines that rust-ini is to read.
pub(super) struct Pairs<'a> {
    text: &'a str,
    /// The lines, in order: where, and which of the different ones.
    lines: Vec<(Span, u32)>,
    /// The different lines.
    different: Vec<Span>,
    /// What rust-ini is given: the different lines, repaired.
    repaired: String,
    /// By a hash of its text, the last line that had it. A line that was forgotten is read again.
    remembered: Vec<u32>,
}

impl<'a> Pairs<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            lines: Vec::new(),
            different: Vec::new(),
            repaired: String::new(),
            remembered: vec![u32::MAX; REMEMBERED],
        }
    }

    /// Adds a line, which is trimmed and has a `=` behind its first character.
    pub(super) fn add(&mut self, span: Span) {
        let line = self.text.get(span.range()).unwrap_or_default();
        let next = u32::try_from(self.different.len()).unwrap_or(u32::MAX);
        let Some(remembered) = self.remembered.get_mut(slot(line)) else {
            return;
        };
        let known = self.different.get(*remembered as usize);
        if known.and_then(|known| self.text.get(known.range())) != Some(line) {
            *remembered = next;
            self.different.push(span);
            self.repaired.push_str(&repair(line));
            self.repaired.push('\n');
        }
        self.lines.push((span, *remembered));
    }

    /// Key and value of each line that was added, as rust-ini reads it.
    ///
    /// rust-ini refuses nothing that [`repair`] lets through. If it did, fewer lines would come back.
    pub(super) fn read(self) -> impl Iterator<Item = (Span, Span)> {
        let ini = Ini::load_from_str_opt(&self.repaired, AS_WRITTEN).unwrap_or_default();
        let pairs = ini.general_section().iter();
        let lengths: Vec<(usize, usize)> = pairs.map(|(key, value)| (key.len(), value.len())).collect();
        self.lines
            .into_iter()
            .map_while(move |(line, number)| Some(locate(line, *lengths.get(number as usize)?)))
    }
}

/// The key starts where the line starts, the value ends where the line ends.
fn locate(line: Span, (key, value): (usize, usize)) -> (Span, Span) {
    let (start, end) = (line.start as usize, line.end as usize);
    (Span::of(start..start + key), Span::of(end - value..end))
}

/// `line` with as many bytes, without what rust-ini would take for more than text: a `:` in the key, which it takes for
/// `=`; a `\` before the `=`, which hides it; a `\` at the end, which glues the next line to this one.
fn repair(line: &str) -> Cow<'_, str> {
    if !line.bytes().any(|byte| matches!(byte, b':' | b'\\')) {
        return Cow::Borrowed(line);
    }
    let (key, value) = line.split_once('=').unwrap_or((line, ""));
    let key = key.replace([':', '\\'], "_");
    let value = value
        .strip_suffix('\\')
        .map_or(value.into(), |value| format!("{value}_"));
    Cow::Owned(format!("{key}={value}"))
}

/// Where a line of this text is remembered.
fn slot(line: &str) -> usize {
    const ODD: u64 = 0x9E37_79B9_7F4A_7C15;
    let (words, rest) = line.as_bytes().as_chunks::<8>();
    let mut last = [0; 8];
    last.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
    let hash = words.iter().chain([&last]).fold(line.len() as u64, |hash, word| {
        (hash ^ u64::from_le_bytes(*word)).wrapping_mul(ODD).rotate_left(29)
    });
    usize::try_from(hash >> (u64::BITS - REMEMBERED.ilog2())).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Key and value of each line of `text`, as rust-ini reads them.
    fn read(text: &str) -> Vec<(&str, &str)> {
        let mut pairs = Pairs::new(text);
        let mut start = 0;
        for line in text.split('\n') {
            pairs.add(Span::of(start..start + line.len()));
            start += line.len() + 1;
        }
        let read = pairs.read();
        read.map(|(key, value)| (&text[key.range()], &text[value.range()]))
            .collect()
    }

    #[test]
    fn a_line_that_occurs_twice_is_read_once_and_found_twice() {
        let mut pairs = Pairs::new("a=1\na=1\nb=2");
        for span in [Span::new(0, 3), Span::new(4, 7), Span::new(8, 11)] {
            pairs.add(span);
        }
        assert_eq!(pairs.repaired, "a=1\nb=2\n");
        assert_eq!(
            pairs.read().map(|(_, value)| value.start).collect::<Vec<_>>(),
            [2, 6, 10]
        );
    }

    #[test]
    fn values_are_as_written() {
        assert_eq!(
            read("Path =\tC:\\temp\\\nName=\"quoted\" ; not a comment\nText='x' # y\nSum==a=b\nEmpty="),
            [
                ("Path", "C:\\temp\\"),
                ("Name", "\"quoted\" ; not a comment"),
                ("Text", "'x' # y"),
                ("Sum", "=a=b"),
                ("Empty", ""),
            ]
        );
    }

    #[test]
    fn keys_end_at_the_equals_sign() {
        assert_eq!(read("a:b=1\nc\\=2\n\\=\\"), [("a:b", "1"), ("c\\", "2"), ("\\", "\\")]);
    }
}
