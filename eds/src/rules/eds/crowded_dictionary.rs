use std::collections::HashSet;

use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds modules and compact forms that stand for more than fits: object 1027h lists 254 modules, an object has 254
    /// sub-indices for what they add, and beyond 500,000 values without a section of their own a file is taken for broken.
    ///
    /// ## Why it matters
    /// What is beyond that is not in the dictionary.
    ///
    /// ## Example
    /// ```ini
    /// [ConnectedModules]
    /// NrOfEntries=255
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, modular devices; CiA 301, object 1027h
    pub(crate) CrowdedDictionary { code: "EDS030", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for CrowdedDictionary {
    fn check(reading: &Reading, report: &mut Report) {
        let mut full = HashSet::new();
        for problem in &reading.problems {
            match *problem {
                Problem::TooManyModules { at } => {
                    report
                        .at(at, "more than 254 modules are connected")
                        .help("connect fewer modules");
                }
                // Each sub-object that does not fit is a problem; that the object is full is one finding.
                Problem::NoRoomForModule { index, at } if full.insert(index) => {
                    report
                        .at(at, format!("the connected modules do not fit into object {index:04X}h"))
                        .help("connect fewer modules, or let ObjExtend go on in the next object");
                }
                Problem::TooManyValues { index, at } if full.insert(index) => {
                    report
                        .at(
                            at,
                            format!("the values of {index:04X}h are left out: the file stands for too many"),
                        )
                        .help("look for a count that is too large, here or above");
                }
                _ => {}
            }
        }
    }
}
