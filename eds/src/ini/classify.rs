//! What a line is.

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LineKind {
    Blank,
    Comment,
    Header,
    Pair,
    Junk,
}

/// What `line`, without its line end, is.
pub(super) fn classify(line: &str) -> LineKind {
    let line = line.trim();
    match line.as_bytes().first() {
        None => LineKind::Blank,
        Some(b';' | b'#') => LineKind::Comment,
        Some(b'[') => LineKind::Header,
        Some(b'=') => LineKind::Junk,
        _ if line.contains('=') => LineKind::Pair,
        _ => LineKind::Junk,
    }
}
