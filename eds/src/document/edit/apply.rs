//! The changed text as bytes.

use super::{Change, Document, Edit, EditError};
use crate::fix::Replacement;
use crate::source::{BYTE_ORDER_MARK, Encoding, LineEnd, Source};
use crate::span::Span;

impl Edit<'_> {
    /// The changes, in the order of the file.
    pub(crate) fn replacements(mut self) -> Vec<Replacement> {
        self.sort();
        let changes = self.changes.into_iter();
        let replacements = changes.map(|change| Replacement {
            at: change.old,
            text: change.new,
        });
        replacements.collect()
    }

    fn sort(&mut self) {
        self.changes
            .sort_by_key(|change| (change.line, change.old.start, change.adds_lines));
    }

    /// The document with all changes made.
    ///
    /// # Errors
    /// When two changes are of the same text, or a line's encoding cannot hold its new text.
    pub fn apply(mut self) -> Result<Document, EditError> {
        self.sort();
        let source = self.document.source();
        let mut written = Written::new(source, self.byte_order_mark);
        let mut changes = self.changes.as_slice();
        for (number, line) in (0..).zip([Span::default()].into_iter().chain(source.lines())) {
            let of_line = changes.iter().take_while(|change| change.line <= number).count();
            let (these, later) = changes.split_at(of_line);
            changes = later;
            let new = ended(changed(source, line, these)?, self.line_end);
            written.line(number, source.slice(line), &new)?;
        }
        written.read_back().map(Document::read)
    }
}

/// The text of `line` with `changes` made, which are in order.
fn changed(source: &Source, line: Span, changes: &[Change]) -> Result<String, EditError> {
    let mut text = String::new();
    let mut start = line.start;
    let mut last = None;
    for change in changes {
        let same_place = last == Some(change.old.start) && !change.adds_lines;
        if same_place || change.old.start < start {
            return Err(EditError::Conflict { at: change.old });
        }
        text.push_str(source.slice(Span::new(start, change.old.start)));
        text.push_str(&change.new);
        start = change.old.end;
        last = Some(change.old.start);
    }
    text.push_str(source.slice(Span::new(start, line.end)));
    Ok(text)
}

/// `text`, one line or more, with `end` for each of its line ends.
fn ended(text: String, end: Option<LineEnd>) -> String {
    match end {
        Some(end) => text.replace("\r\n", "\n").replace('\r', "\n").replace('\n', end.text()),
        None => text,
    }
}

/// A new file in the making.
pub(super) struct Written<'a> {
    source: &'a Source,
    prevailing: Encoding,
    text: String,
    bytes: Vec<u8>,
}

impl<'a> Written<'a> {
    pub(super) fn new(source: &'a Source, byte_order_mark: bool) -> Self {
        Self {
            source,
            prevailing: source.prevailing_encoding(),
            text: String::with_capacity(source.text().len()),
            bytes: if byte_order_mark {
                BYTE_ORDER_MARK.to_vec()
            } else {
                Vec::new()
            },
        }
    }

    /// Adds `new`, which line `number` has become.
    pub(super) fn line(&mut self, number: u32, old: &str, new: &str) -> Result<(), EditError> {
        let encoding = if old.is_ascii() {
            self.prevailing
        } else {
            self.source.encoding(number)
        };
        self.text.push_str(new);
        if new.is_ascii() || encoding == Encoding::Utf8 {
            self.bytes.extend(new.as_bytes());
            return Ok(());
        }
        for character in new.chars() {
            let byte = encoding.encode_byte(character);
            self.bytes
                .push(byte.ok_or(EditError::NotEncodable { line: number, encoding })?);
        }
        Ok(())
    }

    /// The new file; it must read as it was meant, but a line may look like another encoding now.
    pub(super) fn read_back(self) -> Result<Source, EditError> {
        let read = Source::decode(self.source.name(), self.bytes);
        let mut lines = (1..).zip(read.text().lines().zip(self.text.lines()));
        match lines.find(|(_, (read, meant))| read != meant) {
            Some((line, _)) => Err(EditError::NotEncodable {
                line,
                encoding: read.encoding(line),
            }),
            None => Ok(read),
        }
    }
}
