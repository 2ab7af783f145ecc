use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds fixed objects of a module that the device has already without the module.
    ///
    /// ## Why it matters
    /// A fixed object is there when the module is. With two descriptions of it a tool takes the one or the other.
    ///
    /// ## Example
    /// ```ini
    /// [ManufacturerObjects]
    /// SupportedObjects=1
    /// 1=0x2000
    ///
    /// [M1FixedObjects]
    /// NrOfEntries=1
    /// 1=0x2000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [M1FixedObjects]
    /// NrOfEntries=1
    /// 1=0x2001
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[MxFixedObjects]`; CANchkEDS V10
    pub(crate) TwiceDescribedObject { code: "DEV012", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for TwiceDescribedObject {
    fn check(eds: &Eds, report: &mut Report) {
        for module in &eds.modules {
            for fixed in &module.fixed {
                let own = eds.object(fixed.index).and_then(|object| object.description.as_ref());
                if let Some(own) = own {
                    let (index, number) = (fixed.index, module.number);
                    report
                        .at(
                            fixed.header(),
                            format!("{index:04X}h comes with module {number}, but the device has it anyway"),
                        )
                        .related(own.header, "the device's own")
                        .help("remove one of the two");
                }
            }
        }
    }
}
