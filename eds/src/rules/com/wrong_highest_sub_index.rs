use crate::{
    diagnostic::Level,
    ir::{Dictionary, Object, ObjectCode, Value},
    rules::{DictionaryRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds a sub-index 0 that cannot be written and whose value is not the highest sub-index that the file describes. Where
    /// sub-index 0 is a count of something else it is left alone: 1003h, 1004h, and the mapping of PDOs.
    ///
    /// ## Why it matters
    /// A master reads sub-index 0 and then as many values: it misses some, or gets an abort for those that are not there.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub0]
    /// AccessType=const
    /// DefaultValue=4
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub0]
    /// AccessType=const
    /// DefaultValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.4.3, sub-index 0; CANchkEDS V36, W25
    pub(crate) WrongHighestSubIndex { code: "COM007", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongHighestSubIndex {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for object in dictionary
            .objects
            .iter()
            .filter(|object| !counts_otherwise(object.index))
        {
            if let Some(Wrong { stated, highest, at }) = wrong(object) {
                let index = object.index;
                report
                    .at(
                        at,
                        format!("{index:04X}sub0 is {stated}, but the highest sub-index is {highest}"),
                    )
                    .help(format!("write `DefaultValue={highest}`"));
            }
        }
    }
}

struct Wrong {
    stated: u64,
    highest: u8,
    at: Span,
}

fn wrong(object: &Object) -> Option<Wrong> {
    let structured = matches!(object.code, ObjectCode::Array | ObjectCode::Record);
    let zero = object.entry(0).filter(|zero| structured && !zero.access.writable())?;
    let Some(Value::Unsigned(stated)) = zero.default else {
        return None;
    };
    // Sub-index 255 is the structure of the object.
    let subs = object.entries.iter().map(|entry| entry.address.sub);
    let highest = subs.filter(|sub| *sub != u8::MAX).max()?;
    let at = zero.spans.default;
    (stated != u64::from(highest)).then_some(Wrong { stated, highest, at })
}

const fn counts_otherwise(index: u16) -> bool {
    matches!(index, 0x1003 | 0x1004 | 0x1600..=0x17FF | 0x1A00..=0x1BFF)
}
