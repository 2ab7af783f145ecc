use crate::{
    Reading,
    diagnostic::Level,
    document::{Entry, Keyword, SectionName},
    ir::ObjectCode,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords that do not go with the ObjectType: SubNumber of a single value; AccessType, DefaultValue or
    /// limits of an array or record, and DataType of a record, whose sub-objects have these.
    ///
    /// ## Why it matters
    /// Readers pass over them, and what was meant for the sub-objects is lost.
    ///
    /// ## Example
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x9
    /// AccessType=ro
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
    /// CiA 306-1, keywords of objects; CANchkEDS V27
    pub(crate) MisplacedAttribute { code: "OBJ010", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for MisplacedAttribute {
    fn check(reading: &Reading, report: &mut Report) {
        for section in reading.document.sections() {
            let SectionName::Object(index) = section.name else {
                continue;
            };
            let Some(object) = reading.dictionary.object(index) else {
                continue;
            };
            // In the compact form the object's section says what the sub-objects have in common.
            let entries = &section.entries;
            let compact = entries.iter().any(|entry| entry.keyword == Keyword::CompactSubObj);
            let filled = entries.iter().filter(|entry| !entry.value.is_empty());
            for entry in filled.filter(|entry| !compact && !fits(entry.keyword, object.code)) {
                report_entry(entry, object.code, report);
            }
        }
    }
}

fn report_entry(entry: &Entry, code: ObjectCode, report: &mut Report) {
    let kind = match code {
        ObjectCode::Array => "an array",
        ObjectCode::Record | ObjectCode::DefStruct => "a record",
        _ => "a single value",
    };
    report
        .at(
            entry.key,
            format!("keyword {} means nothing for {kind}", entry.keyword.name()),
        )
        .help("remove it, or fix the ObjectType");
}

fn fits(keyword: Keyword, code: ObjectCode) -> bool {
    match code {
        ObjectCode::Record | ObjectCode::DefStruct => !matches!(
            keyword,
            Keyword::DataType
                | Keyword::AccessType
                | Keyword::DefaultValue
                | Keyword::ParameterValue
                | Keyword::LowLimit
                | Keyword::HighLimit
        ),
        ObjectCode::Array => !matches!(
            keyword,
            Keyword::DefaultValue | Keyword::ParameterValue | Keyword::LowLimit | Keyword::HighLimit
        ),
        _ => keyword != Keyword::SubNumber,
    }
}
