use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    fix::{Change, Fix},
    rules::{DocumentRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds text behind a section's header on the same line.
    ///
    /// ## Why it matters
    /// Comments have a line of their own in an EDS. Readers take the text for a part of the name, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [1800] ; first TPDO
    /// ParameterName=TPDO communication parameter 1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// ; first TPDO
    /// [1800]
    /// ParameterName=TPDO communication parameter 1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: sections and entries
    pub(crate) TextAfterHeader { code: "INI008", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl DocumentRule for TextAfterHeader {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::TextAfterHeader { at } = *problem {
                let header = document
                    .section_around(at)
                    .map_or(at.start, |section| section.header.end);
                let behind = Span::new(header, at.end);
                let comment = report.text(at).trim_start_matches([' ', '\t', '#', ';']);
                report
                    .at(at, format!("text {} follows the header", report.quote(at)))
                    .help("move it to a line of its own that starts with `;`")
                    .fix(Fix::replace(behind, "").and(Change::Comment {
                        at,
                        text: comment.to_owned(),
                    }));
            }
        }
    }
}
