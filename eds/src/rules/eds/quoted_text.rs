use crate::{
    diagnostic::Level,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
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
        for Unusual { keyword, at, .. } in unusual(eds, Note::Quoted) {
            let value = report.quote(at);
            report
                .at(at, format!("{keyword} {value} is in quotes"))
                .help("leave out the quotes");
        }
    }
}
