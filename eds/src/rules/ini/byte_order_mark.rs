use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    fix::{Change, Fix},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds files that start with the byte order mark of UTF-8.
    ///
    /// ## Why it matters
    /// An EDS is ASCII, where no such mark is known: readers glue its three bytes to the first line, and the first section gets
    /// lost. Windows' editors write it when asked to save as "UTF-8 with BOM".
    ///
    /// ## Example
    /// A file that starts with the bytes `EF BB BF`.
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: ASCII
    pub(crate) ByteOrderMark { code: "INI011", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl DocumentRule for ByteOrderMark {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::ByteOrderMark { at } = *problem {
                report
                    .at(at, "a byte order mark comes before this line")
                    .help("save the file as ASCII, or as UTF-8 without a byte order mark")
                    .fix(Fix::new(Change::ByteOrderMark));
            }
        }
    }
}
