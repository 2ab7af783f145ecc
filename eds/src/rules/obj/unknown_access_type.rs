use crate::{
    Reading,
    diagnostic::Level,
    document::Keyword,
    ir, model,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values whose AccessType is missing, empty, or none of `ro`, `wo`, `rw`, `rwr`, `rww` and `const`.
    ///
    /// ## Why it matters
    /// Nobody knows whether the value can be read or written.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DataType=0x0006
    /// AccessType=wr
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DataType=0x0006
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CANchkEDS V26, V29
    pub(crate) UnknownAccessType { code: "OBJ007", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for UnknownAccessType {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in reading.eds.problems() {
            check_read(problem, report);
        }
        for problem in &reading.problems {
            if let ir::Problem::MissingKeyword {
                keyword: Keyword::AccessType,
                at,
                ..
            } = *problem
            {
                report.at(at, "keyword AccessType is missing").help(CURE);
            }
        }
    }
}

const CURE: &str = "write ro, wo, rw, rwr, rww or const";

fn check_read(problem: &model::Problem, report: &mut Report) {
    match *problem {
        model::Problem::EmptyValue {
            keyword: Keyword::AccessType,
            at,
            ..
        } => {
            report.at(at, "keyword AccessType has no value").help(CURE);
        }
        model::Problem::Unreadable {
            keyword: Keyword::AccessType,
            at,
            ..
        } => {
            let value = report.quote(at);
            report.at(at, format!("AccessType {value} does not exist")).help(CURE);
        }
        _ => {}
    }
}
