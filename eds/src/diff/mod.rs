//! What differs between two devices, as a master sees it.
//!
//! [`compare`] holds dictionaries against each other, not texts: where a keyword stands, how a number is written, whether
//! an object has the compact form makes no difference.

mod device;
mod entry;
mod object;
mod value;

use std::fmt;

use crate::{ir::Dictionary, span::Span};

/// What a difference does to a master that was made for the first device and meets the second.
///
/// The order is that of a report: what matters most comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Effect {
    /// Something that it could do is no longer possible, or comes out otherwise.
    Breaking,
    /// Something more is possible.
    Addition,
    /// Nothing: names, descriptions.
    Cosmetic,
}

impl Effect {
    /// `breaking`, `addition`, `cosmetic`
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Breaking => "breaking",
            Self::Addition => "addition",
            Self::Cosmetic => "cosmetic",
        }
    }
}

/// One difference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// What it does to a master.
    pub effect: Effect,
    /// What it is about: an object `1017`, a value `1018sub1`, a section `[DeviceInfo]`.
    pub subject: String,
    /// The subject's ParameterName, that of the second device where it has one; may be empty.
    pub name: String,
    /// Which fact differs, by its keyword in an EDS: `AccessType`. `None` where the subject as a whole came or went.
    pub fact: Option<&'static str>,
    /// The fact in the first device; `None` when it has none.
    pub before: Option<String>,
    /// The fact in the second device; `None` when it has none.
    pub after: Option<String>,
    /// Where the first file says so.
    pub old: Option<Span>,
    /// Where the second file says so.
    pub new: Option<Span>,
}

/// What differs between `old` and `new`: breaking differences first, within an effect the device before its objects, and
/// these by index.
///
/// ```
/// use lexican_eds::diff::{self, Effect};
///
/// let file = |access| format!("[1017]\nParameterName=Heartbeat\nDataType=0x0006\nAccessType={access}\n");
/// let old = lexican_eds::read("old.eds", file("rw").into());
/// let new = lexican_eds::read("new.eds", file("ro").into());
///
/// let found = diff::compare(&old.dictionary, &new.dictionary);
/// assert_eq!(found.len(), 1);
/// assert_eq!(found[0].effect, Effect::Breaking);
/// assert_eq!(found[0].to_string(), "1017 `Heartbeat`: AccessType was `rw`, is `ro`");
/// ```
#[must_use]
pub fn compare(old: &Dictionary, new: &Dictionary) -> Vec<Difference> {
    let mut found = Vec::new();
    device::compare(old, new, &mut found);
    object::compare(old, new, &mut found);
    found.sort_by_key(|difference| difference.effect);
    found
}

impl fmt::Display for Difference {
    /// `1017 `Heartbeat`: AccessType was `rw`, is `ro``
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.subject)?;
        if !self.name.is_empty() {
            write!(f, " `{}`", self.name)?;
        }
        let (before, after) = (self.before.as_deref(), self.after.as_deref());
        match (self.fact, before, after) {
            (None, None, _) => f.write_str(" is new"),
            (None, Some(_), _) => f.write_str(" is gone"),
            (Some(fact), Some(before), Some(after)) => write!(f, ": {fact} was `{before}`, is `{after}`"),
            (Some(fact), Some(before), None) => write!(f, ": {fact} was `{before}`, is not given"),
            (Some(fact), None, Some(after)) => write!(f, ": {fact} was not given, is `{after}`"),
            (Some(fact), None, None) => write!(f, ": {fact} differs"),
        }
    }
}

/// What has facts that can differ.
struct Subject {
    title: String,
    name: String,
}

impl Subject {
    /// The difference of a fact, if there is one.
    fn fact<T: PartialEq>(
        &self,
        fact: &'static str,
        (old, new): (T, T),
        shown: impl Fn(T) -> Option<String>,
        effect: Effect,
    ) -> Option<Difference> {
        if old == new {
            return None;
        }
        Some(Difference {
            effect,
            subject: self.title.clone(),
            name: self.name.clone(),
            fact: Some(fact),
            before: shown(old),
            after: shown(new),
            old: None,
            new: None,
        })
    }
}

impl Difference {
    /// At these places.
    fn at(self, old: Span, new: Span) -> Self {
        let place = |span: Span| (!span.is_empty()).then_some(span);
        Self {
            old: place(old),
            new: place(new),
            ..self
        }
    }
}

/// [`Effect::Breaking`] where something goes, [`Effect::Addition`] where it comes.
const fn goes(gone: bool) -> Effect {
    if gone { Effect::Breaking } else { Effect::Addition }
}
