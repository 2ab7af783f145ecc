//! Values as Rust writes them.

use lexican_eds::ir::{Entry, Value};
use proc_macro2::Literal;
use syn::{Expr, Lit, parse_quote};

use super::{
    constants::near_constant,
    node::{literal, number, path},
};
use crate::plan::{Item, Kind, Width};

/// The value of a field; `$NODEID` counts as 0.
pub(super) fn field_value(item: &Item<'_>) -> Expr {
    of_item(item, |entry| stored(entry, item.kind))
}

/// The value of a field of the node `node_id`.
pub(super) fn formula(item: &Item<'_>) -> Expr {
    of_item(item, |entry| match entry.default {
        Some(Value::NodeIdPlus(base)) => plus(entry, item.kind, base),
        _ => stored(entry, item.kind),
    })
}

/// The value of a constant.
pub(super) fn constant(item: &Item<'_>) -> Expr {
    of_item(item, |entry| match (&entry.default, item.kind) {
        (Some(Value::Text(text)), _) => literal(Lit::new(string(text))),
        (Some(Value::Bytes(bytes)), _) => byte_slice(bytes),
        (Some(Value::Boolean(value)), _) => boolean(*value),
        (_, kind) => stored(entry, kind),
    })
}

/// A number as generated code and its documentation write it; `None` for what is no number.
pub(crate) fn number_text(entry: &Entry, value: &Value) -> Option<String> {
    match *value {
        Value::Boolean(value) => Some(u8::from(value).to_string()),
        Value::Integer(value) => Some(integer(value)),
        Value::Unsigned(value) if is_bit_field(entry) => Some(hex(value, 8)),
        Value::Unsigned(value) => Some(grouped(&value.to_string(), 3)),
        Value::NodeIdPlus(base) => Some(hex(base, digits(entry))),
        Value::Real32(value) => Some(real(&format!("{value:?}"), &format!("{value:e}"))),
        Value::Real64(value) => Some(real(&format!("{value:?}"), &format!("{value:e}"))),
        Value::Text(_) | Value::Bytes(_) | Value::Time { .. } => None,
    }
}

