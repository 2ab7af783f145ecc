//! Where a rule puts what it finds.

use std::fmt::Write as _;

use super::{quote::quoted, rule::Facts};
use crate::{
    diagnostic::{Diagnostic, Level},
    literal,
    span::Span,
};

/// So many findings of one rule in one file are kept; nobody reads more, and a broken file of 50 MB can have millions.
const MOST: usize = 10_000;

/// Collects the findings of one rule, under its code and level.
#[derive(Debug)]
pub(crate) struct Report<'a> {
    /// The file's.
    text: &'a str,
    facts: &'static Facts,
    level: Level,
    /// At most one more than [`MOST`]: the last one then stands for all the others that are not kept.
    found: Vec<Diagnostic>,
    dropped: usize,
}

impl<'a> Report<'a> {
    pub(super) fn new(text: &'a str, facts: &'static Facts, level: Level) -> Self {
        Self {
            text,
            facts,
            level,
            found: Vec::new(),
            dropped: 0,
        }
    }

    /// The text at `span` for use in a message: in backticks, cut when it is long.
    pub(crate) fn quote(&self, span: Span) -> String {
        quoted(self.text(span))
    }

    /// The text at `span`.
    pub(crate) fn text(&self, span: Span) -> &'a str {
        let text = self.text.get(span.start as usize..span.end as usize);
        text.unwrap_or_default()
    }

    /// The part of the value at `span` that is no comment. Not for texts, which may have `#` and `;` in them.
    pub(crate) fn bare(&self, span: Span) -> Span {
        let length = u32::try_from(literal::bare(self.text(span)).len());
        Span::new(span.start, length.map_or(span.end, |length| span.start + length))
    }

    /// Reports `message` about `span`; [`Span::default`] stands for the file as a whole. The answer takes a label, related places and the cure.
    pub(crate) fn at(&mut self, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        if self.found.len() > MOST {
            self.found.truncate(MOST);
            self.dropped += 1;
        }
        self.found.push(Diagnostic {
            code: self.facts.code,
            level: self.level,
            span,
            section: None,
            message: message.into(),
            label: None,
            related: Vec::new(),
            help: None,
            fix: None,
        });
        let last = self.found.len() - 1;
        &mut self.found[last]
    }

    /// What was found; when that is too much, the last one kept says how much more there is.
    pub(super) fn into_found(mut self) -> Vec<Diagnostic> {
        if self.found.len() > MOST {
            self.found.truncate(MOST);
            let more = self.dropped + 1;
            if let Some(last) = self.found.last_mut() {
                let _ = write!(last.message, " (and {more} more in this file)");
            }
        }
        self.found
    }
}
