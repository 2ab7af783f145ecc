//! `lexican check --fix` and `--diff`: the safe cures, made or shown.

use std::io::Write as _;

use lexican_eds::{
    Reading,
    diagnostic::Level,
    fix::{self, Mended},
    render::Renderer,
};

use super::differences::Difference;
use crate::{
    Verdict,
    config::Settings,
    failure::{self, Failure},
    format::{Counts, Rendered, Style},
    input::Input,
    output::{self, Stdout},
    patch::{self, Reader},
};

/// Cures the file at `input` and says what is left.
pub(super) fn file(input: &Input, settings: &Settings, style: Style) -> Result<Rendered, Failure> {
    let mended = mend(lexican_eds::read(input.name(), input.read()?), settings);
    let document = &mended.reading.document;
    if let Input::File(path) = input
        && !mended.fixed.is_empty()
    {
        output::rewrite(path, &document.to_bytes())?;
    }
    let fixed = mended.fixed.values().sum();
    Ok(style.render(document, mended.remaining).with_fixed(fixed))
}

/// Cures standard input: the file goes to standard output, what is left in it to standard error.
pub(super) fn stdin(settings: &Settings, style: Style) -> Result<Verdict, Failure> {
    let input = Input::Stdin;
    let mended = mend(lexican_eds::read(input.name(), input.read()?), settings);
    Stdout::plain().print_bytes(&mended.reading.document.to_bytes())?;
    let source = mended.reading.document.source();
    let shown = mended
        .remaining
        .iter()
        .filter(|finding| finding.level >= style.min_level);
    let text: String = shown
        .map(|finding| Renderer::coloured().render(source, finding) + "\n")
        .collect();
    // Nobody is left to hear of it when stderr is gone.
    let _ = anstream::stderr().write_all(text.as_bytes());
    let counts: Counts = mended.remaining.iter().collect();
    let fixed: usize = mended.fixed.values().sum();
    if !style.quiet {
        failure::note(&format!("{fixed} fixed; left: {counts}"));
    }
    let denied = mended.remaining.iter().any(|finding| finding.level == Level::Deny);
    Ok(if denied { Verdict::Findings } else { Verdict::Clean })
}

/// The difference that the cures would make to `input`.
pub(super) fn difference(input: &Input, settings: &Settings, reader: Reader) -> Result<Difference, Failure> {
    let before = lexican_eds::read(input.name(), input.read()?);
    let mended = mend(before.clone(), settings);
    Ok(Difference {
        text: patch::unified(before.document.source(), mended.reading.document.source(), reader),
        findings: mended.fixed.values().sum(),
    })
}

fn mend(reading: Reading, settings: &Settings) -> Mended {
    fix::mend(reading, |reading| settings.check(reading))
}
