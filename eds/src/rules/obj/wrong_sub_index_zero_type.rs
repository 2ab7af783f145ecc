use crate::{
    diagnostic::Level,
    ir::{DataType, Dictionary, Entry, ObjectCode},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a sub-index 0 of an array or record that is not UNSIGNED8. Of a communication object it is COM002.
    ///
    /// ## Why it matters
    /// Sub-index 0 is the highest sub-index, a byte. A tool that reads an object by it asks for one byte and gets more, or none.
    ///
    /// ## Example
    /// ```ini
    /// [2100sub0]
    /// ParameterName=Highest sub-index supported
    /// DataType=0x0006
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100sub0]
    /// ParameterName=Highest sub-index supported
    /// DataType=0x0005
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.4.3, sub-index 0
    pub(crate) WrongSubIndexZeroType { code: "OBJ026", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongSubIndexZeroType {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let others = dictionary
            .objects
            .iter()
            .filter(|object| !(0x1000..0x2000).contains(&object.index));
        for object in others.filter(|object| matches!(object.code, ObjectCode::Array | ObjectCode::Record)) {
            // A type that cannot be read is lowered to DOMAIN, and was reported.
            let wrong = |zero: &&Entry| !matches!(zero.data_type, DataType::Unsigned8 | DataType::Domain);
            if let Some(zero) = object.entry(0).filter(wrong) {
                let (address, name) = (zero.address, zero.data_type.name());
                report
                    .at(
                        zero.spans.data_type,
                        format!("{address} is {name}; sub-index 0 is UNSIGNED8"),
                    )
                    .help("write `DataType=0x0005`");
            }
        }
    }
}
