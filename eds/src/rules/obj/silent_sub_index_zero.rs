use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry, Object, ObjectCode},
    rules::{DictionaryRule, Report, declare_rule},
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
    pub(crate) SilentSubIndexZero { code: "OBJ027", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for SilentSubIndexZero {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let structured = |object: &&Object| matches!(object.code, ObjectCode::Array | ObjectCode::Record);
        let objects = dictionary.objects.iter().filter(structured);
        for object in objects.filter(|object| !counts_otherwise(object.index)) {
            // A sub-index 0 that the file does not have is OBJ009.
            let silent = |zero: &&Entry| !zero.access.writable() && zero.default.is_none();
            if let Some(zero) = object.entry(0).filter(silent) {
                report
                    .at(zero.spans.section, format!("{} has no value", zero.address))
                    .help(format!("write `DefaultValue={}`", highest(object)));
            }
        }
    }
}

/// Sub-index 255 is the structure of the object.
fn highest(object: &Object) -> u8 {
    let subs = object.entries.iter().map(|entry| entry.address.sub);
    subs.filter(|sub| *sub != u8::MAX).max().unwrap_or_default()
}

/// Sub-index 0 of these is a number of errors, of PDOs, or of mapped objects.
const fn counts_otherwise(index: u16) -> bool {
    matches!(index, 0x1003 | 0x1004 | 0x1600..=0x17FF | 0x1A00..=0x1BFF)
}
