use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds COB-IDs of the first SDO server (1200h) that are not $NODEID+600h and $NODEID+580h.
    ///
    /// ## Why it matters
    /// They cannot be changed: each device answers there, and a master talks to it there without reading 1200h. A device that is made
    /// from the file and believes it does not answer at all.
    ///
    /// ## Example
    /// ```ini
    /// [1200sub1]
    /// ParameterName=COB-ID client to server
    /// DefaultValue=$NODEID+0x580
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1200sub1]
    /// ParameterName=COB-ID client to server
    /// DefaultValue=$NODEID+0x600
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1200h; CiA's conformance test SDO12
    pub(crate) WrongDefaultSdo { code: "COM023", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongDefaultSdo {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let node_id = dictionary
            .commissioning
            .as_ref()
            .and_then(|commissioning| commissioning.node_id);
        for (sub, base) in [(1, 0x600), (2, 0x580)] {
            let entry = dictionary.entry(Address::new(0x1200, sub));
            let Some((entry, value)) = entry.and_then(|entry| Some((entry, entry.default.as_ref()?))) else {
                continue;
            };
            let fits = match *value {
                Value::NodeIdPlus(found) => found == base,
                // In a DCF the sum may be written out.
                Value::Unsigned(found) => node_id.is_some_and(|node_id| found == base + u64::from(node_id.get())),
                _ => true,
            };
            if !fits {
                let quoted = report.quote(entry.spans.default);
                report
                    .at(
                        entry.spans.default,
                        format!(
                            "{} is {quoted}; the standard fixes it to $NODEID+0x{base:X}",
                            entry.address
                        ),
                    )
                    .help(format!("write `$NODEID+0x{base:X}`"));
            }
        }
    }
}
