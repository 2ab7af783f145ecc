use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary, Entry, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds devices that after power-on produce a heartbeat (1017h is not 0) and are guarded as well (neither 100Ch nor 100Dh is 0).
    ///
    /// ## Why it matters
    /// A device uses the one or the other: with a heartbeat time it answers no guarding request, so that the life time that the file
    /// sets can only run out.
    ///
    /// ## Example
    /// ```ini
    /// [100C]
    /// DefaultValue=100
    /// [100D]
    /// DefaultValue=3
    /// [1017]
    /// DefaultValue=1000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [100C]
    /// DefaultValue=0
    /// [100D]
    /// DefaultValue=0
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.2.8.2.2, error control services
    pub(crate) CompetingErrorControl { code: "COM017", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for CompetingErrorControl {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let active = |index| {
            dictionary
                .entry(Address::new(index, 0))
                .filter(|entry| is_active(entry))
        };
        if let (Some(guard), Some(_), Some(heartbeat)) = (active(0x100C), active(0x100D), active(0x1017)) {
            report
                .at(
                    heartbeat.spans.default,
                    "heartbeat and guarding are both on after power-on",
                )
                .related(guard.spans.default, "the guard time")
                .help("write 0 in 1017h, or in 100Ch and 100Dh");
        }
    }
}

const fn is_active(entry: &Entry) -> bool {
    matches!(entry.default, Some(Value::Unsigned(1..)))
}
