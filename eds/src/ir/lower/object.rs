//! One object.

use super::{Lowering, Problem, compact, entry};
use crate::document::Keyword;
use crate::ir::{Address, Entry, Object, ObjectCode};
use crate::model::{self, Description};

/// Lowers an object; its list is not known here. `None` if no section says that there is one.
pub(super) fn lower(object: &model::Object, lowering: &mut Lowering) -> Option<Object> {
    let code = code(object, lowering);
    let is_there = object.description.is_some() || !object.subs.is_empty();
    is_there.then(|| Object {
        index: object.index,
        name: object
            .description
            .as_ref()
            .map(|description| entry::text(description.parameter_name.as_ref()))
            .unwrap_or_default(),
        code,
        list: None,
        entries: entries(object, code, lowering),
        links: object
            .links
            .iter()
            .flat_map(|list| list.values())
            .map(|link| link.value)
            .collect(),
        span: object.header(),
    })
}

/// Whether an object of `code` has its values at sub-indices.
pub(super) const fn is_structured(code: ObjectCode) -> bool {
    matches!(code, ObjectCode::Array | ObjectCode::Record | ObjectCode::DefStruct)
}

/// ObjectType, unless the object's sections are those of another kind of object.
fn code(object: &model::Object, lowering: &mut Lowering) -> ObjectCode {
    let index = object.index;
    let Some(description) = &object.description else {
        lowering.report(Problem::OrphanedSubs {
            index,
            at: object.header(),
        });
        return ObjectCode::Record;
    };
    let shape = shape(object, description);
    let stated = description.object_type;
    match stated {
        Some(code) if is_structured(code.value) || shape == ObjectCode::Var => code.value,
        // A VAR that has a type of its own is one, whatever sub-objects it has.
        Some(code) if description.mentions(Keyword::DataType) => code.value,
        None if shape == ObjectCode::Var => shape,
        _ => {
            let at = stated.map_or(description.header, |code| code.span);
            lowering.report(Problem::AssumedObjectCode {
                index,
                assumed: shape,
                at,
            });
            shape
        }
    }
}

/// What the object's sections look like.
fn shape(object: &model::Object, description: &Description) -> ObjectCode {
    let is_compact = description.compact_sub_obj.is_some_and(|count| count.value != 0);
    let has_subs = !object.subs.is_empty() || description.sub_number.is_some_and(|count| count.value != 0);
    match (is_compact, has_subs) {
        (true, _) => ObjectCode::Array,
        (false, true) => ObjectCode::Record,
        (false, false) => ObjectCode::Var,
    }
}

fn entries(object: &model::Object, code: ObjectCode, lowering: &mut Lowering) -> Vec<Entry> {
    if is_structured(code) {
        return structure(object, code, lowering);
    }
    if let Some(sub) = object.subs.first() {
        lowering.report(Problem::SubsOfSingleValue {
            index: object.index,
            code,
            at: sub.description.header,
        });
    }
    let address = Address::new(object.index, 0);
    let single = |description| entry::lower(address, description, None, lowering);
    match code {
        ObjectCode::Null => Vec::new(),
        _ => object.description.as_ref().map(single).into_iter().collect(),
    }
}

fn structure(object: &model::Object, code: ObjectCode, lowering: &mut Lowering) -> Vec<Entry> {
    let mut entries = compact::expand(object, lowering);
    compact::apply_lists(object, &mut entries, lowering);
    let index = object.index;
    let at = object.header();
    let has_sub_zero = entries.first().is_some_and(|entry| entry.address.sub == 0);
    match entries.last() {
        // The definition of a record type may say no more than that there is one (CiA 301, 7.4.8).
        None if code == ObjectCode::DefStruct => {}
        None => lowering.report(Problem::NoSubs { index, at }),
        Some(_) if has_sub_zero => {}
        Some(last) => {
            let highest = last.address.sub;
            lowering.report(Problem::MissingSubZero { index, highest, at });
            entries.insert(0, entry::sub_zero(index, highest, at));
        }
    }
    entries
}
