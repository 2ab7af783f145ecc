//! The Rust types of values.

use syn::{Type, parse_quote};

use super::node::{named_type, number};
use crate::plan::{Item, Kind};

/// The type of a field of the struct.
pub(super) fn field_type(item: &Item<'_>) -> Type {
    of_item(item, stored_type(item.kind))
}

/// The type of a constant.
pub(super) fn constant_type(item: &Item<'_>) -> Type {
    let element = match item.kind {
        Kind::Visible(_) => parse_quote!(&'static str),
        Kind::Octets(_) if is_text(item) => parse_quote!(&'static str),
        Kind::Octets(_) => parse_quote!(&'static [u8]),
        kind => read_type(kind),
    };
    of_item(item, element)
}

/// Whether the octets of a constant are a UNICODE_STRING's, which Rust has a type for.
pub(super) fn is_text(item: &Item<'_>) -> bool {
    let text = |value: &_| matches!(value, lexican_eds::ir::Value::Text(_));
    item.entries.iter().filter_map(|entry| entry.default.as_ref()).all(text)
}

/// The type that a handler gives when a value is read.
pub(crate) fn read_type(kind: Kind) -> Type {
    match kind {
        Kind::Boolean => named_type("bool"),
        kind => stored_type(kind),
    }
}

/// The type that a handler takes when a value is written.
pub(crate) fn written_type(kind: Kind) -> Type {
    match kind {
        Kind::Visible(_) | Kind::Octets(_) => parse_quote!(&[u8]),
        kind => read_type(kind),
    }
}

/// How the runtime's `Value` is asked for that type.
pub(super) fn conversion(kind: Kind) -> String {
    match kind {
        Kind::Boolean => "to_bool".to_owned(),
        Kind::Signed(width) => format!("to_i{}", width.bits()),
        Kind::Unsigned(width) => format!("to_u{}", width.bits()),
        Kind::Real32 => "to_f32".to_owned(),
        Kind::Real64 => "to_f64".to_owned(),
        Kind::Time => "to_time".to_owned(),
        Kind::Visible(_) | Kind::Octets(_) => "to_bytes".to_owned(),
    }
}

/// `element`, or an array of it.
fn of_item(item: &Item<'_>, element: Type) -> Type {
    if !item.is_array {
        return element;
    }
    let length = number(&item.entries.len().to_string());
    parse_quote!([#element; #length])
}

/// The type as it stands in the struct.
fn stored_type(kind: Kind) -> Type {
    match kind {
        Kind::Boolean => named_type("Boolean"),
        Kind::Signed(width) => named_type(&format!("i{}", width.bits())),
        Kind::Unsigned(width) => named_type(&format!("u{}", width.bits())),
        Kind::Real32 => named_type("f32"),
        Kind::Real64 => named_type("f64"),
        Kind::Time => named_type("TimeOfDay"),
        Kind::Visible(capacity) => string_type("VisibleString", capacity),
        Kind::Octets(capacity) => string_type("OctetString", capacity),
    }
}

fn string_type(name: &str, capacity: usize) -> Type {
    let (name, capacity) = (super::node::ident(name), number(&capacity.to_string()));
    parse_quote!(#name<#capacity>)
}
