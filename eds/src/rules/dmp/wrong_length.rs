use super::{answers::answered, shown::shown_bytes};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{DataType, Dictionary},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values that are longer or shorter than their data type.
    ///
    /// ## Why it matters
    /// A master that trusts the file reads the wrong number of bytes, refuses the answer, or writes with a length that the
    /// device refuses.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// ```
    /// for a device that answers four bytes, `E8 03 00 00`.
    ///
    /// ## Reference
    /// CiA 301, static data types; CiA's conformance test SDO08
    pub(crate) WrongLength { code: "DMP003", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for WrongLength {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump) {
            let (entry, length) = (answer.entry, answer.bytes.len());
            let Some(asked) = required(entry.data_type, length) else {
                continue;
            };
            let (name, bytes) = (answer.named(), shown_bytes(answer.bytes));
            let message = format!(
                "{name} answers {}, {bytes}; {} has {asked}",
                counted(length),
                entry.data_type.name()
            );
            report
                .at(entry.spans.data_type, message)
                .help("give the data type that the device has");
        }
    }
}

/// How long a value of `data_type` has to be, in words; `None` when `length` is right.
fn required(data_type: DataType, length: usize) -> Option<String> {
    match data_type.bytes() {
        Some(bytes) => (bytes != length).then(|| bytes.to_string()),
        None if data_type == DataType::UnicodeString && length % 2 == 1 => Some("two a character".into()),
        None => None,
    }
}

fn counted(length: usize) -> String {
    match length {
        1 => "1 byte".into(),
        length => format!("{length} bytes"),
    }
}
