use crate::{
    diagnostic::Level,
    fix::Fix,
    literal::{Fault, Note},
    model::{Eds, Expected, Problem},
    rules::{ModelRule, Report, certain_decimal, declare_rule, octal_cure, value_name},
};

declare_rule! {
    /// ## What it does
    /// Finds values and limits with a leading zero where it matters: as the standard has it, a leading zero makes a number octal.
    ///
    /// ## Why it matters
    /// `010` is 8 for one reader and 10 for another. `08` and `09` are no octal numbers at all.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// DefaultValue=0100
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// DefaultValue=100
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers; CANchkEDS V21
    pub(crate) OctalValue { code: "OBJ021", level: Level::Deny, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for OctalValue {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            let fact = match *problem {
                Problem::Unusual {
                    expected: Expected::Value(_),
                    note: Note::Octal,
                    ..
                } => "is octal, because it starts with 0",
                Problem::Unreadable {
                    expected: Expected::Value(_),
                    fault: Fault::NotOctal,
                    ..
                } => "starts with 0, but is no octal number",
                _ => continue,
            };
            let (keyword, value) = (value_name(problem.keyword()), report.quote(problem.span()));
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
