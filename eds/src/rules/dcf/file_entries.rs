//! UploadFile and DownloadFile (CiA 306-1, 5.2).

use crate::{
    Reading,
    document::{Entry, Keyword, SectionName},
    ir::{self, Address},
};

/// The keywords UploadFile and DownloadFile that have a value, each with the value of the dictionary that they stand at.
pub(super) fn file_entries(reading: &Reading) -> impl Iterator<Item = (&Entry, &ir::Entry)> {
    reading.document.sections().iter().flat_map(|section| {
        let address = match section.name {
            SectionName::Object(index) => Some(Address::new(index, 0)),
            SectionName::Sub(index, sub) => Some(Address::new(index, sub)),
            _ => None,
        };
        let value = address.and_then(|address| reading.dictionary.entry(address));
        let entries = section.entries.iter().filter(|entry| is_file(entry));
        entries.filter_map(move |entry| Some((entry, value?)))
    })
}

fn is_file(entry: &Entry) -> bool {
    matches!(entry.keyword, Keyword::UploadFile | Keyword::DownloadFile) && !entry.value.is_empty()
}
