//! rust-ini's pairs and our positions.

use ini::{Ini, ParseOption};

use super::classify::{LineKind, classify};
use crate::source::Source;
use crate::span::Span;

/// A section as rust-ini read it, and where.
#[derive(Debug)]
pub(crate) struct IniSection {
    pub(crate) header: Span,
    pub(crate) label: Span,
    /// Key and value.
    pub(crate) pairs: Vec<(Span, Span)>,
}

const OPTIONS: ParseOption = ParseOption {
    enabled_quote: false,
    enabled_escape: false,
    enabled_indented_mutiline_value: false,
    enabled_preserve_key_leading_whitespace: false,
};

/// Reads all sections, in the order of the file.
pub(crate) fn read(source: &Source) -> Vec<IniSection> {
    let mut repaired = String::with_capacity(source.text().len());
    let mut headers = Vec::new();
    for number in 1..=source.line_count() {
        let span = source.line_span(number);
        let line = source.line_text(number);
        match classify(line) {
            LineKind::Header => headers.push((span, Vec::new())),
            LineKind::Pair => {
                let Some((_, pairs)) = headers.last_mut() else { continue };
                pairs.push(span);
            }
            _ => continue,
        }
        repaired.push_str(line.trim());
        repaired.push('\n');
    }
    let ini = Ini::load_from_str_opt(&repaired, OPTIONS).unwrap_or_default();
    let sections = ini.iter().filter_map(|(name, properties)| Some((name?, properties)));
    sections
        .zip(headers)
        .map(|((name, properties), (header, lines))| IniSection {
            header,
            label: Span::of(header.start as usize + 1..header.start as usize + 1 + name.len()),
            pairs: properties
                .iter()
                .zip(lines)
                .map(|((key, value), line)| pair(source, line, key, value))
                .collect(),
        })
        .collect()
}

fn pair(source: &Source, line: Span, key: &str, value: &str) -> (Span, Span) {
    let text = source.slice(line);
    let start = line.start as usize + text.len() - text.trim_start().len();
    let end = line.start as usize + text.trim_end().len();
    (
        Span::of(start..start + key.len()),
        Span::of(end.saturating_sub(value.len())..end),
    )
}
