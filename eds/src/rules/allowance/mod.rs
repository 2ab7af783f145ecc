//! Comments that allow a finding where it stands: `; lexican: allow(OBJ003)`.
//!
//! Above a line such a comment is about that line, above a section's header about the section; `allow-file` is about the file.

mod comment;

pub(crate) use comment::{Comment, Reach, comments};

use std::collections::HashMap;

use super::{all, levels};
use crate::{
    diagnostic::{Diagnostic, Level},
    document::Document,
    rules::Levels,
    span::Span,
};

/// What the comments of a file allow.
pub(super) struct Allowances<'a> {
    document: &'a Document,
    /// In the order of the file.
    allowed: Vec<Allowed>,
    /// The place in `allowed` of the first that says so.
    first: HashMap<(Place, &'static str), usize>,
}

/// A rule or a family that is allowed somewhere.
struct Allowed {
    selector: &'static str,
    /// Where the comment names it.
    at: Span,
    /// Whether it allowed something.
    used: bool,
}

/// Where something is allowed.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Place {
    File,
    /// By the start of its header.
    Section(u32),
    /// By its number.
    Line(u32),
}

impl<'a> Allowances<'a> {
    pub(super) fn read(document: &'a Document) -> Self {
        let mut allowances = Self {
            document,
            allowed: Vec::new(),
            first: HashMap::new(),
        };
        let mut below = LineBelow::default();
        for comment in comments(document.source()) {
            let Comment::Allow { line, reach, names } = comment else {
                continue;
            };
            let place = match reach {
                Reach::File => Place::File,
                Reach::Below => below.place(document, line),
            };
            for at in names {
                allowances.add(place, at);
            }
        }
        allowances
    }

    fn add(&mut self, place: Place, at: Span) {
        if let Some(selector) = levels::known(self.document.text(at)) {
            self.first.entry((place, selector)).or_insert(self.allowed.len());
            let used = false;
            self.allowed.push(Allowed { selector, at, used });
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.allowed.is_empty()
    }

    /// Whether `finding` is allowed: by the comment that is nearest to it.
    pub(super) fn cover(&mut self, finding: &Diagnostic) -> bool {
        let selectors = [finding.code.as_str(), finding.code.family()];
        let claims = places(self.document, finding).into_iter().flatten();
        let mut claims = claims.flat_map(|place| selectors.map(|selector| (place, selector)));
        let found = claims.find_map(|claim| self.first.get(&claim));
        let allowed = found.and_then(|number| self.allowed.get_mut(*number));
        allowed.map(|allowed| allowed.used = true).is_some()
    }

    /// What is named by a comment and allows nothing, though its rules were heard.
    pub(super) fn idle(&self, levels: &Levels) -> Vec<Span> {
        let idle = self.allowed.iter().filter(|allowed| !allowed.used);
        let judged = idle.filter(|allowed| was_heard(allowed.selector, levels));
        judged.map(|allowed| allowed.at).collect()
    }
}

/// Whether a rule that looks at files would have been heard. What a device would answer is not known here.
fn was_heard(selector: &str, levels: &Levels) -> bool {
    all().iter().any(|rule| {
        let (code, family) = (rule.code().as_str(), rule.code().family());
        [code, family].contains(&selector) && !["DMP", "LEX"].contains(&family) && levels.of(rule) > Level::Allow
    })
}

/// Where a comment may stand that allows `finding`, the nearest first.
fn places(document: &Document, finding: &Diagnostic) -> [Option<Place>; 3] {
    if finding.about_file() {
        return [Some(Place::File), None, None];
    }
    let line = document.source().line_column(finding.span).line;
    let section = header_before(document, finding.span.start);
    [Some(Place::Line(line)), section.map(Place::Section), Some(Place::File)]
}

/// The start of the header of the section that `offset` is in.
fn header_before(document: &Document, offset: u32) -> Option<u32> {
    let sections = document.sections();
    let following = sections.partition_point(|section| section.header.start <= offset);
    Some(sections.get(following.checked_sub(1)?)?.header.start)
}

/// The line below a comment. Of comments one below the other it is looked for once.
#[derive(Default)]
struct LineBelow {
    number: u32,
}

impl LineBelow {
    /// The line below that of number `comment` which is neither empty nor a comment, or the section that it begins.
    fn place(&mut self, document: &Document, comment: u32) -> Place {
        let source = document.source();
        if self.number <= comment {
            let is_comment = |number: &u32| {
                let text = source.line_text(*number).trim_start();
                text.is_empty() || text.starts_with(';')
            };
            let below = (comment + 1..=source.line_count()).find(|number| !is_comment(number));
            self.number = below.unwrap_or(source.line_count() + 1);
        }
        let line = source.line_span(self.number);
        match header_before(document, line.end) {
            Some(header) if !line.is_empty() && header >= line.start => Place::Section(header),
            _ => Place::Line(self.number),
        }
    }
}
