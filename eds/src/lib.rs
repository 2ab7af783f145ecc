//! CANopen EDS and DCF files (CiA 306-1): read, understood, judged, written back.
//!
//! bytes → source → document → model → [`ir::Dictionary`]
//!
//! Each stage has one verb and never fails: what it cannot make sense of becomes a problem with a position,
//! and the rules turn problems into diagnostics.

pub mod devices;
pub mod diagnostic;
pub mod diff;
pub mod document;
pub mod dump;
pub mod fix;
pub mod format;
mod ini;
pub mod ir;
pub mod literal;
pub mod model;
pub mod render;
pub mod rules;
pub mod source;
pub mod span;

use document::Document;
use ir::Dictionary;
use model::Eds;
use source::Source;

/// A file, read from one end to the other.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// Its lines, sections and keywords.
    pub document: Document,
    /// What they say.
    pub eds: Eds,
    /// What the device is.
    pub dictionary: Dictionary,
    /// What did not fit together, so that something in the dictionary was made up or left out.
    pub problems: Vec<ir::Problem>,
}

/// Reads a file; `name` is what diagnostics call it.
#[must_use]
pub fn read(name: impl Into<String>, bytes: Vec<u8>) -> Reading {
    read_document(Document::read(Source::decode(name, bytes)))
}

/// Reads a document that was edited.
fn read_document(document: Document) -> Reading {
    let eds = Eds::interpret(&document);
    let (dictionary, problems) = Dictionary::lower(&eds);
    Reading {
        document,
        eds,
        dictionary,
        problems,
    }
}
