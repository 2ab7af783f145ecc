use super::standard::standard;
use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds communication objects without a sub-index that the standard makes mandatory, such as the COB-ID or the transmission type of
    /// a PDO, or the vendor-ID in 1018h. One finding for an object.
    ///
    /// ## Why it matters
    /// A master writes it without asking, to configure the device, and gets abort code 0609 0011h.
    ///
    /// ## Example
    /// ```ini
    /// [1800]
    /// ParameterName=TPDO 1 communication parameter
    /// SubNumber=2
    /// [1800sub0]
    /// …
    /// [1800sub1]
    /// …
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1800]
    /// ParameterName=TPDO 1 communication parameter
    /// SubNumber=3
    /// [1800sub0]
    /// …
    /// [1800sub1]
    /// …
    /// [1800sub2]
    /// ParameterName=Transmission type
    /// ```
    ///
    /// ## Reference
    /// CiA 301 and CiA 302, objects 1000h to 1FFFh; CANchkEDS V39
    pub(crate) MissingStandardSubIndex { code: "COM008", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MissingStandardSubIndex {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        // An object of another kind is COM005, one without any sub-index OBJ018.
        let structured = dictionary.objects.iter().filter(|object| object.entries.len() > 1);
        for object in structured {
            let Some(standard) = standard(object.index).filter(|standard| standard.is_like(object.code)) else {
                continue;
            };
            let missing = (1..=standard.mandatory).find(|sub| object.entry(*sub).is_none());
            if let Some(sub) = missing {
                let (address, name) = (Address::new(object.index, sub), standard.name);
                report
                    .at(object.span, format!("{address} of {name} is missing"))
                    .help(format!("describe it: {} makes it mandatory", standard.document));
            }
        }
    }
}
