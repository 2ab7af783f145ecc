use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds modules in `[ConnectedModules]` that the file does not describe, and fixed objects of a module that have no section.
    ///
    /// ## Why it matters
    /// The file says that the device has the module and its objects, and nothing about them.
    ///
    /// ## Example
    /// ```ini
    /// [SupportedModules]
    /// NrOfEntries=1
    ///
    /// [ConnectedModules]
    /// NrOfEntries=1
    /// 1=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [SupportedModules]
    /// NrOfEntries=1
    ///
    /// [ConnectedModules]
    /// NrOfEntries=1
    /// 1=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, modular devices; CANchkEDS V52
    pub(crate) AbsentModule { code: "EDS029", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for AbsentModule {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            match *problem {
                Problem::UnknownModule { number, at } => {
                    report
                        .at(at, format!("module {number} is connected, but not described"))
                        .help(format!("write a section [M{number}ModuleInfo], or fix the number"));
                }
                Problem::AbsentModuleObject { number, index, at } => {
                    report
                        .at(at, format!("object {index:04X}h of module {number} has no section"))
                        .help(format!(
                            "write a section [M{number}Fixed{index:04X}], or take the object off the list"
                        ));
                }
                _ => {}
            }
        }
    }
}
