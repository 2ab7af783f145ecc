//! The PDOs, as templates see them.

use lexican_eds::ir::{Dictionary, Direction, Entry, MappedObject, Pdo};
use lexican_templates::{Value, context};

use crate::emit::facts::value_text;

/// The RPDOs, then the TPDOs.
pub(super) fn pdos(dictionary: &Dictionary) -> Vec<Value> {
    let all = dictionary
        .pdos(Direction::Receive)
        .chain(dictionary.pdos(Direction::Transmit));
    all.map(|each| pdo(dictionary, &each)).collect()
}

fn pdo(dictionary: &Dictionary, pdo: &Pdo<'_>) -> Value {
    let mapped: Vec<MappedObject> = pdo.mapped().collect();
    let bits: u32 = mapped.iter().map(|mapped| u32::from(mapped.bits)).sum();
    let mapped: Vec<Value> = mapped.iter().map(|each| mapped_object(dictionary, each)).collect();
    context! {
        direction => match pdo.direction {
            Direction::Receive => "RPDO",
            Direction::Transmit => "TPDO",
        },
        number => pdo.number,
        cob_id => parameter(pdo, 1),
        transmission_type => parameter(pdo, 2),
        inhibit_time => parameter(pdo, 3),
        event_timer => parameter(pdo, 5),
        bits,
        mapped,
    }
}

/// The default of a communication parameter.
fn parameter(pdo: &Pdo<'_>, sub: u8) -> Option<String> {
    let entry = pdo.communication?.entry(sub)?;
    value_text(entry, entry.default.as_ref()?)
}

fn mapped_object(dictionary: &Dictionary, mapped: &MappedObject) -> Value {
    let object = dictionary.object(mapped.address.index);
    let entry = object.and_then(|object| object.entry(mapped.address.sub));
    let name = |entry: &Entry| {
        if entry.name.is_empty() {
            None
        } else {
            Some(entry.name.clone())
        }
    };
    context! {
        index => mapped.address.index,
        sub => mapped.address.sub,
        bits => mapped.bits,
        name => entry.and_then(name).or_else(|| object.map(|object| object.name.clone())).unwrap_or_default(),
    }
}
