//! For people.

use std::io::{self, Write};

use lexican_eds::render::Renderer;

use super::Report;

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
        files => writeln!(out, "{}", summary(report, files)),
    }
}

/// `3 files checked: 1 error, 2 warnings`
fn summary(report: &Report, files: usize) -> String {
    let plural = if files == 1 { "" } else { "s" };
    format!("{files} file{plural} checked: {}", report.counts())
}
