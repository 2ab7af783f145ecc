//! `[Comments]` (CiA 306-1, 4.4.4).

use super::field::{Fields, first};
use super::list::{Item, List};
use crate::document::{Keyword, Section};
use crate::span::Spanned;

/// `[Comments]`: `Lines=2`, `Line1=…`, `Line2=…`.
pub type Comments = List<String>;

pub(super) fn read(fields: &mut Fields<'_>, section: &Section) -> Comments {
    let mut comments = Comments {
        header: section.header,
        count: None,
        items: Vec::new(),
    };
    for entry in &section.entries {
        match entry.keyword {
            Keyword::Lines => first(&mut comments.count, fields.number(entry)),
            Keyword::Line(number) => comments.items.push(Item {
                number: Spanned::new(number, entry.key),
                // A comment is no value that someone would put in quotes.
                value: Spanned::new(fields.slice(entry.value).to_owned(), entry.value),
            }),
            _ => fields.misplaced(entry),
        }
    }
    comments
}
