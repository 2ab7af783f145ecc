//! What is wrong, where, and how to mend it: plain data. How it looks is [`crate::render`]'s business.

use std::{fmt, str::FromStr};

use crate::{fix::Fix, span::Span};

/// How grave a finding is.
///
/// The order is from harmless to grave, so that levels can be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Not reported.
    Allow,
    /// A matter of style: every tool reads the file alike.
    Note,
    /// The standard is broken; tools still agree on what the device is.
    Warn,
    /// A master or a generator will go wrong. Stops generation; `lexican check` ends with 1.
    Deny,
}

impl Level {
    /// As users write it: `allow`, `note`, `warn`, `deny`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Allow => "allow",
            Self::Note => "note",
            Self::Warn => "warn",
            Self::Deny => "deny",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Level {
    type Err = UnknownLevel;

    /// Reads what [`Level::name`] writes, in any case.
    fn from_str(text: &str) -> Result<Self, UnknownLevel> {
        [Self::Allow, Self::Note, Self::Warn, Self::Deny]
            .into_iter()
            .find(|level| level.name().eq_ignore_ascii_case(text))
            .ok_or_else(|| UnknownLevel(text.to_owned()))
    }
}

/// No level has this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLevel(pub String);

impl fmt::Display for UnknownLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown level `{}`; use allow, note, warn or deny", self.0)
    }
}

impl std::error::Error for UnknownLevel {}

/// The stable name of a rule: family and number, `EDS004`. Codes are never used twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code(&'static str);

impl Code {
    pub(crate) const fn new(code: &'static str) -> Self {
        Self(code)
    }

    /// `EDS004`
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        self.0
    }

    /// The letters that say what the rule looks at: `EDS`.
    #[must_use]
    pub fn family(self) -> &'static str {
        self.0.trim_end_matches(|c: char| c.is_ascii_digit())
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.0)
    }
}

/// A finding.
///
/// ```
/// # fn first(reading: &lexican_eds::Reading) -> Option<()> {
/// use lexican_eds::rules::{self, Levels};
///
/// let diagnostic = rules::check(reading, &Levels::default()).into_iter().next()?;
/// let position = reading.document.source().line_column(diagnostic.span);
/// println!("{}: {} {}", position.line, diagnostic.code, diagnostic.message);
/// # Some(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule that found it.
    pub code: Code,
    /// How grave it is, after the user's [`Levels`](crate::rules::Levels).
    pub level: Level,
    /// What it is about. [`Span::default`] stands for the file as a whole.
    pub span: Span,
    /// The header of the section that the place is in, unless the place is on its line.
    pub section: Option<Span>,
    /// The fact, with the offending value; no full stop at the end.
    pub message: String,
    /// A few words beside the caret.
    pub label: Option<String>,
    /// Other places that matter.
    pub related: Vec<Related>,
    /// The cure, in the imperative.
    pub help: Option<String>,
    /// The cure as changes to the file, where it is safe to make them without asking.
    pub fix: Option<Fix>,
}

impl Diagnostic {
    /// Says a few words beside the caret.
    pub fn label(&mut self, label: impl Into<String>) -> &mut Self {
        self.label = Some(label.into());
        self
    }

    /// Points at another place that matters.
    pub fn related(&mut self, span: Span, label: impl Into<String>) -> &mut Self {
        let label = label.into();
        self.related.push(Related { span, label });
        self
    }

    /// Says how to mend it.
    pub fn help(&mut self, help: impl Into<String>) -> &mut Self {
        self.help = Some(help.into());
        self
    }

    /// Offers a safe cure, if there is one.
    pub fn fix(&mut self, fix: impl Into<Option<Fix>>) -> &mut Self {
        self.fix = fix.into();
        self
    }

    /// Whether it is about the file as a whole and not about a place in it.
    #[must_use]
    pub fn about_file(&self) -> bool {
        self.span == Span::default()
    }
}

/// A second place that a finding is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// The place.
    pub span: Span,
    /// A few words beside it.
    pub label: String,
}
