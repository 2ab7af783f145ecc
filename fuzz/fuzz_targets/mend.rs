//! Any bytes as an EDS, mended: mending ends, and mending what came out, read anew, changes nothing more.

#![no_main]

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    fix,
    rules::{self, Levels},
};
use libfuzzer_sys::fuzz_target;

fn check(reading: &Reading) -> Vec<Diagnostic> {
    rules::check(reading, &Levels::default())
}

fuzz_target!(|bytes: &[u8]| {
    let mended = fix::mend(lexican_eds::read("any.eds", bytes.to_vec()), check);
    let once = mended.reading.document.to_bytes();
    let again = fix::mend(lexican_eds::read("any.eds", once.clone()), check);
    assert_eq!(again.reading.document.to_bytes(), once, "mending a second time changes the file");
});
