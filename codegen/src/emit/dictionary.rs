//! The struct of values, its constants and its constructor.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Field, FieldValue, Fields, ImplItem, Item as SynItem, Visibility, parse_quote};

use super::{
    facts::facts,
    literal,
    node::{docs, field, field_value, ident, number},
    rust_type,
};
use crate::{
    name::field_ident,
    plan::{Item, Padding, Plan},
};
use lexican_eds::ir::Value;

/// So many formulas stand in one function: Clippy counts its lines.
const FORMULAS: usize = 25;

/// The struct.
pub(super) fn declaration(plan: &Plan<'_>) -> SynItem {
    let mut item: syn::ItemStruct = parse_quote! {
        /// The values of the dictionary: first those that are not 0 after power-on, and of both kinds the widest first.
        #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
        #[bytemuck(crate = "::lexican_runtime::bytemuck")]
        #[repr(C)]
        pub struct Dictionary {}
    };
    if let Fields::Named(fields) = &mut item.fields {
        fields.named.extend(with_padding(plan, declared, declared_padding));
    }
    SynItem::Struct(item)
}

fn declared(item: &Item<'_>) -> Field {
    let vis = Visibility::Public(syn::token::Pub::default());
    field(
        docs(&facts(item)),
        vis,
        &field_ident(&item.name),
        rust_type::field_type(item),
    )
}

fn declared_padding(name: &str, length: &Expr) -> Field {
    field(Vec::new(), Visibility::Inherited, name, parse_quote!([u8; #length]))
}

/// Something for each field, and for the bytes between and behind them.
fn with_padding<T>(plan: &Plan<'_>, of: fn(&Item<'_>) -> T, padding: fn(&str, &Expr) -> T) -> Vec<T> {
    let Padding { before, gap, end } = plan.padding();
    let fill = |name, bytes: usize| (bytes > 0).then(|| padding(name, &number(&bytes.to_string())));
    let mut all: Vec<T> = plan.fields().into_iter().map(of).collect();
    let rest = all.split_off(before);
    all.extend(fill("_gap", gap));
    all.extend(rest);
    all.extend(fill("_padding", end));
    all
}

/// The constants and the constructor.
pub(super) fn implementation(plan: &Plan<'_>) -> SynItem {
    let mut item: syn::ItemImpl = parse_quote!(impl Dictionary {});
    item.items.extend(plan.constants().map(constant));
    item.items.push(defaults(plan));
    item.items.extend(constructor(plan));
    SynItem::Impl(item)
}

fn constant(item: &Item<'_>) -> ImplItem {
    let docs = docs(&facts(item));
    let name = ident(&item.name.to_ascii_uppercase());
    let (rust_type, value) = (rust_type::constant_type(item), literal::constant(item));
    parse_quote!(#(#docs)* pub const #name: #rust_type = #value;)
}

fn defaults(plan: &Plan<'_>) -> ImplItem {
    let mut value: syn::ExprStruct = parse_quote!(Self {});
    value
        .fields
        .extend(with_padding(plan, initialized, initialized_padding));
    let mut defaults: syn::ImplItemConst = parse_quote! {
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {};
    };
    // Put in afterwards: so it is not taken apart and parsed again.
    defaults.expr = Expr::Struct(value);
    ImplItem::Const(defaults)
}

fn initialized(item: &Item<'_>) -> FieldValue {
    field_value(&field_ident(&item.name), literal::field_value(item))
}

fn initialized_padding(name: &str, length: &Expr) -> FieldValue {
    field_value(name, parse_quote!([0; #length]))
}

/// `new`, and what it calls when there are many formulas.
fn constructor(plan: &Plan<'_>) -> Vec<ImplItem> {
    let formulas: Vec<FieldValue> = plan
        .fields()
        .into_iter()
        .filter(|item| follows_node_id(item))
        .map(resolved)
        .collect();
    let (node_id, body) = match formulas.len() {
        0 => (quote!(_), quote!(Self::DEFAULTS)),
        1..=FORMULAS => (quote!(node_id), quote!(Self { #(#formulas,)* ..Self::DEFAULTS })),
        many => (quote!(node_id), chain(many.div_ceil(FORMULAS))),
    };
    let new = parse_quote! {
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(#node_id: NodeId) -> Self { #body }
    };
    let parts = formulas
        .chunks(FORMULAS)
        .enumerate()
        .filter(|_| formulas.len() > FORMULAS);
    let parts = parts.map(|(number, formulas)| part(number, formulas));
    [new].into_iter().chain(parts).collect()
}

/// `Self::DEFAULTS.resolve_0(node_id).resolve_1(node_id)`
fn chain(parts: usize) -> TokenStream {
    let calls = (0..parts).map(part_name);
    quote!(Self::DEFAULTS #(.#calls(node_id))*)
}

fn part(number: usize, formulas: &[FieldValue]) -> ImplItem {
    let name = part_name(number);
    parse_quote!(const fn #name(&self, node_id: NodeId) -> Self { Self { #(#formulas,)* ..*self } })
}

fn part_name(number: usize) -> syn::Ident {
    ident(&format!("resolve_{number}"))
}

fn follows_node_id(item: &Item<'_>) -> bool {
    item.entries
        .iter()
        .any(|entry| matches!(entry.default, Some(Value::NodeIdPlus(_))))
}

fn resolved(item: &Item<'_>) -> FieldValue {
    field_value(&field_ident(&item.name), literal::formula(item))
}
