use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
    source::Encoding,
};

declare_rule! {
    /// ## What it does
    /// Finds characters beyond ASCII. One finding a line, at the first of them.
    ///
    /// ## Why it matters
    /// The format knows no encoding, so tools guess: `ä` of one program is `�` or `õ` in another. Names that a master shows, and
    /// the identifiers that a generator makes of them, differ between tools.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// ParameterName=Spannung für Ausgang 1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// ParameterName=Spannung fuer Ausgang 1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: ASCII
    pub(crate) TextNotAscii { code: "INI004", level: Level::Note, since: "0.1.0" }
}

impl DocumentRule for TextNotAscii {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::NotAscii { at, encoding } = *problem {
                let read_as = match encoding {
                    Encoding::Utf8 => "UTF-8",
                    Encoding::Windows1252 => "Windows-1252",
                    Encoding::Cp850 => "CP850",
                };
                report
                    .at(
                        at,
                        format!("{} is not ASCII; the line was read as {read_as}", report.quote(at)),
                    )
                    .help("write it in ASCII");
            }
        }
    }
}
