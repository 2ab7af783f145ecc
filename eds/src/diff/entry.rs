//! One value in both devices.

use std::cmp::Ordering;

use super::{Difference, Effect, Subject, goes, value::shown};
use crate::ir::{AccessType, Direction, Entry, Value};

/// Adds what differs between `old` and `new`, which are at the same address.
pub(super) fn compare(title: String, old: &Entry, new: &Entry, found: &mut Vec<Difference>) {
    let subject = Subject {
        title,
        name: new.name.clone(),
    };
    found.extend(data_type(&subject, old, new));
    found.extend(access(&subject, old, new));
    found.extend(mapping(&subject, old, new));
    found.extend(limit(&subject, old, new, Limit::Low));
    found.extend(limit(&subject, old, new, Limit::High));
    found.extend(default(&subject, old, new));
    found.extend(flags(&subject, old, new));
    found.extend(words(&subject, old, new));
}

fn data_type(subject: &Subject, old: &Entry, new: &Entry) -> Option<Difference> {
    let name = |entry: &Entry| entry.data_type.name();
    let difference = subject.fact("DataType", (name(old), name(new)), given, Effect::Breaking)?;
    Some(difference.at(old.spans.data_type, new.spans.data_type))
}

fn access(subject: &Subject, old: &Entry, new: &Entry) -> Option<Difference> {
    let (before, after) = (old.access, new.access);
    let rights = |access: AccessType| (access.readable(), access.writable());
    let ((read, write), (reads, writes)) = (rights(before), rights(after));
    let effect = if (read && !reads) || (write && !writes) {
        Effect::Breaking
    } else if (reads, writes) != (read, write) {
        Effect::Addition
    } else {
        Effect::Cosmetic
    };
    let difference = subject.fact("AccessType", (before.name(), after.name()), given, effect)?;
    Some(difference.at(old.spans.access, new.spans.access))
}

/// Into which PDOs a value can be mapped follows from PDOMapping and AccessType together.
fn mapping(subject: &Subject, old: &Entry, new: &Entry) -> Option<Difference> {
    let lost = |direction| is_mappable(old, direction) && !is_mappable(new, direction);
    let gone = lost(Direction::Receive) || lost(Direction::Transmit);
    let difference = subject.fact("PDOMapping", (pdos(old), pdos(new)), given, goes(gone))?;
    Some(difference.at(old.spans.pdo_mapping, new.spans.pdo_mapping))
}

fn is_mappable(entry: &Entry, direction: Direction) -> bool {
    entry.pdo_mapping
        && match direction {
            Direction::Receive => entry.access.writable() && entry.access != AccessType::Rwr,
            Direction::Transmit => entry.access.readable() && entry.access != AccessType::Rww,
        }
}

fn pdos(entry: &Entry) -> &'static str {
    match (
        is_mappable(entry, Direction::Receive),
        is_mappable(entry, Direction::Transmit),
    ) {
        (false, false) => "none",
        (true, false) => "RPDO",
        (false, true) => "TPDO",
        (true, true) => "RPDO and TPDO",
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Limit {
    Low,
    High,
}

fn limit(subject: &Subject, old: &Entry, new: &Entry, limit: Limit) -> Option<Difference> {
    let (fact, of, at): (_, fn(&Entry) -> &Option<Value>, _) = match limit {
        Limit::Low => ("LowLimit", |entry| &entry.low, (old.spans.low, new.spans.low)),
        Limit::High => ("HighLimit", |entry| &entry.high, (old.spans.high, new.spans.high)),
    };
    let effect = goes(is_narrower(of(old).as_ref(), of(new).as_ref(), limit));
    values(subject, fact, (old, of(old).as_ref()), (new, of(new).as_ref()), effect)
        .map(|difference| difference.at(at.0, at.1))
}

/// Whether values that were allowed are no longer. No limit allows all that the type has.
fn is_narrower(old: Option<&Value>, new: Option<&Value>, limit: Limit) -> bool {
    match (old, new) {
        (_, None) => false,
        (None, Some(_)) => true,
        (Some(old), Some(new)) => match new.compare(old, None) {
            Some(Ordering::Less) => limit == Limit::High,
            Some(Ordering::Greater) => limit == Limit::Low,
            Some(Ordering::Equal) => false,
            None => true,
        },
    }
}

/// A default that is given for the first time was something before as well: it tells a master more.
fn default(subject: &Subject, old: &Entry, new: &Entry) -> Option<Difference> {
    let fact = if old.configured || new.configured {
        "ParameterValue"
    } else {
        "DefaultValue"
    };
    let effect = goes(old.default.is_some());
    let difference = values(
        subject,
        fact,
        (old, old.default.as_ref()),
        (new, new.default.as_ref()),
        effect,
    )?;
    Some(difference.at(old.spans.default, new.spans.default))
}

/// The difference of two values that may not be there. A value of another type is the same when it reads the same.
fn values(
    subject: &Subject,
    fact: &'static str,
    (old, before): (&Entry, Option<&Value>),
    (new, after): (&Entry, Option<&Value>),
    effect: Effect,
) -> Option<Difference> {
    let same_bits = before.zip(after).is_some_and(|(before, after)| {
        old.data_type == new.data_type && before.to_bytes(old.data_type, None) == after.to_bytes(new.data_type, None)
    });
    let formula = |value: Option<&Value>| matches!(value, Some(Value::NodeIdPlus(_)));
    if same_bits && formula(before) == formula(after) {
        return None;
    }
    let before = before.map(|value| shown(value, old.data_type));
    let after = after.map(|value| shown(value, new.data_type));
    subject.fact(fact, (before, after), |value| value, effect)
}

fn flags(subject: &Subject, old: &Entry, new: &Entry) -> Option<Difference> {
    let flags = |entry: &Entry| u8::from(entry.refuse_write_on_download) | u8::from(entry.refuse_read_on_scan) << 1;
    let gone = flags(new) & !flags(old) != 0;
    let shown = |flags: u8| Some(flags.to_string());
    let difference = subject.fact("ObjFlags", (flags(old), flags(new)), shown, goes(gone))?;
    Some(difference.at(old.spans.section, new.spans.section))
}

fn words<'a>(subject: &'a Subject, old: &'a Entry, new: &'a Entry) -> impl Iterator<Item = Difference> + 'a {
    let optional = |fact, of: fn(&Entry) -> &Option<String>| {
        subject.fact(fact, (of(old), of(new)), Clone::clone, Effect::Cosmetic)
    };
    let name = subject
        .fact(
            "ParameterName",
            (&old.name, &new.name),
            |name| Some(name.clone()),
            Effect::Cosmetic,
        )
        .map(|difference| difference.at(old.spans.name, new.spans.name));
    let others = [
        optional("Denotation", |entry| &entry.denotation),
        optional("UploadFile", |entry| &entry.upload_file),
        optional("DownloadFile", |entry| &entry.download_file),
    ];
    let others = others.into_iter().flatten();
    name.into_iter()
        .chain(others.map(|difference| difference.at(old.spans.section, new.spans.section)))
}

#[expect(clippy::unnecessary_wraps, reason = "shows a fact as the others are shown")]
fn given(word: &str) -> Option<String> {
    Some(word.to_owned())
}
