use crate::{
    diagnostic::Level,
    document::Keyword,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords of `[DeviceInfo]` that older versions of the standard had and today's reserves: ProductVersion,
    /// ProductRevision, ExtendedBootUpMaster, ExtendedBootUpSlave, LMT_ManufacturerName, LMT_ProductName.
    ///
    /// ## Why it matters
    /// Readers of today pass over them, and what they said is lost.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// ProductRevision=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// RevisionNumber=2
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, [DeviceInfo]; CANchkEDS W22
    pub(crate) LegacyKeyword { code: "EDS019", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for LegacyKeyword {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            if let Problem::LegacyKeyword { keyword, at } = *problem {
                let cure = match keyword {
                    Keyword::ProductVersion | Keyword::ProductRevision => "write RevisionNumber",
                    Keyword::LmtManufacturerName => "write VendorName",
                    Keyword::LmtProductName => "write ProductName",
                    _ => "remove it",
                };
                report
                    .at(
                        at,
                        format!("keyword {} is reserved since version 4 of EDS", keyword.name()),
                    )
                    .help(cure);
            }
        }
    }
}
