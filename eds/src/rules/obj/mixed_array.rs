use crate::{
    diagnostic::Level,
    ir::{Dictionary, ObjectCode},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays whose elements, from sub-index 1 on, are of different data types. One finding for an object.
    ///
    /// ## Why it matters
    /// An array has one type. A generator makes an array of the language of it, and cannot; a master that knows the type of one element
    /// reads the others with the wrong length.
    ///
    /// ## Example
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// ObjectType=0x8
    /// [2100sub1]
    /// DataType=0x0006
    /// [2100sub2]
    /// DataType=0x0007
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// ObjectType=0x9
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.4.3, ARRAY; CANchkEDS V42
    pub(crate) MixedArray { code: "OBJ029", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MixedArray {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for object in dictionary
            .objects
            .iter()
            .filter(|object| object.code == ObjectCode::Array)
        {
            // Sub-index 255 is the structure of the object.
            let mut elements = object
                .entries
                .iter()
                .filter(|entry| !matches!(entry.address.sub, 0 | u8::MAX));
            let Some(first) = elements.next() else { continue };
            if let Some(other) = elements.find(|entry| entry.data_type != first.data_type) {
                let (address, name) = (other.address, other.data_type.name());
                let (first_address, first_name) = (first.address, first.data_type.name());
                report
                    .at(
                        other.spans.data_type,
                        format!("{address} is {name}, but {first_address} of the same array {first_name}"),
                    )
                    .related(first.spans.data_type, "the first element")
                    .help("make the object a record: write `ObjectType=0x9`");
            }
        }
    }
}
