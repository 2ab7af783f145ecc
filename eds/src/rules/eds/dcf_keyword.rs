use crate::{
    diagnostic::Level,
    document::{Document, Keyword, SectionName},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords in an EDS that only a DCF has: LastEDS, ParameterValue, Denotation, UploadFile, DownloadFile. A file is taken
    /// for a DCF when its name ends in `.dcf` or it has the section `[DeviceComissioning]`.
    ///
    /// ## Why it matters
    /// An EDS describes every device of its kind. A value of one device in it is taken by some tools and passed over by others.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    /// LastEDS=old.eds
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, device configuration file; CANchkEDS W21
    pub(crate) DcfKeyword { code: "EDS021", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for DcfKeyword {
    fn check(document: &Document, report: &mut Report) {
        if is_dcf(document) {
            return;
        }
        for entry in document.sections().iter().flat_map(|section| &section.entries) {
            if is_of_dcf(entry.keyword) {
                report
                    .at(entry.key, format!("keyword {} belongs in a DCF", entry.keyword.name()))
                    .help("remove it, or add [DeviceComissioning] if this is a DCF");
            }
        }
    }
}

fn is_dcf(document: &Document) -> bool {
    let name = document.source().name().as_bytes();
    let named = name
        .last_chunk()
        .is_some_and(|end: &[u8; 4]| end.eq_ignore_ascii_case(b".dcf"));
    let mut sections = document.sections().iter();
    named || sections.any(|section| section.name == SectionName::DeviceCommissioning)
}

const fn is_of_dcf(keyword: Keyword) -> bool {
    matches!(
        keyword,
        Keyword::LastEds | Keyword::ParameterValue | Keyword::Denotation | Keyword::UploadFile | Keyword::DownloadFile
    )
}
