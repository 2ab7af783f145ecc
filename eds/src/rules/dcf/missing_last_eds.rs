use super::files::is_named_dcf;
use crate::{
    diagnostic::Level,
    document::{Document, Keyword, SectionName},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds DCFs without the keyword LastEDS in `[FileInfo]`.
    ///
    /// ## Why it matters
    /// It names the EDS that the DCF was made from: the one to compare with when the device gets a new firmware.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileName=pump1.dcf
    ///
    /// [DeviceComissioning]
    /// NodeID=5
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=pump1.dcf
    /// LastEDS=pump.eds
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.2
    pub(crate) MissingLastEds { code: "DCF003", level: Level::Note, since: "0.1.0" }
}

impl DocumentRule for MissingLastEds {
    fn check(document: &Document, report: &mut Report) {
        if !is_named_dcf(document) {
            return;
        }
        let mut sections = document.sections().iter();
        let Some(info) = sections.find(|section| section.name == SectionName::FileInfo) else {
            return;
        };
        if info.entries.iter().all(|entry| entry.keyword != Keyword::LastEds) {
            report
                .at(info.header, "keyword LastEDS is missing")
                .help("write `LastEDS=` with the name of the EDS that the DCF was made from");
        }
    }
}
