use crate::{
    diagnostic::Level,
    ir::{Dictionary, Direction, Entry, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a 1004h, number of PDOs supported, whose high or low word is not the number of RPDOs or TPDOs (sub-index 0), or is
    /// above it (sub-indices 1 and 2, the synchronous and the asynchronous ones).
    ///
    /// ## Why it matters
    /// 1004h is of CiA 301 before version 4. Masters that still read it configure as many PDOs as it says.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// NrOfRXPDO=1
    /// NrOfTXPDO=1
    ///
    /// [1004sub0]
    /// DefaultValue=0x00010002
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1004sub0]
    /// DefaultValue=0x00010001
    /// ```
    ///
    /// ## Reference
    /// CiA 301 version 3, object 1004h; CANchkEDS V71, V72
    pub(crate) WrongNumberOfPdos { code: "DEV004", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongNumberOfPdos {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let Some(object) = dictionary.object(0x1004) else {
            return;
        };
        let receive = dictionary.pdos(Direction::Receive).count();
        let transmit = dictionary.pdos(Direction::Transmit).count();
        for entry in &object.entries {
            let Some((stated_receive, stated_transmit)) = words(entry) else {
                continue;
            };
            let fits = match entry.address.sub {
                0 => stated_receive == receive && stated_transmit == transmit,
                1 | 2 => stated_receive <= receive && stated_transmit <= transmit,
                _ => true,
            };
            if !fits {
                let address = entry.address;
                let stated = format!("{stated_receive} RPDOs and {stated_transmit} TPDOs");
                report
                    .at(
                        entry.spans.default,
                        format!("{address} says {stated}; the file has {receive} and {transmit}"),
                    )
                    .help("write RPDOs in the high word, TPDOs in the low word");
            }
        }
    }
}

/// The high and the low word.
fn words(entry: &Entry) -> Option<(usize, usize)> {
    let Some(Value::Unsigned(value)) = entry.default else {
        return None;
    };
    let word = |value: u64| usize::try_from(value & 0xFFFF).ok();
    Some((word(value >> 16)?, word(value)?))
}
