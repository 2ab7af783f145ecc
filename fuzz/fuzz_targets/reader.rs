//! Any bytes as an EDS: reading ends, and what was read is written back as it was.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let reading = lexican_eds::read("any.eds", bytes.to_vec());
    assert_eq!(reading.document.to_bytes(), bytes, "written back otherwise than it was read");
});
