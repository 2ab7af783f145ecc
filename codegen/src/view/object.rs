//! The objects and their values, as templates see them.

use lexican_eds::ir::{AccessType, Entry, Object, ObjectCode, ObjectList};
use lexican_templates::{Value, context};

use crate::{
    emit::facts::{limits, unit, value_text},
    name::field_ident,
    plan::{Item, Plan, Storage},
};

/// The parts of an object dictionary (CiA 301, table 43).
const AREAS: [(&str, u16, u16); 5] = [
    ("Data types", 0x0001, 0x0FFF),
    ("Communication", 0x1000, 0x1FFF),
    ("Manufacturer", 0x2000, 0x5FFF),
    ("Device profile", 0x6000, 0x9FFF),
    ("Others", 0xA000, 0xFFFF),
];

pub(super) fn objects(plan: &Plan<'_>) -> Vec<Value> {
    plan.dictionary.objects.iter().map(|each| object(plan, each)).collect()
}

/// The objects by the part of the dictionary that they are in, without empty parts.
pub(super) fn areas(plan: &Plan<'_>) -> Vec<Value> {
    let within = |first: u16, last: u16| -> Vec<Value> {
        let objects = plan.dictionary.objects.iter();
        let objects = objects.filter(|object| (first..=last).contains(&object.index));
        objects.map(|each| object(plan, each)).collect()
    };
    let areas = AREAS.iter().map(|&(title, first, last)| (title, within(first, last)));
    let areas = areas.filter(|(_, objects)| !objects.is_empty());
    areas.map(|(title, objects)| context! { title, objects }).collect()
}

fn object(plan: &Plan<'_>, object: &Object) -> Value {
    let entries: Vec<Value> = object.entries.iter().map(|each| entry(plan, object, each)).collect();
    context! {
        index => object.index,
        name => object.name.as_str(),
        code => code(object.code),
        list => object.list.map(list),
        links => object.links.clone(),
        entries,
    }
}

fn entry(plan: &Plan<'_>, object: &Object, entry: &Entry) -> Value {
    let item = plan.item(entry.address);
    context! {
        index => entry.address.index,
        sub => entry.address.sub,
        name => name(object, entry),
        data_type => entry.data_type.name(),
        bits => entry.data_type.bits(),
        access => entry.access.name(),
        readable => entry.access.readable(),
        writable => entry.access.writable(),
        pdo_mapping => entry.pdo_mapping,
        pdo => pdo(entry),
        default => entry.default.as_ref().and_then(|value| value_text(entry, value)),
        configured => entry.configured,
        low => entry.low.as_ref().and_then(|value| value_text(entry, value)),
        high => entry.high.as_ref().and_then(|value| value_text(entry, value)),
        limits => limits(entry),
        unit => unit(entry.address),
        denotation => entry.denotation.as_deref(),
        refuse_write_on_download => entry.refuse_write_on_download,
        refuse_read_on_scan => entry.refuse_read_on_scan,
        upload_file => entry.upload_file.as_deref(),
        download_file => entry.download_file.as_deref(),
        rust_name => item.map(rust_name),
        is_constant => item.is_some_and(|item| item.storage == Storage::Constant),
        capacity => item.and_then(|item| item.kind.capacity()),
    }
}

/// The name of the value; the object's where it has none of its own.
fn name<'a>(object: &'a Object, entry: &'a Entry) -> &'a str {
    if entry.name.is_empty() {
        &object.name
    } else {
        &entry.name
    }
}

/// What the value is called in `Dictionary`, without the element of an array.
fn rust_name(item: &Item<'_>) -> String {
    match item.storage {
        Storage::Field => field_ident(&item.name),
        Storage::Parts => item.name.clone(),
        Storage::Constant => item.name.to_ascii_uppercase(),
    }
}

/// The PDOs that it may be mapped into: `T`, `R`, `TR` or nothing.
fn pdo(entry: &Entry) -> &'static str {
    match entry.access {
        _ if !entry.pdo_mapping => "",
        AccessType::Const | AccessType::Ro | AccessType::Rwr => "T",
        AccessType::Wo | AccessType::Rww => "R",
        AccessType::Rw => "TR",
    }
}

/// The standard's name.
fn code(code: ObjectCode) -> &'static str {
    match code {
        ObjectCode::Null => "NULL",
        ObjectCode::Domain => "DOMAIN",
        ObjectCode::DefType => "DEFTYPE",
        ObjectCode::DefStruct => "DEFSTRUCT",
        ObjectCode::Var => "VAR",
        ObjectCode::Array => "ARRAY",
        ObjectCode::Record => "RECORD",
    }
}

fn list(list: ObjectList) -> &'static str {
    match list {
        ObjectList::Mandatory => "mandatory",
        ObjectList::Optional => "optional",
        ObjectList::Manufacturer => "manufacturer",
    }
}
