//! The filters beside minijinja's own.

use minijinja::Environment;

/// Makes them known.
pub(crate) fn add(environment: &mut Environment<'_>) {
    environment.add_filter("hex", hex);
    environment.add_filter("markdown", |text: &str| markdown(text));
    environment.add_filter("code", |text: &str| code(text));
}

/// `value` with at least so many digits.
fn hex(value: u64, digits: usize) -> String {
    format!("{value:0digits$X}")
}

/// `text` in backticks, on one line and safe in a table.
fn code(text: &str) -> String {
    let line = one_line(text).replace('|', "\\|");
    let longest = line.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    let pad = if longest > 0 { " " } else { "" };
    format!("{fence}{pad}{line}{pad}{fence}")
}

/// `text` on one line, with what Markdown and its tables would take for a sign escaped.
fn markdown(text: &str) -> String {
    let mut escaped = String::new();
    for c in one_line(text).chars() {
        if matches!(
            c,
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '|' | '&'
        ) {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
