//! The Rust source of a dictionary: an emitter for each generated item.

mod constants;
mod device;
mod dictionary;
pub(crate) mod facts;
pub(crate) mod handlers;
mod imports;
mod literal;
mod module_docs;
mod node;
pub(crate) mod rust_type;
mod table;
mod unit;

use syn::{File, Item as SynItem, ItemMod, parse_quote};

use crate::plan::Plan;

/// One item, `pub mod <name>`, so that `include!` takes it.
pub(crate) fn source(plan: &Plan<'_>) -> String {
    let file = File {
        shebang: None,
        frontmatter: None,
        attrs: Vec::new(),
        items: vec![SynItem::Mod(module(plan))],
    };
    let formatted = prettyplease::unparse(&file);
    // The module's closing brace; the table stands before it.
    let end = formatted.trim_end().len() - 1;
    let (items, brace) = formatted.split_at(end);
    format!("{}\n{}{brace}", items, table::text(plan))
}

fn module(plan: &Plan<'_>) -> ItemMod {
    let name = node::ident(&plan.module);
    let docs = module_docs::lines(plan);
    let mut module: ItemMod = parse_quote!(pub mod #name { #(#![doc = #docs])* });
    let mut items = imports::imports(plan);
    items.push(dictionary::declaration(plan));
    items.push(dictionary::implementation(plan));
    items.extend(handlers::declaration(plan));
    items.extend(device::declaration(plan));
    if let Some((_, content)) = &mut module.content {
        content.extend(items);
    }
    module
}