/// The one expression, or the array of them.
fn of_item(item: &Item<'_>, element: impl Fn(&Entry) -> Expr) -> Expr {
    let elements: Vec<Expr> = item.entries.iter().map(element).collect();
    match elements.as_slice() {
        [single] if !item.is_array => single.clone(),
        [first, rest @ ..] if rest.len() > 1 && same(item) => {
            let length = number(&elements.len().to_string());
            parse_quote!([#first; #length])
        }
        elements => parse_quote!([#(#elements),*]),
    }
}

/// Whether all elements have the same value.
fn same(item: &Item<'_>) -> bool {
    item.entries.windows(2).all(|pair| pair[0].default == pair[1].default)
}

/// The value as it stands in the struct.
fn stored(entry: &Entry, kind: Kind) -> Expr {
    match kind {
        Kind::Boolean => {
            let value = boolean(entry.default == Some(Value::Boolean(true)));
            parse_quote!(Boolean::new(#value))
        }
        Kind::Signed(_) | Kind::Unsigned(_) => integer_value(entry),
        Kind::Real32 => real_value(entry, "f32"),
        Kind::Real64 => real_value(entry, "f64"),
        Kind::Time => time(entry),
        Kind::Visible(_) => string_value("VisibleString", entry),
        Kind::Octets(_) => string_value("OctetString", entry),
    }
}

fn integer_value(entry: &Entry) -> Expr {
    match &entry.default {
        Some(value @ (Value::Integer(_) | Value::Unsigned(_) | Value::NodeIdPlus(_))) => {
            signed_number(&number_text(entry, value).unwrap_or_default())
        }
        _ => number("0"),
    }
}

fn real_value(entry: &Entry, rust: &str) -> Expr {
    let text = entry.default.as_ref().and_then(|value| number_text(entry, value));
    let name = path(rust);
    match text.as_deref() {
        Some("NaN") => parse_quote!(#name::NAN),
        Some("inf") => parse_quote!(#name::INFINITY),
        Some("-inf") => parse_quote!(#name::NEG_INFINITY),
        Some(text) => match near_constant(&text.replace('_', ""), rust) {
            Some(expr) if text.starts_with('-') => parse_quote!(-#expr),
            Some(expr) => expr,
            None => signed_number(text),
        },
        None => signed_number("0.0"),
    }
}

fn time(entry: &Entry) -> Expr {
    let (days, milliseconds) = match entry.default {
        Some(Value::Time { days, milliseconds }) => (u64::from(days), u64::from(milliseconds)),
        _ => (0, 0),
    };
    let [days, milliseconds] = [days, milliseconds].map(|value| number(&grouped(&value.to_string(), 3)));
    parse_quote!(TimeOfDay::new(#days, #milliseconds))
}

/// A string that is written in ASCII if it can be.
fn string_value(name: &str, entry: &Entry) -> Expr {
    let name = path(name);
    let bytes = entry
        .default
        .as_ref()
        .map(|value| value.to_bytes(entry.data_type, None));
    match bytes.as_deref() {
        None | Some([]) => parse_quote!(#name::EMPTY),
        Some(bytes) if bytes.is_ascii() => {
            let text = literal(Lit::new(Literal::byte_string(bytes)));
            parse_quote!(#name::new(#text))
        }
        Some(bytes) => {
            let bytes = byte_slice(bytes);
            parse_quote!(#name::new(#bytes))
        }
    }
}

/// `node_id.plus_u32(0x0000_0180)`
fn plus(entry: &Entry, kind: Kind, base: u64) -> Expr {
    let (method, base) = match kind {
        Kind::Signed(width) => (
            format!("plus_i{}", width.bits()),
            signed_number(&signed_base(base, width)),
        ),
        Kind::Unsigned(width) => (format!("plus_u{}", width.bits()), number(&hex(base, digits(entry)))),
        _ => return stored(entry, kind),
    };
    let method = super::node::ident(&method);
    parse_quote!(node_id.#method(#base))
}

/// The base of a formula in a signed type of this width.
#[expect(clippy::cast_possible_wrap, reason = "two's complement is what the formula means")]
fn signed_base(base: u64, width: Width) -> String {
    let unused = 64 - width.bits();
    integer(((base << unused) as i64) >> unused)
}

fn boolean(value: bool) -> Expr {
    literal(Lit::Bool(syn::LitBool::new(value, proc_macro2::Span::call_site())))
}

fn byte_slice(bytes: &[u8]) -> Expr {
    let bytes = bytes.iter().map(|byte| number(&format!("0x{byte:02X}")));
    parse_quote!(&[#(#bytes),*])
}

/// A number with its sign.
pub(super) fn signed_number(text: &str) -> Expr {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let is_real = unsigned.contains(['.', 'e']) && !unsigned.starts_with("0x");
    let value = if is_real {
        literal(Lit::Float(syn::LitFloat::new(unsigned, proc_macro2::Span::call_site())))
    } else {
        number(unsigned)
    };
    if text.starts_with('-') {
        parse_quote!(-#value)
    } else {
        value
    }
}

/// The UNSIGNED32 of the communication area are COB-IDs, mappings and signatures: fields of bits.
fn is_bit_field(entry: &Entry) -> bool {
    let bits = entry.data_type.bits().unwrap_or_default();
    (0x1000..=0x1FFF).contains(&entry.address.index) && bits == 32
}

/// The hexadecimal digits of an integer type in Rust.
fn digits(entry: &Entry) -> usize {
    Kind::new(entry.data_type, 0).size() * 2
}

/// `0x0002_0196`
fn hex(value: u64, digits: usize) -> String {
    format!("0x{}", grouped(&format!("{value:0digits$X}"), 4))
}

fn integer(value: i64) -> String {
    let sign = if value < 0 { "-" } else { "" };
    format!("{sign}{}", grouped(&value.unsigned_abs().to_string(), 3))
}

/// `digits` with an underscore before every group of so many, if there is need of one.
pub(super) fn grouped(digits: &str, group: usize) -> String {
    if digits.len() <= 5 && group == 3 {
        return digits.to_owned();
    }
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(group) {
            text.push('_');
        }
        text.push(digit);
    }
    text
}

/// A real number, given as decimals and with an exponent: short decimals are easier to read than an exponent.
fn real(decimals: &str, exponent: &str) -> String {
    let digits = decimals.trim_start_matches('-');
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, "0"));
    let is_short = whole.len() <= 5 && fraction.len() <= 5;
    let is_number = digits.starts_with(|c: char| c.is_ascii_digit());
    if !is_number || is_short && !decimals.contains('e') {
        return decimals.to_owned();
    }
    let (mantissa, power) = exponent.split_once('e').unwrap_or((exponent, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, "0"));
    match power {
        "0" => format!("{whole}.{}", grouped_fraction(fraction)),
        power => format!("{whole}.{}e{power}", grouped_fraction(fraction)),
    }
}

/// Digits behind the point, grouped from it.
fn grouped_fraction(digits: &str) -> String {
    if digits.len() <= 5 {
        return digits.to_owned();
    }
    let digits: Vec<char> = digits.chars().collect();
    let groups: Vec<String> = digits.chunks(3).map(|group| group.iter().collect()).collect();
    groups.join("_")
}

/// A text, with what is not Latin-1 or not visible escaped.
fn string(text: &str) -> Literal {
    let mut escaped = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => escaped.extend(['\\', c]),
            ' '..='~' | '\u{A1}'..='\u{AC}' | '\u{AE}'..='\u{FF}' => escaped.push(c),
            _ => escaped.extend(c.escape_default()),
        }
    }
    escaped.push('"');
    escaped.parse().unwrap_or_else(|_| Literal::string(text))
}

#[cfg(test)]
mod tests {
    use super::{grouped, hex, integer, real, signed_base, string};
    use crate::plan::Width;

    #[test]
    fn digits_are_grouped_as_clippy_asks() {
        assert_eq!(integer(10_000), "10000");
        assert_eq!(integer(-100_000), "-100_000");
        assert_eq!(integer(i64::MIN), "-9_223_372_036_854_775_808");
        assert_eq!(hex(0x1_8000, 8), "0x0001_8000");
        assert_eq!(hex(0x1_0000_0000, 16), "0x0000_0001_0000_0000");
        assert_eq!(hex(0x80, 2), "0x80");
        assert_eq!(grouped("1234567", 3), "1_234_567");
    }

    #[test]
    fn reals_are_short_or_have_an_exponent() {
        let text = |value: f32| real(&format!("{value:?}"), &format!("{value:e}"));
        assert_eq!(text(0.25), "0.25");
        assert_eq!(text(-1.5), "-1.5");
        assert_eq!(text(100_000.0), "1.0e5");
        assert_eq!(text(1.234_567_9), "1.234_567_9");
        assert_eq!(text(0.123_456_79), "1.234_567_9e-1");
        assert_eq!(text(1e-20), "1.0e-20");
        assert_eq!(text(f32::NAN), "NaN");
    }

    #[test]
    fn a_formula_of_a_signed_type_keeps_its_sign() {
        assert_eq!(signed_base(0xFF80, Width::W16), "-128");
        assert_eq!(signed_base(0x80, Width::W16), "128");
    }

    #[test]
    fn a_text_shows_what_can_be_seen_and_escapes_the_rest() {
        assert_eq!(
            string("Gr\u{F6}\u{DF}e \"x\"\n\u{202E}").to_string(),
            r#""Größe \"x\"\n\u{202e}""#
        );
    }
}
