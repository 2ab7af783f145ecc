use crate::{
    diagnostic::Level,
    document::{Document, Keyword},
    fix::Fix,
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords that differ from the standard's spelling in the case of their letters.
    ///
    /// ## Why it matters
    /// The standard does not say whether case matters. Windows' INI functions never cared; readers written since sometimes do.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// NrOfRxPDO=4
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// NrOfRXPDO=4
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, the keywords of each section
    pub(crate) KeywordSpelling { code: "EDS012", level: Level::Note, since: "0.1.0", fixable: Always }
}

impl DocumentRule for KeywordSpelling {
    fn check(document: &Document, report: &mut Report) {
        for entry in document.sections().iter().flat_map(|section| &section.entries) {
            if entry.keyword != Keyword::Unknown && !entry.keyword.is_spelled(document.text(entry.key)) {
                let (keyword, spelled) = (report.quote(entry.key), entry.keyword.spelling().unwrap_or_default());
                report
                    .at(
                        entry.key,
                        format!("keyword {keyword} is not spelled as in the standard"),
                    )
                    .help(format!("write `{spelled}`"))
                    .fix(Fix::replace(entry.key, spelled));
            }
        }
    }
}
