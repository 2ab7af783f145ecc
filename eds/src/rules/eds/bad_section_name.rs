use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sections whose name can be understood but is not written as the standard writes it: `[0x1000]`, `[1018sub01]`,
    /// `[ 1000]`, `[1018 sub 1]`.
    ///
    /// ## Why it matters
    /// Readers look for the name letter by letter and do not find the object.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub01]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object sections; CANchkEDS V12
    pub(crate) BadSectionName { code: "EDS011", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for BadSectionName {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::BadSectionName { at } = *problem {
                let section = report.quote(at);
                report
                    .at(
                        at,
                        format!("section name {section} is not written as the standard has it"),
                    )
                    .help(
                        "write four hexadecimal digits for an index, no `0x`, no blank, no leading zero in a sub-index",
                    );
            }
        }
    }
}
