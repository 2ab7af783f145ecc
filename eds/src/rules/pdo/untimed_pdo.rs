use super::mapped::{label, pdos, unsigned};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry, Pdo, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs that after power-on follow SYNC (transmission type 0 to 240) in a device without object 1005h, COB-ID SYNC. One finding
    /// for a device.
    ///
    /// ## Why it matters
    /// The device does not know SYNC: the PDO is never sent, or never taken over.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub2]
    /// DefaultValue=1
    ///
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1800
    /// 2=0x1A00
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=3
    /// 1=0x1005
    /// 2=0x1800
    /// 3=0x1A00
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1005h, 1400h and 1800h
    pub(crate) UntimedPdo { code: "PDO027", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UntimedPdo {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        if dictionary.object(0x1005).is_some() {
            return;
        }
        let mut timed = pdos(dictionary).filter_map(|pdo| Some((pdo, synchronous(&pdo)?)));
        if let Some((pdo, (entry, value))) = timed.next() {
            let pdo = label(&pdo);
            report
                .at(
                    entry.spans.default,
                    format!("transmission type {value} of {pdo} follows SYNC, but object 1005h is missing"),
                )
                .help("describe object 1005h, COB-ID SYNC, or write 254 or 255");
        }
    }
}

/// The transmission type of a PDO that is switched on and follows SYNC.
fn synchronous<'a>(pdo: &Pdo<'a>) -> Option<(&'a Entry, u64)> {
    const INVALID: u64 = 1 << 31;
    let exists = match pdo.cob_id()? {
        Value::Unsigned(cob_id) | Value::NodeIdPlus(cob_id) => cob_id & INVALID == 0,
        _ => false,
    };
    let entry = pdo.communication?.entry(2)?;
    let value = unsigned(entry.default.as_ref()).filter(|value| exists && *value <= 240)?;
    Some((entry, value))
}
