use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds an EDSVersion below 4.0, and one that is no version at all.
    ///
    /// ## Why it matters
    /// Before version 4 keywords had other names and meanings. A reader that goes by the version looks for those.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// EDSVersion=3.0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// EDSVersion=4.0
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, [FileInfo]; CANchkEDS V41
    pub(crate) OldEdsVersion { code: "EDS023", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for OldEdsVersion {
    fn check(eds: &Eds, report: &mut Report) {
        let info = eds.file_info.as_ref();
        let Some(version) = info.and_then(|info| info.eds_version.as_ref()) else {
            return;
        };
        let major = version
            .value
            .split('.')
            .next()
            .and_then(|major| major.trim().parse().ok());
        // 301 or 402 is the number of a standard, where the version of this one should be.
        if !major.is_some_and(|major: u16| (4..=9).contains(&major)) {
            let value = report.quote(version.span);
            report
                .at(version.span, format!("EDSVersion {value} is not 4.0 or later"))
                .help("write `EDSVersion=4.0`");
        }
    }
}
