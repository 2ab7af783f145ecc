use super::inverted_limits::check_limits;
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that are only read and whose LowLimit is above their HighLimit.
    ///
    /// ## Why it matters
    /// No value is within the limits: a master that checks what it reads takes every value for wrong. Nothing can be
    /// written, so a device made from the file is none the worse.
    ///
    /// ## Example
    /// ```ini
    /// [6061]
    /// ParameterName=Modes of operation display
    /// DataType=0x0002
    /// AccessType=ro
    /// LowLimit=0x00
    /// HighLimit=0xFF
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6061]
    /// ParameterName=Modes of operation display
    /// DataType=0x0002
    /// AccessType=ro
    /// LowLimit=-128
    /// HighLimit=127
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, LowLimit and HighLimit. Of a writable object it is OBJ002.
    pub(crate) InvertedReadOnlyLimits { code: "OBJ022", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for InvertedReadOnlyLimits {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries().filter(|entry| !entry.access.writable()) {
            check_limits(entry, report);
        }
    }
}
