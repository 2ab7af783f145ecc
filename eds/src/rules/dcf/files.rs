//! Whether a file is called a DCF or an EDS.

use crate::document::Document;

/// Whether the file's name ends in `.dcf`.
pub(super) fn is_named_dcf(document: &Document) -> bool {
    ends_in(document, *b".dcf")
}

/// Whether the file's name ends in `.eds`.
pub(super) fn is_named_eds(document: &Document) -> bool {
    ends_in(document, *b".eds")
}

fn ends_in(document: &Document, extension: [u8; 4]) -> bool {
    let name = document.source().name().as_bytes();
    let end = name.last_chunk();
    end.is_some_and(|end: &[u8; 4]| end.eq_ignore_ascii_case(&extension))
}
