//! The trait that the application implements.

use quote::quote;
use syn::{Attribute, Item as SynItem, TraitItem, parse_quote};

use super::{
    facts::facts,
    node::{docs, ident},
    rust_type,
};
use crate::plan::{Item, Plan};

/// `Handlers`; without methods that have to be written it is implemented for `()` too.
pub(super) fn declaration(plan: &Plan<'_>) -> Vec<SynItem> {
    let methods: Vec<TraitItem> = plan
        .reads()
        .map(read)
        .chain(plan.writes().map(write))
        .chain(plan.parts().filter(|item| !item.reads.is_empty()).map(read_part))
        .chain(plan.parts().filter(|item| !item.writes.is_empty()).map(write_part))
        .collect();
    let declaration = parse_quote! {
        /// What the application answers for.
        pub trait Handlers {
            /// Told what happens on the bus and to the node. Does nothing unless overridden.
            fn event(&mut self, od: &mut Dictionary, event: Event) { let _ = (od, event); }
            #(#methods)*
        }
    };
    let nobody = parse_quote!(impl Handlers for () {});
    if methods.is_empty() {
        vec![declaration, nobody]
    } else {
        vec![declaration]
    }
}

fn read(item: &Item<'_>) -> TraitItem {
    let name = ident(&format!("read_{}", item.name));
    let docs = method_docs(
        item,
        "Called before a client reads it: gives the value, which is stored in `od` and sent.",
        "",
    );
    let (sub, value) = (sub_parameter(item), rust_type::read_type(item.kind));
    parse_quote! {
        #(#docs)*
        fn #name(&mut self, od: &mut Dictionary, #sub) -> Result<#value, AbortCode>;
    }
}

fn write(item: &Item<'_>) -> TraitItem {
    let name = ident(&format!("write_{}", item.name));
    let docs = method_docs(
        item,
        "Called before a client's value, which is within the limits, is stored in `od`.",
        "; then nothing is stored",
    );
    let (sub, value) = (sub_parameter(item), rust_type::written_type(item.kind));
    parse_quote! {
        #(#docs)*
        fn #name(&mut self, od: &mut Dictionary, #sub value: #value) -> Result<(), AbortCode>;
    }
}

fn read_part(item: &Item<'_>) -> TraitItem {
    let name = ident(&format!("read_{}", item.name));
    let docs = method_docs(
        item,
        "Called while a client reads it: copies its bytes from `offset` on into `buffer`, as many as there are and fit, and \
         gives the length of the whole value. [`lexican_runtime::od::copy_part`] does so with bytes in memory.",
        "",
    );
    let sub = sub_parameter(item);
    parse_quote! {
        #(#docs)*
        fn #name(&mut self, od: &mut Dictionary, #sub offset: usize, buffer: &mut [u8]) -> Result<usize, AbortCode>;
    }
}

fn write_part(item: &Item<'_>) -> TraitItem {
    let name = ident(&format!("write_{}", item.name));
    let docs = method_docs(
        item,
        "Called while a client writes it: once without bytes, when it begins, then with each part in turn.",
        "",
    );
    let sub = sub_parameter(item);
    parse_quote! {
        #(#docs)*
        fn #name(&mut self, od: &mut Dictionary, #sub part: Part<'_>) -> Result<(), AbortCode>;
    }
}

/// The sub-index, where there are several.
fn sub_parameter(item: &Item<'_>) -> Option<proc_macro2::TokenStream> {
    item.is_array.then(|| quote!(sub: u8,))
}

fn method_docs(item: &Item<'_>, what: &str, else_what: &str) -> Vec<Attribute> {
    let mut lines = facts(item);
    lines.extend([
        String::new(),
        what.to_owned(),
        String::new(),
        "# Errors".to_owned(),
        format!("The abort code that the client is answered with{else_what}."),
    ]);
    docs(&lines)
}
