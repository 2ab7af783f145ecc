use crate::{
    diagnostic::Level,
    fix::Fix,
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
    pub(crate) QuotedText { code: "EDS027", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for QuotedText {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, at, .. } in unusual(eds, Note::Quoted) {
            let (value, plain) = (report.quote(at), without_quotes(report.text(at)));
            report
                .at(at, format!("{keyword} {value} is in quotes"))
                .help("leave out the quotes")
                .fix(plain.map(|text| Fix::replace(at, text)));
        }
    }
}

/// The text between the quotes, unless it would be read otherwise without them.
fn without_quotes(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('"')?.strip_suffix('"')?;
    (!inner.is_empty() && inner.trim() == inner).then_some(inner)
}
