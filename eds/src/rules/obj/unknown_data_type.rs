use super::words::FIRST_OF_VENDORS;
use crate::{
    Reading,
    diagnostic::Level,
    document::Keyword,
    ir, model,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values whose DataType is missing, empty or unreadable, is reserved by CiA 301, or is a structure (20h to 3Fh), which
    /// only a whole object can have.
    ///
    /// ## Why it matters
    /// Nobody knows how long the value is and what its bytes mean.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// ObjectType=0x7
    /// AccessType=rw
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// ObjectType=0x7
    /// DataType=0x0006
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, DataType; CiA 301, data types; CANchkEDS V26, V31, V32
    pub(crate) UnknownDataType { code: "OBJ005", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for UnknownDataType {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in reading.eds.problems() {
            check_read(problem, report);
        }
        for problem in &reading.problems {
            check_lowered(problem, report);
        }
    }
}

const CURE: &str = "write the index of a data type, such as 0x0007 for UNSIGNED32";

fn check_read(problem: &model::Problem, report: &mut Report) {
    match *problem {
        model::Problem::EmptyValue {
            keyword: Keyword::DataType,
            at,
            ..
        } => {
            report.at(at, "keyword DataType has no value").help(CURE);
        }
        model::Problem::Unreadable {
            keyword: Keyword::DataType,
            at,
            ..
        } => {
            let value = report.quote(at);
            report.at(at, format!("DataType {value} does not exist")).help(CURE);
        }
        _ => {}
    }
}

fn check_lowered(problem: &ir::Problem, report: &mut Report) {
    match *problem {
        ir::Problem::MissingKeyword {
            keyword: Keyword::DataType,
            at,
            ..
        } => {
            report.at(at, "keyword DataType is missing").help(CURE);
        }
        ir::Problem::UnknownDataType { data_type, at, .. } if data_type < FIRST_OF_VENDORS => {
            let value = report.quote(at);
            let fact = match data_type {
                0x20..=0x3F => "is a structure, not the type of a value",
                _ => "is reserved by CiA 301",
            };
            report.at(at, format!("DataType {value} {fact}")).help(CURE);
        }
        _ => {}
    }
}
