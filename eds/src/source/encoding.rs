//! UTF-8, Windows-1252 or CP850, line by line.

/// How a line's bytes become characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// UTF-8, and with it ASCII.
    #[default]
    Utf8,
    /// Windows-1252, the superset of ISO 8859-1 that Windows' ANSI programs write.
    Windows1252,
    /// CP850, what DOS programs wrote.
    Cp850,
}

/// The lines that are not UTF-8.
#[derive(Clone, Debug, Default)]
pub(super) struct Legacy {
    lines: Vec<(u32, Encoding)>,
}

impl Legacy {
    pub(super) fn of_line(&self, line: u32) -> Encoding {
        let at = self.lines.binary_search_by_key(&line, |(line, _)| *line);
        at.ok()
            .and_then(|at| self.lines.get(at))
            .map_or(Encoding::Utf8, |(_, encoding)| *encoding)
    }
}

pub(super) fn decode(bytes: Vec<u8>) -> (String, Legacy) {
    match String::from_utf8(bytes) {
        Ok(text) => (text, Legacy::default()),
        Err(error) => (
            String::from_utf8_lossy(error.as_bytes()).into_owned(),
            Legacy::default(),
        ),
    }
}
