use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds files without one of the objects that every device has: 1000h device type, 1001h error register, 1018h identity object.
    ///
    /// ## Why it matters
    /// A master reads 1000h and 1018h before it starts a device, to see that it is the right one; without 1001h the device cannot
    /// send an emergency.
    ///
    /// ## Example
    /// ```ini
    /// [MandatoryObjects]
    /// SupportedObjects=2
    /// 1=0x1000
    /// 2=0x1001
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [MandatoryObjects]
    /// SupportedObjects=3
    /// 1=0x1000
    /// 2=0x1001
    /// 3=0x1018
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1000h, 1001h and 1018h; CANchkEDS V9
    pub(crate) MissingMandatoryObject { code: "COM001", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MissingMandatoryObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        // Of a file without any object others have something to say.
        if dictionary.objects.is_empty() {
            return;
        }
        for (index, name) in MANDATORY {
            if dictionary.object(index).is_none() {
                report
                    .at(Span::default(), format!("object {index:04X}h, {name}, is missing"))
                    .help(format!("describe {index:04X}h, and add it to [MandatoryObjects]"));
            }
        }
    }
}

const MANDATORY: [(u16, &str); 3] = [
    (0x1000, "device type"),
    (0x1001, "error register"),
    (0x1018, "identity object"),
];
