//! What a rule is: facts, documentation and a check, all in one file.

use super::{Report, enc::Encoder};
use crate::{
    Reading,
    diagnostic::{Code, Level},
    document::Document,
    dump::Dump,
    ir::Dictionary,
    model::Eds,
    span::Span,
};

/// A rule, as users know it.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    pub(super) facts: &'static Facts,
    pub(super) check: Check,
}

/// What [`declare_rule!`](super::declare_rule) writes down.
#[derive(Debug)]
pub(crate) struct Facts {
    pub(crate) code: Code,
    pub(crate) level: Level,
    pub(crate) since: &'static str,
    pub(crate) fixable: Fixable,
    /// The path of the rule's module; its last part is the rule's name.
    pub(crate) module: &'static str,
    /// The lines of the doc comment, each as written behind `///`.
    pub(crate) documentation: &'static str,
}

/// Whether a rule's findings come with a [fix](crate::diagnostic::Diagnostic::fix).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fixable {
    /// The cure needs somebody who knows the device.
    Never,
    /// Where only one cure is possible.
    Sometimes,
    /// Each of them.
    Always,
}

/// The check, by what it looks at.
#[derive(Clone, Copy, Debug)]
pub(super) enum Check {
    Document(fn(&Document, &mut Report)),
    Model(fn(&Eds, &mut Report)),
    Dictionary(fn(&Dictionary, &mut Report)),
    Reading(fn(&Reading, &mut Report)),
    Encoder(fn(&Encoder<'_>, &mut Report)),
    Dump(fn(&Dictionary, &Dump, &mut Report)),
    Allowance(fn(&[Span], &mut Report)),
}

/// A type that stands for a rule. Made by [`declare_rule!`](super::declare_rule).
pub(crate) trait Declared {
    const FACTS: Facts;
}

/// Looks at lines, sections and keywords.
pub(crate) trait DocumentRule: Declared {
    fn check(document: &Document, report: &mut Report);
}

/// Looks at what each keyword says.
pub(crate) trait ModelRule: Declared {
    fn check(eds: &Eds, report: &mut Report);
}

/// Looks at the device that the file describes.
pub(crate) trait DictionaryRule: Declared {
    fn check(dictionary: &Dictionary, report: &mut Report);
}

/// Looks at several of these, or at what did not fit together on the way from one to the next.
pub(crate) trait ReadingRule: Declared {
    fn check(reading: &Reading, report: &mut Report);
}

/// Looks at a device of profile CiA 406.
pub(crate) trait EncoderRule: Declared {
    fn check(encoder: &Encoder<'_>, report: &mut Report);
}

/// Looks at what a device answered, and at the dictionary of its file.
pub(crate) trait DumpRule: Declared {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report);
}

/// Looks at what comments allow where nothing is found, when all other rules have run.
pub(crate) trait AllowanceRule: Declared {
    fn check(idle: &[Span], report: &mut Report);
}

impl Rule {
    pub(super) const fn document<R: DocumentRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Document(R::check),
        }
    }

    pub(super) const fn model<R: ModelRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Model(R::check),
        }
    }

    pub(super) const fn dictionary<R: DictionaryRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Dictionary(R::check),
        }
    }

    pub(super) const fn reading<R: ReadingRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Reading(R::check),
        }
    }

    pub(super) const fn encoder<R: EncoderRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Encoder(R::check),
        }
    }

    pub(super) const fn dump<R: DumpRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Dump(R::check),
        }
    }

    pub(super) const fn allowance<R: AllowanceRule>() -> Self {
        Self {
            facts: &R::FACTS,
            check: Check::Allowance(R::check),
        }
    }

    /// The code: `EDS004`.
    #[must_use]
    pub const fn code(&self) -> Code {
        self.facts.code
    }

    /// The level that holds unless the user says otherwise.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.facts.level
    }

    /// The version of Lexican that brought it.
    #[must_use]
    pub const fn since(&self) -> &'static str {
        self.facts.since
    }

    /// Whether `lexican check --fix` mends what it finds.
    #[must_use]
    pub const fn fixable(&self) -> Fixable {
        self.facts.fixable
    }

    /// What it finds, so that it reads well after "allow": `unreadable number`.
    #[must_use]
    pub fn name(&self) -> String {
        let module = self.facts.module;
        module.rsplit("::").next().unwrap_or(module).replace('_', " ")
    }

    /// The page about it in Markdown: *What it does*, *Why it matters*, *Example*, *Reference*, under second-level headings.
    #[must_use]
    pub fn documentation(&self) -> String {
        let lines = self.facts.documentation.lines();
        let lines = lines.map(|line| line.strip_prefix(' ').unwrap_or(line).to_owned() + "\n");
        lines.collect()
    }

    /// The first sentence of *What it does*.
    #[must_use]
    pub fn summary(&self) -> String {
        let page = self.documentation();
        let text = page.lines().skip(1).take_while(|line| !line.is_empty());
        let text = text.collect::<Vec<_>>().join(" ");
        match text.split_once(". ") {
            Some((first, _)) => format!("{first}."),
            None => text,
        }
    }

    /// Whether it looks at bytes and lines, so that it has something to say of any file.
    pub(super) fn is_about_text(&self) -> bool {
        self.code().family() == "INI"
    }

    /// Looks at a file as one of device profile `profile`; a rule about another profile or about dumps has nothing to look at.
    pub(super) fn check(&self, reading: &Reading, profile: u16, report: &mut Report) {
        match self.check {
            Check::Document(check) => check(&reading.document, report),
            Check::Model(check) => check(&reading.eds, report),
            Check::Dictionary(check) => check(&reading.dictionary, report),
            Check::Reading(check) => check(reading, report),
            Check::Encoder(check) if profile == Encoder::PROFILE => check(&Encoder::new(&reading.dictionary), report),
            Check::Encoder(_) | Check::Dump(_) | Check::Allowance(_) => {}
        }
    }

    /// Looks at comments that allow nothing; a rule about anything else has nothing to look at.
    pub(super) fn check_allowances(&self, idle: &[Span], report: &mut Report) {
        if let Check::Allowance(check) = self.check {
            check(idle, report);
        }
    }

    /// Looks at a dump; a rule about files has nothing to look at.
    pub(super) fn validate(&self, dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        if let Check::Dump(check) = self.check {
            check(dictionary, dump, report);
        }
    }
}

/// Declares a rule: its doc comment is what users read, the braces hold its facts, the module's name is its name.
///
/// `fixable: Always` or `fixable: Sometimes` promises that the findings come with a fix.
macro_rules! declare_rule {
    (@fixable) => { $crate::rules::Fixable::Never };
    (@fixable $fixable:ident) => { $crate::rules::Fixable::$fixable };
    (
        $(#[doc = $line:literal])+
        $visibility:vis $name:ident { code: $code:literal, level: $level:expr, since: $since:literal $(, fixable: $fixable:ident)? $(,)? }
    ) => {
        $(#[doc = $line])+
        $visibility struct $name;

        impl $crate::rules::rule::Declared for $name {
            const FACTS: $crate::rules::rule::Facts = $crate::rules::rule::Facts {
                code: $crate::diagnostic::Code::new($code),
                level: $level,
                since: $since,
                fixable: $crate::rules::declare_rule!(@fixable $($fixable)?),
                module: module_path!(),
                documentation: concat!($($line, "\n"),+),
            };
        }
    };
}

pub(crate) use declare_rule;
