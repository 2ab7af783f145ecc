//! What templates see: the IR, and what was made of it.

mod device;
mod handler;
mod object;
mod pdo;

use lexican_templates::{Value, context};

use crate::plan::Plan;

/// The context of every template; [`Generated::render`](crate::Generated::render) lists it.
pub(crate) fn context(plan: &Plan<'_>) -> Value {
    let dictionary = plan.dictionary;
    context! {
        module => plan.module.as_str(),
        file => device::file(plan),
        device => device::device(&dictionary.device),
        commissioning => dictionary.commissioning.as_ref().map(device::commissioning),
        objects => object::objects(plan),
        areas => object::areas(plan),
        pdos => pdo::pdos(dictionary),
        handlers => handler::handlers(plan),
        imports => handler::imports(plan),
    }
}
