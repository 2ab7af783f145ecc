//! For people.

use std::io::{self, Write};

use lexican_eds::render::Renderer;

use super::{Report, Subject};

/// Writes each finding with its line of the file, and a summary at the end.
pub(super) fn write(report: &Report, out: &mut impl Write) -> io::Result<()> {
    let renderer = Renderer::coloured();
    for checked in &report.checked {
        for diagnostic in &checked.diagnostics {
            writeln!(out, "{}", renderer.render(checked.document.source(), diagnostic))?;
        }
    }
    match report.checked.len() {
        0 => Ok(()),
        number => writeln!(out, "{}", summary(report, number)),
    }
}

/// `3 files checked: 1 error, 2 warnings`
fn summary(report: &Report, number: usize) -> String {
    let subject = match report.subject {
        Subject::File => "file",
        Subject::Device => "device",
    };
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {subject}{plural} checked: {}", report.counts())
}
