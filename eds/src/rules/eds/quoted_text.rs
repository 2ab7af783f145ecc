use crate::{
    diagnostic::Level,
    literal::Note,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds texts in double quotes.
    ///
    /// ## Why it matters
    /// An EDS knows no quotes: to some readers they are a part of the text, to others they are not. Where the text is a default
    /// value, a device made from the file may answer with them.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// VendorName="Example"
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// VendorName=Example
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: entries
    pub(crate) QuotedText { code: "EDS027", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for QuotedText {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            if let Problem::Unusual {
                keyword,
                note: Note::Quoted,
                at,
                ..
            } = *problem
            {
                let (keyword, value) = (keyword.name(), report.quote(at));
                report
                    .at(at, format!("{keyword} {value} stands in quotes"))
                    .help("leave out the quotes");
            }
        }
    }
}
