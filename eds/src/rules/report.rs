//! Where a rule puts what it finds.

use super::{quote::quoted, rule::Facts};
use crate::{
    diagnostic::{Diagnostic, Level},
    literal,
    span::Span,
};

/// Collects the findings of one rule, under its code and level.
#[derive(Debug)]
pub(crate) struct Report<'a> {
    /// The file's.
    text: &'a str,
    facts: &'static Facts,
    level: Level,
    found: Vec<Diagnostic>,
}

impl<'a> Report<'a> {
    pub(super) fn new(text: &'a str, facts: &'static Facts, level: Level) -> Self {
        Self {
            text,
            facts,
            level,
            found: Vec::new(),
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

    pub(super) fn into_found(self) -> Vec<Diagnostic> {
        self.found
    }
}
