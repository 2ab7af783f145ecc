use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that a module both brings as fixed ones and extends by sub-objects.
    ///
    /// ## Why it matters
    /// A fixed object is there once, an extended one grows with each module of the kind. It cannot be both.
    ///
    /// ## Example
    /// ```ini
    /// [M1FixedObjects]
    /// NrOfEntries=1
    /// 1=0x2000
    ///
    /// [M1SubExtends]
    /// NrOfEntries=1
    /// 1=0x2000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [M1FixedObjects]
    /// NrOfEntries=1
    /// 1=0x2001
    ///
    /// [M1SubExtends]
    /// NrOfEntries=1
    /// 1=0x2000
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[MxFixedObjects]` and `[MxSubExtends]`; CANchkEDS V51
    pub(crate) FixedAndExtendedObject { code: "DEV013", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for FixedAndExtendedObject {
    fn check(eds: &Eds, report: &mut Report) {
        for module in &eds.modules {
            for extension in &module.extensions {
                if let Some(fixed) = module.fixed.iter().find(|fixed| fixed.index == extension.index) {
                    let (index, number) = (fixed.index, module.number);
                    report
                        .at(
                            extension.description.header,
                            format!("module {number} extends {index:04X}h, which it brings as a fixed object"),
                        )
                        .related(fixed.header(), "the fixed object")
                        .help("remove one of the two");
                }
            }
        }
    }
}
