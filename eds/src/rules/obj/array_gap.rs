use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary, ObjectCode},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays whose sub-indices are not 1, 2, 3 … without a gap. A record may have gaps. Of a PDO's mapping it is PDO010.
    ///
    /// ## Why it matters
    /// The elements of an array are counted: a master that reads up to sub-index 0 gets an abort at the gap.
    ///
    /// ## Example
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// ObjectType=0x8
    /// [2100sub1]
    /// …
    /// [2100sub3]
    /// …
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100sub1]
    /// …
    /// [2100sub2]
    /// …
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.4.3, ARRAY
    pub(crate) ArrayGap { code: "OBJ028", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for ArrayGap {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let arrays = dictionary
            .objects
            .iter()
            .filter(|object| object.code == ObjectCode::Array);
        for object in arrays.filter(|object| !is_of_nodes(object.index)) {
            // Sub-index 255 is the structure of the object.
            let elements = object
                .entries
                .iter()
                .filter(|entry| !matches!(entry.address.sub, 0 | u8::MAX));
            let gap = elements
                .zip(1..)
                .find(|(entry, expected)| entry.address.sub != *expected);
            if let Some((entry, expected)) = gap {
                let (address, missing) = (entry.address, Address::new(object.index, expected));
                report
                    .at(
                        entry.spans.section,
                        format!("{address} follows, but {missing} is missing"),
                    )
                    .help("number the elements 1, 2, 3 …, or make the object a record");
            }
        }
    }
}

/// Mappings are PDO010; in an array of CiA 302 the sub-index is a node-ID, and not each is in use.
const fn is_of_nodes(index: u16) -> bool {
    matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF | 0x1F20..=0x1F27 | 0x1F53..=0x1F58 | 0x1F81..=0x1F8A)
}
