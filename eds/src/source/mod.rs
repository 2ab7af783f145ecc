//! A file as text: bytes decoded, lines counted.
//!
//! [`Source::decode`] never fails. Every line of the text goes back to exactly the bytes that it came from
//! ([`Source::to_bytes`]), because each encoding in use maps bytes and characters one to one.

mod encoding;
mod format;
mod guess;
mod lines;

pub use encoding::Encoding;
pub use format::Format;
pub use lines::{LineColumn, LineEnd};

use crate::span::Span;
use encoding::Legacy;
use lines::Lines;

/// A file: its name, its text, and where its lines start.
#[derive(Clone, Debug, Default)]
pub struct Source {
    name: String,
    text: String,
    lines: Lines,
    legacy: Legacy,
    byte_order_mark: bool,
    format: Option<Format>,
}

impl Source {
    /// Decodes a file line by line: UTF-8 where a line is that, else Windows-1252 or CP850, whichever makes words of it.
    ///
    /// `name` is what diagnostics call the file; it is not opened. A file of more than 1 GiB is not kept: its text is
    /// empty, and [`Source::to_bytes`] gives no bytes.
    #[must_use]
    pub fn decode(name: impl Into<String>, bytes: Vec<u8>) -> Self {
        if bytes.len() > LIMIT {
            return Self {
                name: name.into(),
                format: Some(Format::TooLarge),
                ..Self::default()
            };
        }
        let (byte_order_mark, bytes) = strip_byte_order_mark(bytes);
        let format = Format::recognise(&bytes);
        let (text, legacy) = encoding::decode(bytes);
        Self {
            name: name.into(),
            lines: Lines::of(&text),
            text,
            legacy,
            byte_order_mark,
            format,
        }
    }

    /// What diagnostics call the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The decoded text, without the byte order mark.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The text of `span`; empty when it is not of this file.
    #[must_use]
    pub fn slice(&self, span: Span) -> &str {
        self.text.get(span.range()).unwrap_or_default()
    }

    /// Line and column where `span` starts.
    #[must_use]
    pub fn line_column(&self, span: Span) -> LineColumn {
        self.lines.line_column(&self.text, span.start)
    }

    /// The text of a line without its line end; empty when there is no such line. Lines count from 1.
    #[must_use]
    pub fn line_text(&self, line: u32) -> &str {
        self.slice(self.line_span(line))
    }

    /// Where the text of a line stands, without its line end. Lines count from 1.
    #[must_use]
    pub fn line_span(&self, line: u32) -> Span {
        let whole = self.whole_line(line);
        let text = self.slice(whole).trim_end_matches(['\r', '\n']);
        Span::of(whole.start as usize..whole.start as usize + text.len())
    }

    /// What ends a line. Lines count from 1.
    #[must_use]
    pub fn line_end(&self, line: u32) -> LineEnd {
        LineEnd::of(self.slice(self.whole_line(line)))
    }

    /// A line with its line end. Lines count from 1.
    pub(crate) fn whole_line(&self, line: u32) -> Span {
        self.lines.span(&self.text, line)
    }

    /// The lines, each with its line end.
    pub(crate) fn lines(&self) -> impl Iterator<Item = Span> {
        self.lines.spans(&self.text)
    }

    /// How many lines the file has. A line end at the very end starts no further line.
    #[must_use]
    pub fn line_count(&self) -> u32 {
        self.lines.count()
    }

    /// The encoding that a line was read in. Plain ASCII counts as UTF-8. Lines count from 1.
    #[must_use]
    pub fn encoding(&self, line: u32) -> Encoding {
        self.legacy.of_line(line)
    }

    /// The encoding of most lines that are not plain ASCII; what a new line is written in.
    #[must_use]
    pub fn prevailing_encoding(&self) -> Encoding {
        self.legacy.prevailing(&self.text)
    }

    /// Whether the file starts with the UTF-8 byte order mark.
    #[must_use]
    pub fn byte_order_mark(&self) -> bool {
        self.byte_order_mark
    }

    /// What the file is, when its bytes say that it is no EDS.
    pub(crate) fn foreign_format(&self) -> Option<Format> {
        self.format
    }

    /// The bytes of the file, as [`Source::decode`] got them.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.text.len() + BYTE_ORDER_MARK.len());
        if self.byte_order_mark {
            bytes.extend(BYTE_ORDER_MARK);
        }
        self.legacy.encode(&self.text, &mut bytes);
        bytes
    }
}

/// 1 GiB. A character takes at most three bytes of UTF-8, so that every offset into the text fits [`Span`].
const LIMIT: usize = 1 << 30;

/// U+FEFF in UTF-8.
pub(crate) const BYTE_ORDER_MARK: [u8; 3] = [0xEF, 0xBB, 0xBF];

fn strip_byte_order_mark(mut bytes: Vec<u8>) -> (bool, Vec<u8>) {
    let marked = bytes.starts_with(&BYTE_ORDER_MARK);
    if marked {
        bytes.drain(..BYTE_ORDER_MARK.len());
    }
    (marked, bytes)
}
