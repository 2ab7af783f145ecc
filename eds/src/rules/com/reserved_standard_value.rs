use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values after power-on that the standard reserves or does not allow: of 1003h:0 anything but 0, of 1019h 1 and 241 to 255, of
    /// 1029h 3 to 127, of 1F51h 4 to 127, of a SYNC start value (1800h:6) 241 to 255.
    ///
    /// ## Why it matters
    /// The device must refuse the value when it is written back, with abort code 0609 0030h; what it does with it after power-on nobody
    /// knows.
    ///
    /// ## Example
    /// ```ini
    /// [1019]
    /// ParameterName=Synchronous counter overflow value
    /// DefaultValue=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1019]
    /// ParameterName=Synchronous counter overflow value
    /// DefaultValue=0
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1003h, 1019h, 1029h and 1800h; CiA 302-3, object 1F51h. A transmission type is PDO019.
    pub(crate) ReservedStandardValue { code: "COM019", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for ReservedStandardValue {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries() {
            let Some(Value::Unsigned(value)) = entry.default else {
                continue;
            };
            if let Some(allowed) = allowed(entry.address, value) {
                let (address, at) = (entry.address, entry.spans.default);
                let quoted = report.quote(at);
                report
                    .at(at, format!("{address} is {quoted}, which the standard does not allow"))
                    .help(format!("write {allowed}"));
            }
        }
    }
}

/// What is allowed, when `value` is not.
const fn allowed(address: Address, value: u64) -> Option<&'static str> {
    match (address.index, address.sub, value) {
        (0x1003, 0, 1..) => Some("0: a device has no errors before it runs"),
        (0x1019, 0, 1 | 241..) => Some("0, or 2 to 240"),
        (0x1029, 1.., 3..=127) => Some("0 to 2, or 128 to 255 for a behavior of your own"),
        (0x1F51, 1.., 4..=127) => Some("0 to 3, or 128 to 255 for a command of your own"),
        (0x1800..=0x19FF, 6, 241..) => Some("0 to 240"),
        _ => None,
    }
}
