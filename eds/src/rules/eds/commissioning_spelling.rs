use crate::{
    diagnostic::Level,
    document::{Document, SectionName},
    fix::Fix,
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds the section `[DeviceCommissioning]`, spelled as English has it.
    ///
    /// ## Why it matters
    /// The standard spells it `[DeviceComissioning]`, with one m. Most readers look for that alone, and miss the node-ID and the
    /// bit rate.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceCommissioning]
    /// NodeID=5
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, device configuration file
    pub(crate) CommissioningSpelling { code: "EDS024", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl DocumentRule for CommissioningSpelling {
    fn check(document: &Document, report: &mut Report) {
        let sections = document.sections().iter();
        for section in sections.filter(|section| section.name == SectionName::DeviceCommissioning) {
            if document.text(section.label).to_ascii_lowercase().contains("mm") {
                report
                    .at(section.label, "[DeviceComissioning] has one m in the standard")
                    .help("write [DeviceComissioning]")
                    .fix(Fix::replace(section.label, "DeviceComissioning"));
            }
        }
    }
}
