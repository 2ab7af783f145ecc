use crate::{
    diagnostic::Level,
    ir::{Dictionary, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values of 1010h and 1011h that are no answer of a device: bits other than 0 and 1 of 1010h (stores on command, stores by
    /// itself), other than 0 of 1011h (restores). Often it is the signature "save" or "load" that a client writes.
    ///
    /// ## Why it matters
    /// A master reads there whether the device can store its parameters. A device that is made from the file answers with the signature.
    ///
    /// ## Example
    /// ```ini
    /// [1010sub1]
    /// ParameterName=Save all parameters
    /// DefaultValue=0x65766173
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1010sub1]
    /// ParameterName=Save all parameters
    /// DefaultValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1010h and 1011h
    pub(crate) WrongStorageCapability { code: "COM015", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongStorageCapability {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for (index, highest, signature) in [(0x1010, 0b11, 0x6576_6173), (0x1011, 0b1, 0x6461_6F6C)] {
            for entry in dictionary.object(index).into_iter().flat_map(|object| &object.entries) {
                let value = match entry.default {
                    Some(Value::Unsigned(value)) if entry.address.sub > 0 => value,
                    _ => continue,
                };
                if value > highest {
                    let (address, at) = (entry.address, entry.spans.default);
                    let quoted = report.quote(at);
                    let what = if value == signature {
                        "the signature of a client"
                    } else {
                        "reserved"
                    };
                    report
                        .at(at, format!("{address} is {quoted}, which is {what}"))
                        .help(format!("write what the device answers, 0 to {highest}"));
                }
            }
        }
    }
}
