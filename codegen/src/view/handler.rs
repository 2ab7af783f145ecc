//! The methods of `Handlers`, as templates see them.

use std::collections::BTreeSet;

use lexican_templates::{Value, context};
use quote::ToTokens as _;

use crate::{
    emit::{
        facts::{address, title},
        rust_type,
    },
    name::field_ident,
    plan::{Item, Kind, Plan},
};

/// The methods, in the trait's order.
pub(super) fn handlers(plan: &Plan<'_>) -> Vec<Value> {
    plan.reads()
        .map(read)
        .chain(plan.writes().map(write))
        .chain(plan.parts().filter(|item| !item.reads.is_empty()).map(read_part))
        .chain(plan.parts().filter(|item| !item.writes.is_empty()).map(write_part))
        .collect()
}

/// The types of the runtime's module `od` that the methods name.
pub(super) fn imports(plan: &Plan<'_>) -> Vec<&'static str> {
    let strings = plan.reads().filter_map(|item| match item.kind {
        Kind::Visible(_) => Some("VisibleString"),
        Kind::Octets(_) => Some("OctetString"),
        _ => None,
    });
    let times = plan
        .reads()
        .chain(plan.writes())
        .filter(|item| item.kind == Kind::Time)
        .map(|_| "TimeOfDay");
    let parts = plan.parts().filter(|item| !item.writes.is_empty()).map(|_| "Part");
    strings
        .chain(times)
        .chain(parts)
        .collect::<BTreeSet<_>>()
        .into_iter()
        .collect()
}

fn read(item: &Item<'_>) -> Value {
    let rust_type = text(&rust_type::read_type(item.kind));
    context! {
        method => format!("read_{}", item.name),
        about => about(item),
        index => item.object.index,
        subs => item.reads.clone(),
        parameters => parameters(item, "od", None),
        returns => format!("Result<{rust_type}, AbortCode>"),
        body => stored(item),
    }
}

fn write(item: &Item<'_>) -> Value {
    let rust_type = text(&rust_type::written_type(item.kind));
    context! {
        method => format!("write_{}", item.name),
        about => about(item),
        index => item.object.index,
        subs => item.writes.clone(),
        parameters => parameters(item, "_od", Some(&rust_type)),
        returns => "Result<(), AbortCode>",
        body => "Ok(())",
    }
}

fn read_part(item: &Item<'_>) -> Value {
    let mut parameters = parameters(item, "_od", Some("usize"));
    parameters.pop();
    parameters.extend(["_offset: usize".to_owned(), "_buffer: &mut [u8]".to_owned()]);
    context! {
        method => format!("read_{}", item.name),
        about => about(item),
        index => item.object.index,
        subs => item.reads.clone(),
        parameters => parameters,
        returns => "Result<usize, AbortCode>",
        body => "Err(AbortCode::NO_DATA)",
    }
}

fn write_part(item: &Item<'_>) -> Value {
    let mut parameters = parameters(item, "_od", Some("Part<'_>"));
    parameters.pop();
    parameters.push("_part: Part<'_>".to_owned());
    context! {
        method => format!("write_{}", item.name),
        about => about(item),
        index => item.object.index,
        subs => item.writes.clone(),
        parameters => parameters,
        returns => "Result<(), AbortCode>",
        body => "Ok(())",
    }
}

/// ``6003h `Preset value` ``
fn about(item: &Item<'_>) -> String {
    let Some(first) = item.entries.first() else {
        return String::new();
    };
    let address = if item.is_array {
        format!("{:04X}h", item.object.index)
    } else {
        address(item.object, first.address)
    };
    format!("{address} {}", title(item.object, first, item.is_array))
}

fn parameters(item: &Item<'_>, od: &str, value: Option<&str>) -> Vec<String> {
    let mut parameters = vec!["&mut self".to_owned(), format!("{od}: &mut Dictionary")];
    if item.is_array {
        let unused = if value.is_some() { "_" } else { "" };
        parameters.push(format!("{unused}sub: u8"));
    }
    parameters.extend(value.map(|value| format!("_value: {value}")));
    parameters
}

/// The value as it is stored.
fn stored(item: &Item<'_>) -> String {
    let field = field_ident(&item.name);
    match (item.is_array, item.kind) {
        (false, Kind::Boolean) => format!("Ok(od.{field}.get())"),
        (false, _) => format!("Ok(od.{field})"),
        (true, kind) => {
            let value = if kind == Kind::Boolean {
                "map(|value| value.get())"
            } else {
                "copied()"
            };
            // As rustfmt breaks it, in a method of a trait.
            [
                &format!("od.{field}"),
                "get(usize::from(sub).wrapping_sub(1))",
                value,
                "ok_or(AbortCode::NO_SUCH_SUB_INDEX)",
            ]
            .join("\n            .")
        }
    }
}

/// A type as one writes it.
fn text(rust_type: &syn::Type) -> String {
    rust_type.to_token_stream().to_string().replace(' ', "")
}
