//! For people.

use std::fmt::Write as _;

use lexican_eds::render::Renderer;

use super::{Checked, Form, Run, Subject};

pub(super) struct Text;

impl Form for Text {
    /// Each finding with its line of the file.
    fn file(&self, checked: &Checked) -> String {
        let renderer = Renderer::coloured();
        let mut text = String::new();
        for finding in checked.findings {
            let _ = writeln!(text, "{}", renderer.render(checked.source, finding));
        }
        text
    }

    /// The summary, and what to do next.
    fn end(&self, run: &Run) -> String {
        match run.files {
            0 => String::new(),
            _ if run.fixable == 0 => format!("{run}\n"),
            _ => format!("{run}\n`--fix` mends {} of them, `--diff` shows how\n", run.fixable),
        }
    }
}

impl std::fmt::Display for Run {
    /// `3 files checked: 1 error, 2 warnings (12 below --min-level not shown)`
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let subject = match self.subject {
            Subject::File => "file",
            Subject::Device => "device",
        };
        let plural = if self.files == 1 { "" } else { "s" };
        write!(f, "{} {subject}{plural} checked: {}", self.files, self.counts)?;
        if self.hidden > 0 {
            write!(f, " ({} below --min-level not shown)", self.hidden)?;
        }
        if self.fixed > 0 {
            write!(f, "; {} fixed", self.fixed)?;
        }
        Ok(())
    }
}
