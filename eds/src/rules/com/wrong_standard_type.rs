use super::standard::{field, standard};
use crate::{
    diagnostic::Level,
    ir::{DataType, Dictionary, Entry, Object},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds communication objects whose data type is not the one that CiA 301, CiA 302 or EN 50325-5 gives them.
    ///
    /// ## Why it matters
    /// Masters write these objects by the standard, without looking into the file: a device made from the file refuses the length
    /// with abort code 0607 0010h.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DataType=0x0007
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DataType=0x0006
    /// ```
    ///
    /// ## Reference
    /// CiA 301 and CiA 302, objects 1000h to 1FFFh; CANchkEDS V30
    pub(crate) WrongStandardType { code: "COM002", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongStandardType {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let mut last = None;
        // Of an object of another kind it is COM005.
        let known = |object: &&Object| standard(object.index).is_some_and(|standard| standard.is_like(object.code));
        for entry in dictionary
            .objects
            .iter()
            .filter(known)
            .flat_map(|object| &object.entries)
        {
            let at = entry.spans.data_type;
            // In the compact form one line stands for many.
            let Some(expected) = expected(entry).filter(|_| last.replace(at) != Some(at)) else {
                continue;
            };
            let (address, found, name, number) =
                (entry.address, entry.data_type.name(), expected.name(), expected.index());
            let document = standard(address.index).map_or("the standard", |standard| standard.document);
            report
                .at(at, format!("{address} is {found}; {document} gives it {name}"))
                .help(format!("write `DataType=0x{number:04X}`"));
        }
    }
}

/// The standard's type, where it is another one.
fn expected(entry: &Entry) -> Option<DataType> {
    let expected = field(entry.address)?.data_type?;
    // A type that cannot be read is lowered to DOMAIN, and was reported.
    (entry.data_type != expected && entry.data_type != DataType::Domain).then_some(expected)
}
