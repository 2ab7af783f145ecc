//! `[FileInfo]` (CiA 306-1, 4.4.1).

use super::field::{Fields, first};
use crate::document::{Keyword, Section};
use crate::span::{Span, Spanned};

/// `[FileInfo]`: about the file.
#[derive(Clone, Debug, Default)]
pub struct FileInfo {
    /// The section's header.
    pub header: Span,
    /// FileName
    pub file_name: Option<Spanned<String>>,
    /// FileVersion
    pub file_version: Option<Spanned<u32>>,
    /// FileRevision
    pub file_revision: Option<Spanned<u32>>,
    /// EDSVersion, `4.0`
    pub eds_version: Option<Spanned<String>>,
    /// Description
    pub description: Option<Spanned<String>>,
    /// CreationTime, `hh:mm(AM|PM)`
    pub creation_time: Option<Spanned<String>>,
    /// CreationDate, `mm-dd-yyyy`
    pub creation_date: Option<Spanned<String>>,
    /// CreatedBy
    pub created_by: Option<Spanned<String>>,
    /// ModificationTime, `hh:mm(AM|PM)`
    pub modification_time: Option<Spanned<String>>,
    /// ModificationDate, `mm-dd-yyyy`
    pub modification_date: Option<Spanned<String>>,
    /// ModifiedBy
    pub modified_by: Option<Spanned<String>>,
    /// LastEDS: what a DCF was made from.
    pub last_eds: Option<Spanned<String>>,
}

pub(super) fn read(fields: &mut Fields<'_>, section: &Section) -> FileInfo {
    let mut info = FileInfo {
        header: section.header,
        ..FileInfo::default()
    };
    for entry in &section.entries {
        match entry.keyword {
            Keyword::FileName => first(&mut info.file_name, fields.text(entry)),
            Keyword::FileVersion => first(&mut info.file_version, fields.number(entry)),
            Keyword::FileRevision => first(&mut info.file_revision, fields.number(entry)),
            Keyword::EdsVersion => first(&mut info.eds_version, fields.text(entry)),
            Keyword::Description => first(&mut info.description, fields.text(entry)),
            Keyword::CreationTime => first(&mut info.creation_time, fields.text(entry)),
            Keyword::CreationDate => first(&mut info.creation_date, fields.text(entry)),
            Keyword::CreatedBy => first(&mut info.created_by, fields.text(entry)),
            Keyword::ModificationTime => first(&mut info.modification_time, fields.text(entry)),
            Keyword::ModificationDate => first(&mut info.modification_date, fields.text(entry)),
            Keyword::ModifiedBy => first(&mut info.modified_by, fields.text(entry)),
            Keyword::LastEds => first(&mut info.last_eds, fields.text(entry)),
            _ => fields.misplaced(entry),
        }
    }
    info
}
