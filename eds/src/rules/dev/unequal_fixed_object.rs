use std::collections::BTreeMap;

use crate::{
    diagnostic::Level,
    ir::{AccessType, ObjectCode},
    model::{Description, Eds, Object},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds fixed objects that two modules describe in different ways: with another ObjectType, DataType, AccessType or PDOMapping, or
    /// other sub-objects.
    ///
    /// ## Why it matters
    /// With both modules plugged in the object is there once. What it is depends on which of them is taken first.
    ///
    /// ## Example
    /// ```ini
    /// [M1Fixed2000]
    /// ParameterName=Gain
    /// DataType=0x0006
    ///
    /// [M2Fixed2000]
    /// ParameterName=Gain
    /// DataType=0x0007
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [M2Fixed2000]
    /// ParameterName=Gain
    /// DataType=0x0006
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[MxFixedObjects]`; CANchkEDS V53
    pub(crate) UnequalFixedObject { code: "DEV014", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for UnequalFixedObject {
    fn check(eds: &Eds, report: &mut Report) {
        let mut first: BTreeMap<u16, (u16, &Object)> = BTreeMap::new();
        for module in &eds.modules {
            for fixed in &module.fixed {
                let (number, known) = *first.entry(fixed.index).or_insert((module.number, fixed));
                if !is_alike(known, fixed) {
                    let (index, other) = (fixed.index, module.number);
                    report
                        .at(
                            fixed.header(),
                            format!("{index:04X}h of module {other} is not that of module {number}"),
                        )
                        .related(known.header(), "the other one")
                        .help("describe it alike, or under another index");
                }
            }
        }
    }
}

fn is_alike(one: &Object, other: &Object) -> bool {
    let (subs, others) = (one.subs.iter(), other.subs.iter());
    let subs_alike = one.subs.len() == other.subs.len()
        && subs
            .zip(others)
            .all(|(one, other)| one.sub == other.sub && facts(&one.description) == facts(&other.description));
    one.description.as_ref().map(facts) == other.description.as_ref().map(facts) && subs_alike
}

/// What makes it another object.
fn facts(description: &Description) -> (Option<ObjectCode>, Option<u16>, Option<AccessType>, bool) {
    (
        description.object_type.map(|code| code.value),
        description.data_type.map(|data_type| data_type.value),
        description.access_type.map(|access| access.value),
        description.pdo_mapping.is_some_and(|mapping| mapping.value),
    )
}
