use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sub-objects, and names or values of a compact form, whose object has no section.
    ///
    /// ## Why it matters
    /// Readers that start at the object never see them.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x9
    /// SubNumber=1
    ///
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object sections and object links; CANchkEDS V7, V40
    pub(crate) OrphanedSubObject { code: "EDS016", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for OrphanedSubObject {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::OrphanedSubs { index, at } = *problem {
                report
                    .at(at, format!("object {index:04X}h has no section of its own"))
                    .help(format!("write a section [{index:04X}] before it"));
            }
        }
    }
}
