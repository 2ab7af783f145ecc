//! A line as a terminal shows it: tabs widened, what could steer the terminal replaced, columns counted.

use std::ops::Range;

use unicode_width::UnicodeWidthChar as _;

/// A tab is shown this wide, wherever it stands.
const TAB: &str = "    ";

/// What a cut line shows in place of the part that is left out.
const ELLIPSIS: char = '…';

/// How one character of the line is shown.
struct Cell {
    /// Offset of its first byte in the line.
    offset: usize,
    shown: Shown,
    /// In columns.
    width: usize,
}

enum Shown {
    Tab,
    Char(char),
}

/// What is shown of a line, and where a range of it came to stand.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Excerpt {
    pub(super) text: String,
    /// Columns before the marked range.
    pub(super) indent: usize,
    /// Columns of the marked range, at least 1.
    pub(super) width: usize,
}

/// Shows `line` in at most about `columns` columns, so that `marked` (bytes of the line) is seen.
pub(super) fn excerpt(line: &str, marked: Range<usize>, columns: usize) -> Excerpt {
    let cells: Vec<Cell> = cells(line, near(line, marked.start, columns)).collect();
    let first = cells.partition_point(|cell| cell.offset < marked.start);
    let last = cells.partition_point(|cell| cell.offset < marked.end).max(first);
    let window = window(&cells, first..last, columns);

    let mut text = String::new();
    if window.start > 0 {
        text.push(ELLIPSIS);
    }
    let indent = text.chars().count() + width(&cells, window.start..first);
    for cell in cells.get(window.clone()).unwrap_or_default() {
        match cell.shown {
            Shown::Tab => text.push_str(TAB),
            Shown::Char(c) => text.push(c),
        }
    }
    if window.end < cells.len() {
        text.push(ELLIPSIS);
    }
    Excerpt {
        text,
        indent,
        width: width(&cells, first..last.min(window.end)).max(1),
    }
}

/// `text` as it may be printed: on one line, without a character that steers the terminal.
#[must_use]
pub fn printable(text: &str) -> String {
    text.chars().map(harmless).collect()
}

/// The part of a line, on character borders, outside of which nothing can be seen: a line may have 50 MB.
fn near(line: &str, at: usize, columns: usize) -> Range<usize> {
    let reach = columns.saturating_mul(8);
    let start = (0..=at.saturating_sub(reach))
        .rev()
        .find(|&at| line.is_char_boundary(at));
    let end = (at.saturating_add(reach)..line.len()).find(|&at| line.is_char_boundary(at));
    start.unwrap_or(0)..end.unwrap_or(line.len())
}

fn cells(line: &str, range: Range<usize>) -> impl Iterator<Item = Cell> + '_ {
    let shift = range.start;
    let text = line.get(range).unwrap_or_default();
    text.char_indices().map(move |(offset, c)| cell(shift + offset, c))
}

fn cell(offset: usize, c: char) -> Cell {
    if c == '\t' {
        let width = TAB.len();
        return Cell {
            offset,
            shown: Shown::Tab,
            width,
        };
    }
    let c = harmless(c);
    Cell {
        offset,
        shown: Shown::Char(c),
        width: c.width().unwrap_or(1),
    }
}

/// Control characters as their pictures (`␛`), and `�` for those that turn the direction of writing or cannot be seen.
fn harmless(c: char) -> char {
    match c {
        '\0'..='\x1F' => char::from_u32(0x2400 + u32::from(c)).unwrap_or(char::REPLACEMENT_CHARACTER),
        '\x7F' => '␡',
        '\u{80}'..='\u{9F}'
        | '\u{61C}'
        | '\u{200B}'..='\u{200F}'
        | '\u{2028}'..='\u{202E}'
        | '\u{2060}'..='\u{2069}'
        | '\u{FEFF}' => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}

/// The cells to show: all of a short line, else as many as fit, the marked ones behind some context.
fn window(cells: &[Cell], marked: Range<usize>, columns: usize) -> Range<usize> {
    if width(cells, 0..cells.len()) <= columns {
        return 0..cells.len();
    }
    let start = match width(cells, 0..marked.end) {
        up_to_mark if up_to_mark < columns => 0,
        _ => back(cells, marked.start, columns / 3),
    };
    let end = forth(cells, start, columns);
    if end == cells.len() {
        return back(cells, end, columns)..end;
    }
    start..end
}

/// The first of the cells before `from` that fit into `columns`.
fn back(cells: &[Cell], from: usize, columns: usize) -> usize {
    let before = cells.get(..from).unwrap_or_default();
    from - fitting(before.iter().rev(), columns)
}

/// The end of the cells after `from` that fit into `columns`.
fn forth(cells: &[Cell], from: usize, columns: usize) -> usize {
    let after = cells.get(from..).unwrap_or_default();
    from + fitting(after.iter(), columns)
}

fn fitting<'a>(cells: impl Iterator<Item = &'a Cell>, columns: usize) -> usize {
    cells
        .scan(0, |used, cell| {
            *used += cell.width;
            Some(*used)
        })
        .take_while(|&used| used <= columns)
        .count()
}

