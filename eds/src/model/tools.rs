//! `[Tools]` and `[Toolx]`: programs of the vendor for the device.

use super::field::{Fields, first};
use crate::document::{Keyword, Section};
use crate::span::{Span, Spanned};

/// `[Tools]`
#[derive(Clone, Debug, Default)]
pub struct Tools {
    /// The header of `[Tools]`, if there is one.
    pub header: Option<Span>,
    /// Items: how many tools the file says there are.
    pub items: Option<Spanned<u32>>,
    /// In the order of the file.
    pub tools: Vec<Tool>,
}

/// `[Tool1]`
#[derive(Clone, Debug, Default)]
pub struct Tool {
    /// The number in the section's name.
    pub number: u16,
    /// The section's header.
    pub header: Span,
    /// Name
    pub name: Option<Spanned<String>>,
    /// Command, with `$EDS` and `$DCF` for the file.
    pub command: Option<Spanned<String>>,
}

impl Tools {
    pub(super) fn read(&mut self, fields: &mut Fields<'_>, section: &Section) {
        if self.header.is_some() {
            return;
        }
        self.header = Some(section.header);
        for entry in &section.entries {
            match entry.keyword {
                Keyword::Items => first(&mut self.items, fields.number(entry)),
                _ => fields.misplaced(entry),
            }
        }
    }

    pub(super) fn read_tool(&mut self, fields: &mut Fields<'_>, section: &Section, number: u16) {
        let mut tool = Tool {
            number,
            header: section.header,
            ..Tool::default()
        };
        for entry in &section.entries {
            match entry.keyword {
                Keyword::Name => first(&mut tool.name, fields.text(entry)),
                Keyword::Command => first(&mut tool.command, fields.text(entry)),
                _ => fields.misplaced(entry),
            }
        }
        self.tools.push(tool);
    }
}
