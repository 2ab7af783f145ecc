//! What the EDS says of an object, in the words of a doc comment.

use lexican_eds::ir::{Address, Entry, Object, Value};

use super::literal::number_text;
pub(crate) use super::unit::unit;
use crate::plan::{Item, Storage};

/// The documentation of an item: a line with its facts, and of an array a line for each element that has its own.
pub(crate) fn facts(item: &Item<'_>) -> Vec<String> {
    let Some(first) = item.entries.first() else {
        return Vec::new();
    };
    let mut lines = vec![summary(item, first)];
    let own: Vec<String> = if item.is_array { elements(item) } else { Vec::new() };
    if !own.is_empty() {
        lines.push(String::new());
        lines.extend(own);
    }
    lines
}

/// `1017h `Producer heartbeat time`, `UNSIGNED16` in ms, rw, default `1000``
fn summary(item: &Item<'_>, first: &Entry) -> String {
    let mut words = vec![
        format!("{} {}", place(item), title(item.object, first, item.is_array)),
        type_words(first),
    ];
    words.push(first.access.name().to_owned());
    words.extend(common(item, limits));
    if item.storage != Storage::Constant {
        let parts = if item.storage == Storage::Parts {
            "in parts of "
        } else {
            ""
        };
        words.extend(
            item.kind
                .capacity()
                .map(|capacity| format!("{parts}at most {capacity} bytes")),
        );
        words.extend(common(item, default));
    }
    if item.entries.iter().any(|entry| entry.pdo_mapping) {
        words.push("PDO-mappable".to_owned());
    }
    words.join(", ")
}

/// `1017h`, `1018sub1`, `6030sub1 to 6030sub3`
fn place(item: &Item<'_>) -> String {
    match (item.entries, item.is_array) {
        ([first, .., last], true) => format!("{} to {}", first.address, last.address),
        ([first], _) => address(item.object, first.address),
        _ => format!("{:04X}h", item.object.index),
    }
}

/// `1017h`, or `1018sub1` where the object has sub-indices.
pub(crate) fn address(object: &Object, address: Address) -> String {
    if address.sub == 0 && object.entries.len() == 1 {
        format!("{:04X}h", address.index)
    } else {
        address.to_string()
    }
}

/// The names of the object and the value, quoted.
pub(crate) fn title(object: &Object, entry: &Entry, is_array: bool) -> String {
    if is_array || object.entries.len() == 1 || entry.name == object.name {
        quoted(&object.name)
    } else {
        format!("{}, {}", quoted(&object.name), quoted(&entry.name))
    }
}

fn type_words(entry: &Entry) -> String {
    match unit(entry.address) {
        Some(unit) => format!("`{}` in {unit}", entry.data_type.name()),
        None => format!("`{}`", entry.data_type.name()),
    }
}

/// What `fact` says of all values of `item` alike.
fn common(item: &Item<'_>, fact: impl Fn(&Entry) -> Option<String>) -> Option<String> {
    let mut facts = item.entries.iter().map(fact);
    let first = facts.next()??;
    facts.all(|other| other.as_ref() == Some(&first)).then_some(first)
}

/// `1 to 10`, `at least 1`, `at most 10`
pub(crate) fn limits(entry: &Entry) -> Option<String> {
    let text = |value: &Option<Value>| value.as_ref().and_then(|value| value_text(entry, value));
    match (text(&entry.low), text(&entry.high)) {
        (Some(low), Some(high)) => Some(format!("`{low}` to `{high}`")),
        (Some(low), None) => Some(format!("at least `{low}`")),
        (None, Some(high)) => Some(format!("at most `{high}`")),
        (None, None) => None,
    }
}

/// ``default `5` ``; ``configured as `5` `` where a DCF says so.
fn default(entry: &Entry) -> Option<String> {
    let word = if entry.configured { "configured as" } else { "default" };
    let value = value_text(entry, entry.default.as_ref()?)?;
    Some(format!("{word} {}", quoted(&value)))
}

/// A value for people.
pub(crate) fn value_text(entry: &Entry, value: &Value) -> Option<String> {
    match value {
        Value::Text(text) if text.is_empty() => None,
        Value::Text(text) => Some(text.clone()),
        Value::Bytes(bytes) if bytes.is_empty() => None,
        Value::Bytes(bytes) => Some(
            bytes
                .iter()
                .map(|byte| format!("{byte:02X}"))
                .collect::<Vec<_>>()
                .join(" "),
        ),
        Value::Time { days, milliseconds } => Some(format!("{days} d {milliseconds} ms")),
        Value::NodeIdPlus(0) => Some("$NODEID".to_owned()),
        Value::NodeIdPlus(base) => Some(format!("$NODEID+0x{base:X}")),
        Value::Boolean(value) => Some(value.to_string()),
        _ => number_text(entry, value),
    }
}

/// A line for each element of an array, if they are told apart by more than their number.
fn elements(item: &Item<'_>) -> Vec<String> {
    let letters = |entry: &Entry| entry.name.trim_end_matches(|c: char| c.is_ascii_hexdigit()).to_owned();
    let named_apart = common(item, |entry| Some(letters(entry))).is_none();
    let default_apart = common(item, |entry| Some(default(entry).unwrap_or_default())).is_none();
    let limits_apart = common(item, |entry| Some(limits(entry).unwrap_or_default())).is_none();
    if !(named_apart || default_apart || limits_apart) {
        return Vec::new();
    }
    let line = |(at, entry): (usize, &Entry)| {
        let facts = [
            Some(quoted(&entry.name)),
            limits(entry).filter(|_| limits_apart),
            default(entry).filter(|_| default_apart),
        ];
        let facts: Vec<String> = facts.into_iter().flatten().collect();
        format!("* `[{at}]`: {}", facts.join(", "))
    };
    item.entries.iter().enumerate().map(line).collect()
}

/// `text` in backticks on one line, whatever is in it: no Markdown, no HTML, nothing that turns the reading direction.
pub(crate) fn quoted(text: &str) -> String {
    let visible = show_invisible(text);
    let line = visible.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.is_empty() {
        return "(no name)".to_owned();
    }
    let longest = line.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    let pad = if longest > 0 { " " } else { "" };
    format!("{fence}{pad}{line}{pad}{fence}")
}

/// `text` with what cannot be seen in it by its number, and spaces for line ends and other control characters.
fn show_invisible(text: &str) -> String {
    let mut visible = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            ' '..='~' => visible.push(c),
            _ if c.is_whitespace() || c.is_control() => visible.push(' '),
            _ if c.escape_debug().count() == 1 => visible.push(c),
            _ => visible.extend(c.escape_unicode()),
        }
    }
    visible
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn a_name_cannot_leave_its_quotes() {
        assert_eq!(quoted("Speed [1/s] <b>"), "`Speed [1/s] <b>`");
        assert_eq!(quoted("a`b``c"), "``` a`b``c ```");
        assert_eq!(quoted("line\r\nnext\u{0} "), "`line next`");
        assert_eq!(quoted("\u{202E}evil"), r"`\u{202e}evil`");
        assert_eq!(quoted("Größe"), "`Größe`");
        assert_eq!(quoted(" \n"), "(no name)");
    }
}
