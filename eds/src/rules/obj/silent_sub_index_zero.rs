use std::cmp::Ordering;

use crate::{
    Reading,
    diagnostic::Level,
    document::{Document, Keyword, SectionName},
    fix::{Change, Fix},
    ir::{DataType, Entry, Object, ObjectCode, Value},
    rules::{ReadingRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds a sub-index 0 of an array or record that cannot be written and has no DefaultValue. Where sub-index 0 counts
    /// something else it is left alone: 1003h, 1004h, and the mapping of PDOs.
    ///
    /// ## Why it matters
    /// It is the highest sub-index, which the file knows. A tool that plans its reads by the file cannot, and a generator has to guess.
    ///
    /// ## Example
    /// ```ini
    /// [2100sub0]
    /// ParameterName=Highest sub-index supported
    /// AccessType=const
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100sub0]
    /// ParameterName=Highest sub-index supported
    /// AccessType=const
    /// DefaultValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.4.3, sub-index 0; CANchkEDS W24
    pub(crate) SilentSubIndexZero { code: "OBJ027", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ReadingRule for SilentSubIndexZero {
    fn check(reading: &Reading, report: &mut Report) {
        let structured = |object: &&Object| matches!(object.code, ObjectCode::Array | ObjectCode::Record);
        let objects = reading.dictionary.objects.iter().filter(structured);
        for object in objects.filter(|object| !counts_otherwise(object.index)) {
            // A sub-index 0 that the file does not have is OBJ009.
            let silent = |zero: &&Entry| !zero.access.writable() && zero.default.is_none();
            if let Some(zero) = object.entry(0).filter(silent) {
                let highest = highest(object);
                report
                    .at(zero.spans.section, format!("{} has no value", zero.address))
                    .help(format!("write `DefaultValue={highest}`"))
                    .fix(fix(&reading.document, zero, highest));
            }
        }
    }
}

/// Sub-index 255 is the structure of the object.
fn highest(object: &Object) -> u8 {
    let subs = object.entries.iter().map(|entry| entry.address.sub);
    subs.filter(|sub| *sub != u8::MAX).max().unwrap_or_default()
}

/// The value in the section of sub-index 0, where it has one, and the number is in doubt neither by its type nor by its limits.
fn fix(document: &Document, zero: &Entry, highest: u8) -> Option<Fix> {
    let section = document.section_around(zero.spans.section)?;
    let is_own = section.name == SectionName::Sub(zero.address.index, 0);
    let is_certain = is_own && highest > 0 && zero.data_type == DataType::Unsigned8 && is_within_limits(zero, highest);
    if !is_certain || section.entry(Keyword::ParameterValue).is_some() {
        return None;
    }
    match section.entry(Keyword::DefaultValue) {
        Some(entry) => is_empty(entry.value).then(|| Fix::replace(entry.value, highest.to_string())),
        None => Some(Fix::new(Change::Keyword {
            header: section.header,
            keyword: Keyword::DefaultValue,
            value: highest.to_string(),
        })),
    }
}

const fn is_empty(value: Span) -> bool {
    value.start == value.end
}

fn is_within_limits(zero: &Entry, highest: u8) -> bool {
    let highest = Value::Unsigned(highest.into());
    let compared = |limit: &Option<Value>| limit.as_ref().and_then(|limit| highest.compare(limit, None));
    compared(&zero.low) != Some(Ordering::Less) && compared(&zero.high) != Some(Ordering::Greater)
}

/// Sub-index 0 of these is a number of errors, of PDOs, or of mapped objects.
const fn counts_otherwise(index: u16) -> bool {
    matches!(index, 0x1003 | 0x1004 | 0x1600..=0x17FF | 0x1A00..=0x1BFF)
}
