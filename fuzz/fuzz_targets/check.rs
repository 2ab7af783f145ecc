//! Any bytes as an EDS, judged by all rules: it ends, every finding has a place in the file, and nothing of the file steers the
//! terminal.

#![no_main]

use lexican_eds::{
    render::Renderer,
    rules::{self, Levels},
};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let reading = lexican_eds::read("any.eds", bytes.to_vec());
    let source = reading.document.source();
    for finding in rules::check(&reading, &Levels::default()) {
        let text = Renderer::plain().render(source, &finding);
        assert!(!text.chars().any(|c| c.is_control() && c != '\n'), "{text:?}");
    }
});
