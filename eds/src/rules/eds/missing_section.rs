use crate::{
    diagnostic::Level,
    document::{Document, SectionName},
    rules::{DocumentRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds files without one of the sections `[FileInfo]`, `[DeviceInfo]` and `[MandatoryObjects]`.
    ///
    /// ## Why it matters
    /// Without the first two nobody knows what the file is about, or which device it is; readers that need them refuse the file.
    /// Without the third a master that goes by the lists does not see the objects that every device has.
    ///
    /// ## Example
    /// An EDS that starts with `[DeviceInfo]`.
    ///
    /// ## Reference
    /// CiA 306-1, general sections; CANchkEDS V1
    pub(crate) MissingSection { code: "EDS001", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for MissingSection {
    fn check(document: &Document, report: &mut Report) {
        for (name, label) in REQUIRED {
            if !document.sections().iter().any(|section| section.name == name) {
                report
                    .at(Span::default(), format!("section [{label}] is missing"))
                    .help(format!("write a section [{label}]"));
            }
        }
    }
}

const REQUIRED: [(SectionName, &str); 3] = [
    (SectionName::FileInfo, "FileInfo"),
    (SectionName::DeviceInfo, "DeviceInfo"),
    (SectionName::MandatoryObjects, "MandatoryObjects"),
];
