//! How a diagnostic looks: a head line that editors jump to, the lines of the file, carets under the very value, the cure.
//!
//! ```text
//! pump.eds:120:14: error[OBJ003]: DefaultValue `0xZZ` cannot be read as UNSIGNED32
//!     |
//! 119 | DataType=0x0007
//!     |          ------ UNSIGNED32
//! 120 | DefaultValue=0xZZ
//!     |              ^^^^
//!     |
//!     = help: write a number, such as `0x10`
//! ```
//!
//! Nothing of the file or its name reaches the output unless it is printable.

mod cells;
mod palette;
mod snippet;

pub use cells::printable;

use crate::{
    diagnostic::{Diagnostic, Level},
    source::Source,
};
use palette::Palette;
use snippet::Snippet;

/// Turns diagnostics into text.
#[derive(Clone, Copy, Debug)]
pub struct Renderer {
    palette: Palette,
    columns: usize,
}

impl Renderer {
    /// Without an escape sequence.
    #[must_use]
    pub const fn plain() -> Self {
        Self {
            palette: Palette::PLAIN,
            columns: 120,
        }
    }

    /// With the colours of rustc, as ANSI escape sequences.
    #[must_use]
    pub const fn coloured() -> Self {
        Self {
            palette: Palette::COLOURED,
            columns: 120,
        }
    }

    /// Cuts lines of the file to about `columns` (default 120, at least 40) around the caret.
    #[must_use]
    pub const fn columns(self, columns: usize) -> Self {
        let columns = if columns < 40 { 40 } else { columns };
        Self { columns, ..self }
    }

    /// The whole diagnostic about `source`; ends with a line feed.
    #[must_use]
    pub fn render(&self, source: &Source, diagnostic: &Diagnostic) -> String {
        let mut text = self.head(source, diagnostic);
        let snippet = Snippet::new(source, diagnostic);
        text.push_str(&snippet.render(&self.palette, self.columns));
        if let Some(help) = &diagnostic.help {
            text.push_str(&self.help(help, &snippet));
        }
        text
    }

    /// `pump.eds:120:14: error[OBJ003]: …`: the form of compilers, which editors and CI services know.
    fn head(&self, source: &Source, diagnostic: &Diagnostic) -> String {
        let position = source.line_column(diagnostic.span);
        let (word, style) = self.palette.level(diagnostic.level);
        let Palette { path, message, .. } = self.palette;
        format!(
            "{path}{}:{}:{}:{path:#} {style}{word}[{}]{style:#}{message}: {}{message:#}\n",
            printable(source.name()),
            position.line,
            position.column,
            diagnostic.code,
            printable(&diagnostic.message),
        )
    }

    fn help(&self, help: &str, snippet: &Snippet) -> String {
        let Palette { gutter, word, .. } = self.palette;
        let indent = snippet.gutter_width();
        format!(
            "{:indent$} {gutter}={gutter:#} {word}help{word:#}: {}\n",
            "",
            printable(help)
        )
    }
}

/// The number of findings at a level, as the last line of a report says it: `1 error`, `3 warnings`.
#[must_use]
pub fn count(level: Level, number: usize) -> String {
    let (word, _) = Palette::PLAIN.level(level);
    format!("{number} {word}{}", if number == 1 { "" } else { "s" })
}
