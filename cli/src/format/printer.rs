//! From files' findings to standard output.

use std::{collections::BTreeSet, io::Write as _};

use lexican_eds::{
    diagnostic::{Code, Diagnostic, Level},
    document::Document,
};

use super::{Checked, Counts, Format, Run, Subject};
use crate::{
    Verdict,
    failure::Failure,
    output::{Stdout, unwritten},
};

/// How findings are shown, and which.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub(crate) format: Format,
    /// Findings below it are counted only.
    pub(crate) min_level: Level,
    /// Nothing is said of what is in order.
    pub(crate) quiet: bool,
}

/// A file's findings as text.
#[derive(Debug)]
pub(crate) struct Rendered {
    text: String,
    counts: Counts,
    hidden: usize,
    /// How many findings have a safe cure.
    fixable: usize,
    /// How many findings were cured.
    fixed: usize,
    codes: BTreeSet<Code>,
}

impl Style {
    /// What there is to say of one file.
    pub(crate) fn render(self, document: &Document, found: Vec<Diagnostic>) -> Rendered {
        let total = found.len();
        let shown = found.into_iter().filter(|finding| finding.level >= self.min_level);
        let findings: Vec<Diagnostic> = shown.collect();
        let checked = Checked {
            document,
            source: document.source(),
            findings: &findings,
        };
        Rendered {
            text: self.format.form().file(&checked),
            counts: findings.iter().collect(),
            hidden: total - findings.len(),
            fixable: findings.iter().filter(|finding| finding.fix.is_some()).count(),
            fixed: 0,
            codes: findings.iter().map(|finding| finding.code).collect(),
        }
    }
}

impl Rendered {
    /// Of a file in which `fixed` findings were cured.
    pub(crate) fn with_fixed(self, fixed: usize) -> Self {
        Self { fixed, ..self }
    }
}

/// Prints the findings to standard output, what could not be read to standard error.
pub(crate) struct Printer {
    style: Style,
    out: Stdout,
    run: Run,
    /// Whether a file had something to print.
    has_text: bool,
}

impl Printer {
    /// Begins to print what is said of things like `subject`.
    pub(crate) fn new(style: Style, subject: Subject) -> Result<Self, Failure> {
        let out = if style.format.is_for_people() {
            Stdout::styled()
        } else {
            Stdout::plain()
        };
        let run = Run {
            subject,
            ..Run::default()
        };
        let mut printer = Self {
            style,
            out,
            run,
            has_text: false,
        };
        printer.write(&style.format.form().begin())?;
        Ok(printer)
    }

    /// Prints what there is to say of the next file.
    pub(crate) fn file(&mut self, rendered: Rendered) -> Result<(), Failure> {
        if self.has_text && !rendered.text.is_empty() {
            self.write(self.style.format.form().between())?;
        }
        self.has_text |= !rendered.text.is_empty();
        self.write(&rendered.text)?;
        self.run.add(rendered);
        Ok(())
    }

    /// Keeps what could not be read until the end.
    pub(crate) fn failure(&mut self, failure: Failure) {
        self.run.failures.push(failure);
    }

    /// Prints what holds for the whole run.
    pub(crate) fn finish(mut self) -> Result<Verdict, Failure> {
        if !(self.style.quiet && self.style.format.is_for_people()) {
            self.write(&self.style.format.form().end(&self.run))?;
        }
        self.out.finish()?;
        self.run.failures.iter().for_each(Failure::print);
        Ok(self.run.verdict())
    }

    fn write(&mut self, text: &str) -> Result<(), Failure> {
        self.out.write_all(text.as_bytes()).map_err(|error| unwritten(&error))
    }
}

impl Run {
    fn add(&mut self, rendered: Rendered) {
        self.files += 1;
        self.counts += rendered.counts;
        self.hidden += rendered.hidden;
        self.fixable += rendered.fixable;
        self.fixed += rendered.fixed;
        self.codes.extend(rendered.codes);
    }

    fn verdict(&self) -> Verdict {
        match (self.failures.is_empty(), self.counts.deny) {
            (false, _) => Verdict::Incomplete,
            (true, 0) => Verdict::Clean,
            (true, _) => Verdict::Findings,
        }
    }
}
