//! Where a rule puts what it finds.

use super::rule::Facts;
use crate::{
    diagnostic::{Diagnostic, Level},
    span::Span,
};

/// Collects the findings of one rule, under its code and level.
#[derive(Debug)]
pub(crate) struct Report {
    facts: &'static Facts,
    level: Level,
    found: Vec<Diagnostic>,
}

impl Report {
    pub(super) fn new(facts: &'static Facts, level: Level) -> Self {
        let found = Vec::new();
        Self { facts, level, found }
    }

    /// Reports `message` about `span`; [`Span::default`] stands for the file as a whole. The answer takes a label, related places and the cure.
    pub(crate) fn at(&mut self, span: Span, message: impl Into<String>) -> &mut Diagnostic {
        self.found.push(Diagnostic {
            code: self.facts.code,
            level: self.level,
            span,
            message: message.into(),
            label: None,
            related: Vec::new(),
            help: None,
        });
        let last = self.found.len() - 1;
        &mut self.found[last]
    }

    pub(super) fn into_found(self) -> Vec<Diagnostic> {
        self.found
    }
}
