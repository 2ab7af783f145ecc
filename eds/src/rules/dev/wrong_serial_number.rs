use crate::{
    Reading,
    diagnostic::Level,
    ir::{Address, Value},
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds an LSS_SerialNumber that is not the serial number of the identity object (1018h:4).
    ///
    /// ## Why it matters
    /// A master finds the device over LSS by this number, and then checks 1018h:4: one of the two steps fails.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceComissioning]
    /// LSS_SerialNumber=1
    ///
    /// [1018sub4]
    /// ParameterValue=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub4]
    /// ParameterValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[DeviceComissioning]`; CiA 305, LSS address
    pub(crate) WrongSerialNumber { code: "DEV003", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for WrongSerialNumber {
    fn check(reading: &Reading, report: &mut Report) {
        let commissioning = reading.eds.commissioning.as_ref();
        let Some(number) = commissioning.and_then(|commissioning| commissioning.lss_serial_number) else {
            return;
        };
        let Some(entry) = reading.dictionary.entry(Address::new(0x1018, 4)) else {
            return;
        };
        // 0 stands for a number that is not known yet.
        let different = |value: u64| value != 0 && number.value != 0 && value != u64::from(number.value);
        if matches!(entry.default, Some(Value::Unsigned(value)) if different(value)) {
            let (ours, theirs) = (report.quote(number.span), report.quote(entry.spans.default));
            report
                .at(
                    number.span,
                    format!("LSS_SerialNumber is {ours}, but 1018sub4 is {theirs}"),
                )
                .related(entry.spans.default, "the identity object")
                .help("write the same number in both places");
        }
    }
}
