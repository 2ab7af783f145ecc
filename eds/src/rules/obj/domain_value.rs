use crate::{
    diagnostic::Level,
    ir::DataType,
    model::{Eds, Expected, Problem},
    rules::{ModelRule, Report, declare_rule, value_name},
};

declare_rule! {
    /// ## What it does
    /// Finds values of DOMAINs that are no bytes. Editors write 0 where a DOMAIN has none.
    ///
    /// ## Why it matters
    /// A DOMAIN is a file, a program, a log. A reader that wants its bytes finds none in `0`.
    ///
    /// ## Example
    /// ```ini
    /// [1F50sub1]
    /// DataType=0x000F
    /// DefaultValue=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1F50sub1]
    /// DataType=0x000F
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, DefaultValue
    pub(crate) DomainValue { code: "OBJ020", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for DomainValue {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            if let Problem::Unreadable {
                keyword,
                expected: Expected::Value(DataType::Domain),
                at,
                ..
            } = *problem
            {
                let (keyword, value) = (value_name(keyword), report.quote(at));
                report
                    .at(at, format!("{keyword} {value} means nothing for a DOMAIN"))
                    .help("remove it, or write pairs of hex digits, such as 01FF");
            }
        }
    }
}
