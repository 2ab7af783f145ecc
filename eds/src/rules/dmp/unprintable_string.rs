use super::{answers::answered, difference::is_default, shown::shown};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{DataType, Dictionary},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds VISIBLE_STRINGs with bytes other than the visible characters 20h to 7Eh and NUL. A text that is the file's own
    /// default is left to `lexican check`.
    ///
    /// ## Why it matters
    /// A tool shows it garbled, each in another way. Often it is memory that was never written, FFh, or bytes of another object.
    ///
    /// ## Example
    /// ```json
    /// "1008sub0": "57 44 47 41 FF FF"
    /// ```
    ///
    /// ## Reference
    /// CiA 301, VISIBLE_STRING
    pub(crate) UnprintableString { code: "DMP015", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for UnprintableString {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump) {
            let (data_type, bytes) = (answer.entry.data_type, answer.bytes);
            if data_type != DataType::VisibleString || is_default(&answer, dump.node_id) {
                continue;
            }
            if let Some(byte) = bytes.iter().find(|&&byte| !matches!(byte, 0 | 0x20..=0x7E)) {
                let (name, text) = (answer.named(), shown(bytes, data_type));
                report
                    .at(
                        answer.entry.spans.data_type,
                        format!("{name} answers {text}, with a byte {byte:02X}h"),
                    )
                    .help("make it ASCII, or declare it OCTET_STRING or UNICODE_STRING");
            }
        }
    }
}
