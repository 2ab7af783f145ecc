//! The colours, those of rustc.

use anstyle::{AnsiColor, Color, Style};

use crate::diagnostic::Level;

/// A style for each part of a rendered diagnostic.
#[derive(Clone, Copy, Debug)]
pub(super) struct Palette {
    pub(super) path: Style,
    pub(super) message: Style,
    pub(super) gutter: Style,
    pub(super) word: Style,
    levels: [Style; 3],
}

impl Palette {
    /// Prints no escape sequence at all.
    pub(super) const PLAIN: Self = Self {
        path: Style::new(),
        message: Style::new(),
        gutter: Style::new(),
        word: Style::new(),
        levels: [Style::new(); 3],
    };

    pub(super) const COLOURED: Self = Self {
        path: Style::new().bold(),
        message: Style::new().bold(),
        gutter: bold(AnsiColor::BrightBlue),
        word: bold(AnsiColor::BrightCyan),
        levels: [
            bold(AnsiColor::BrightRed),
            bold(AnsiColor::BrightYellow),
            bold(AnsiColor::BrightGreen),
        ],
    };

    /// The word that stands for `level` in the head line, its colour and that of its carets.
    pub(super) const fn level(&self, level: Level) -> (&'static str, Style) {
        let [error, warning, note] = self.levels;
        match level {
            Level::Deny => ("error", error),
            Level::Warn => ("warning", warning),
            Level::Note | Level::Allow => ("note", note),
        }
    }
}

const fn bold(color: AnsiColor) -> Style {
    Style::new().bold().fg_color(Some(Color::Ansi(color)))
}
