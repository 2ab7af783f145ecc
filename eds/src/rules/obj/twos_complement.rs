use super::words::value_name;
use crate::{
    diagnostic::Level,
    literal::Note,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds hex numbers of signed types that stand for a negative value by their top bit: 0xFF of INTEGER8 is -1.
    ///
    /// ## Why it matters
    /// The standard writes negative numbers with a sign. Some readers take the number for a large positive one, find it out of
    /// range, and refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [607D]
    /// DataType=0x0004
    /// DefaultValue=0x80000000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [607D]
    /// DataType=0x0004
    /// DefaultValue=-2147483648
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers
    pub(crate) TwosComplement { code: "OBJ011", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for TwosComplement {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            if let Problem::Unusual {
                keyword,
                note: Note::TwosComplement,
                at,
                ..
            } = *problem
            {
                let (keyword, value) = (value_name(keyword), report.quote(at));
                report
                    .at(at, format!("{keyword} {value} is a negative number in hex"))
                    .help("write it in decimal, with a sign");
            }
        }
    }
}
