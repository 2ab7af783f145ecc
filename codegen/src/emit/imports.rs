//! What a generated module uses, and nothing else.

use syn::{Item as SynItem, parse_quote};

use super::node::ident;
use crate::plan::{Kind, Plan};

/// The module's `use` items.
pub(super) fn imports(plan: &Plan<'_>) -> Vec<SynItem> {
    let mut items: Vec<SynItem> = Vec::new();
    if !plan.fields().is_empty() {
        items.push(parse_quote!(
            use core::mem::offset_of;
        ));
    }
    let names = runtime_names(plan).into_iter().map(ident);
    items.push(parse_quote!(
        use lexican_runtime::{AbortCode, Address, Event, NodeId, bytemuck};
    ));
    items.push(parse_quote!(use lexican_runtime::od::{#(#names),*};));
    items
}

/// The names of the runtime's module `od`, in alphabetical order, functions last.
fn runtime_names(plan: &Plan<'_>) -> Vec<&'static str> {
    let kinds = |wanted: fn(Kind) -> bool| plan.fields().iter().any(|item| wanted(item.kind));
    let names = [
        (!plan.rows.is_empty(), "Access"),
        (kinds(|kind| kind == Kind::Boolean), "Boolean"),
        (!plan.rows.is_empty(), "DataType"),
        (true, "Extra"),
        (true, "NumberSet"),
        (kinds(|kind| matches!(kind, Kind::Octets(_))), "OctetString"),
        (plan.parts().any(|item| !item.writes.is_empty()), "Part"),
        (true, "Row"),
        (true, "ServiceSet"),
        (true, "Table"),
        (plan.items.iter().any(|item| item.kind == Kind::Time), "TimeOfDay"),
        (true, "Value"),
        (kinds(|kind| matches!(kind, Kind::Visible(_))), "VisibleString"),
        (true, "place"),
        (true, "resized"),
        (plan.reads().any(|item| item.is_array), "set_element"),
        (true, "written"),
    ];
    names
        .into_iter()
        .filter(|(used, _)| *used)
        .map(|(_, name)| name)
        .collect()
}
