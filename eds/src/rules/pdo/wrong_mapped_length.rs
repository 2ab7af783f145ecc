use super::mapped::{Mapped, all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::{DataType, Dictionary},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds mapping entries whose length is not that of the mapped object's data type. A BOOLEAN may take a whole byte.
    ///
    /// ## Why it matters
    /// The device sends as many bits as its mapping says or as its type has; a master that believes the other one misreads this
    /// value and all behind it.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60040010
    ///
    /// [6004]
    /// DataType=0x0007
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60040020
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS V65
    pub(crate) WrongMappedLength { code: "PDO008", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongMappedLength {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary) {
            let Some(data_type) = data_type(dictionary, &mapped) else {
                continue;
            };
            // A device whose granularity is 8 gives a BOOLEAN a byte.
            let expected = data_type.bits().filter(|bits| *bits > 1 && *bits != mapped.bits);
            if let Some(expected) = expected {
                let (pdo, address, bits) = (label(&mapped.pdo), mapped.address, mapped.bits);
                let name = data_type.name();
                let (index, sub) = (address.index, address.sub);
                report
                    .at(
                        mapped.span,
                        format!("{pdo} maps {bits} bits of {address}; {name} has {expected}"),
                    )
                    .help(format!("write `0x{index:04X}{sub:02X}{expected:02X}`"));
            }
        }
    }
}

fn data_type(dictionary: &Dictionary, mapped: &Mapped<'_>) -> Option<DataType> {
    let of_object = || dictionary.entry(mapped.address).map(|entry| entry.data_type);
    mapped.dummy().or_else(of_object)
}
