use crate::{
    Reading,
    diagnostic::Level,
    document::Keyword,
    ir::{self, ObjectCode},
    literal::Fault,
    model,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds an ObjectType that is not the number of an object code of CiA 301 (0, 2, 5, 6, 7, 8, 9), one that does not fit the
    /// rest of the object, and objects with sub-objects that have none.
    ///
    /// ## Why it matters
    /// Readers must guess whether the object is a value, an array or a record.
    ///
    /// ## Example
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x7
    /// SubNumber=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x9
    /// SubNumber=2
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object codes
    pub(crate) UnknownObjectType { code: "OBJ008", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for UnknownObjectType {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in reading.eds.problems() {
            check_read(problem, report);
        }
        for problem in &reading.problems {
            check_lowered(problem, reading, report);
        }
    }
}

const CURE: &str = "write 0x7 for a single value, 0x8 for an array, 0x9 for a record, 0x2 for a domain";

fn check_read(problem: &model::Problem, report: &mut Report) {
    match *problem {
        model::Problem::Unreadable {
            fault: Fault::NotOctal, ..
        } => {}
        model::Problem::Unreadable {
            keyword: Keyword::ObjectType,
            at,
            ..
        } => {
            let value = report.quote(at);
            report.at(at, format!("ObjectType {value} does not exist")).help(CURE);
        }
        _ => {}
    }
}

fn check_lowered(problem: &ir::Problem, reading: &Reading, report: &mut Report) {
    let ir::Problem::AssumedObjectCode { index, assumed, at } = *problem else {
        return;
    };
    let description = reading.eds.object(index).and_then(|object| object.description.as_ref());
    let looks = match assumed {
        ObjectCode::Array => "an array",
        ObjectCode::Record => "a record",
        _ => "a single value",
    };
    match description {
        Some(description) if description.object_type.is_some() => {
            let value = report.quote(at);
            report
                .at(
                    at,
                    format!("ObjectType {value} does not fit: the object looks like {looks}"),
                )
                .help(CURE);
        }
        // One that is there and cannot be read has its finding.
        Some(description) if description.mentions(Keyword::ObjectType) => {}
        _ => {
            report
                .at(
                    at,
                    format!("keyword ObjectType is missing: the object looks like {looks}"),
                )
                .help(CURE);
        }
    }
}
