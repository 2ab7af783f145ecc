use crate::{
    diagnostic::Level,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords of the standard in a section where they mean nothing.
    ///
    /// ## Why it matters
    /// Readers pass over them, and the value is lost.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    /// VendorName=Example
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    ///
    /// [DeviceInfo]
    /// VendorName=Example
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V24
    pub(crate) MisplacedKeyword { code: "EDS020", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for MisplacedKeyword {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            if let Problem::MisplacedKeyword { at, .. } = *problem {
                let keyword = report.quote(at);
                report
                    .at(at, format!("keyword {keyword} means nothing in this section"))
                    .help("move it to its section, or remove it");
            }
        }
    }
}