fn width(cells: &[Cell], range: Range<usize>) -> usize {
    let cells = cells.get(range).unwrap_or_default();
    cells.iter().map(|cell| cell.width).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The excerpt above its underline.
    fn shown(line: &str, marked: Range<usize>, columns: usize) -> String {
        let excerpt = excerpt(line, marked, columns);
        let (indent, carets) = (excerpt.indent, "^".repeat(excerpt.width));
        format!("{}\n{:indent$}{carets}", excerpt.text, "")
    }

    #[test]
    fn a_caret_stands_under_the_marked_bytes() {
        assert_eq!(shown("LowLimit=0xZZ", 9..13, 80), "LowLimit=0xZZ\n         ^^^^");
    }

    #[test]
    fn an_empty_range_gets_one_caret() {
        assert_eq!(shown("LowLimit=", 9..9, 80), "LowLimit=\n         ^");
    }

    #[test]
    fn a_tab_is_four_columns_wide() {
        assert_eq!(shown("A\t=\t9", 4..5, 80), "A    =    9\n          ^");
    }

    #[test]
    fn characters_of_two_columns_get_two_carets() {
        assert_eq!(shown("Name=電圧!", 5..11, 80), "Name=電圧!\n     ^^^^");
        assert_eq!(shown("Name=電圧!", 11..12, 80), "Name=電圧!\n         ^");
    }

    #[test]
    fn a_combining_mark_moves_no_caret() {
        assert_eq!(shown("e\u{301}=9", 4..5, 80), "e\u{301}=9\n  ^");
    }

    #[test]
    fn what_steers_a_terminal_is_shown_as_a_picture() {
        assert_eq!(
            printable("\u{1b}[31m\r\n\0\u{7f}\u{9b}\u{202e}"),
            "␛[31m␍␊␀␡\u{fffd}\u{fffd}"
        );
        assert_eq!(shown("\u{1b}]0;x\u{7}=9", 7..8, 80), "␛]0;x␇=9\n       ^");
    }

    #[test]
    fn a_long_line_is_cut_around_the_caret() {
        let line = format!("{}=0xZZ;{}", "k".repeat(500), "c".repeat(500));
        assert_eq!(
            shown(&line, 501..505, 30),
            "…kkkkkkkkk=0xZZ;ccccccccccccccc…\n           ^^^^"
        );
    }

    #[test]
    fn the_end_of_a_long_line_fills_the_window() {
        let line = format!("{}=0xZZ", "k".repeat(500));
        assert_eq!(
            shown(&line, 501..505, 20),
            "…kkkkkkkkkkkkkkk=0xZZ\n                 ^^^^"
        );
    }

    #[test]
    fn the_start_of_a_long_line_is_not_cut() {
        let line = format!("A=9{}", "c".repeat(500));
        assert_eq!(shown(&line, 2..3, 10), "A=9ccccccc…\n  ^");
    }

    #[test]
    fn a_marked_range_longer_than_the_window_is_cut_with_it() {
        let line = format!("A={}", "9".repeat(20_000));
        let excerpt = excerpt(&line, 2..20_002, 60);
        assert!(excerpt.text.starts_with("A=9") && excerpt.text.ends_with('…'));
        assert_eq!((excerpt.indent, excerpt.width), (2, 58));
    }
}
