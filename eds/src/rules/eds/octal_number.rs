use crate::{
    diagnostic::Level,
    document::Keyword,
    fix::Fix,
    literal::{Fault, Note},
    model::{Eds, Expected, Problem},
    rules::{ModelRule, Report, certain_decimal, declare_rule, octal_cure},
};

declare_rule! {
    /// ## What it does
    /// Finds numbers with a leading zero where it matters: as the standard has it, a leading zero makes a number octal. Values of
    /// objects are OBJ021.
    ///
    /// ## Why it matters
    /// `010` is 8 for one reader and 10 for another. `08` and `09` are no octal numbers at all.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileRevision=08
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileRevision=8
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V21
    pub(crate) OctalNumber { code: "EDS013", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for OctalNumber {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            let fact = match *problem {
                // An object's value is OBJ021, an unreadable type OBJ005.
                Problem::Unusual {
                    expected: Expected::Value(_),
                    ..
                }
                | Problem::Unreadable {
                    expected: Expected::Value(_),
                    ..
                }
                | Problem::Unreadable {
                    keyword: Keyword::DataType,
                    ..
                } => continue,
                Problem::Unusual { note: Note::Octal, .. } => "is octal, because it starts with 0",
                Problem::Unreadable {
                    fault: Fault::NotOctal, ..
                } => "starts with 0, but is no octal number",
                _ => continue,
            };
            let (keyword, value) = (problem.keyword().name(), report.quote(problem.span()));
            let cure = octal_cure(report.text(problem.span()));
            let bare = report.bare(problem.span());
            let plain = certain_decimal(report.text(bare));
            report
                .at(problem.span(), format!("{keyword} {value} {fact}"))
                .help(cure)
                .fix(plain.map(|plain| Fix::replace(bare, plain)));
        }
    }
}
