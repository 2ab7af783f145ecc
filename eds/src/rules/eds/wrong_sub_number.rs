use crate::{
    diagnostic::Level,
    document::Keyword,
    fix::{Change, Fix},
    ir::ObjectCode,
    model::{Eds, Object},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays and records whose SubNumber is missing, or is not the number of their sub-objects that have a section.
    ///
    /// ## Why it matters
    /// A reader that trusts the number loses sub-objects, or looks for some that are not there.
    ///
    /// ## Example
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x9
    /// SubNumber=5
    ///
    /// [1018sub0]
    /// …
    /// [1018sub1]
    /// …
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
    /// CiA 306-1, SubNumber; CANchkEDS V6, W2, V34
    pub(crate) WrongSubNumber { code: "EDS009", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl ModelRule for WrongSubNumber {
    fn check(eds: &Eds, report: &mut Report) {
        for object in &eds.objects {
            check_object(object, report);
        }
    }
}

fn check_object(object: &Object, report: &mut Report) {
    let Some(description) = &object.description else { return };
    let single = description
        .object_type
        .is_some_and(|code| code.value == ObjectCode::Var);
    // The compact form has sub-objects without section; an object that has no sub-objects has no number of them.
    if single || object.subs.is_empty() || description.compact_sub_obj.is_some_and(|compact| compact.value > 0) {
        return;
    }
    let sections = object.subs.len();
    let have = if sections == 1 {
        "sub-object has"
    } else {
        "sub-objects have"
    };
    let (span, message) = match description.sub_number {
        Some(number) if usize::from(number.value) == sections => return,
        Some(number) => (
            number.span,
            format!("SubNumber is {}, but {sections} {have} a section", number.value),
        ),
        None => (
            description.header,
            format!("SubNumber is missing; {sections} {have} a section"),
        ),
    };
    let fix = match description.sub_number {
        Some(number) => Fix::replace(report.bare(number.span), sections.to_string()),
        None => Fix::new(Change::Keyword {
            header: description.header,
            keyword: Keyword::SubNumber,
            value: sections.to_string(),
        }),
    };
    report
        .at(span, message)
        .help(format!("write `SubNumber={sections}`"))
        .fix((!description.mentions(Keyword::SubNumber) || description.sub_number.is_some()).then_some(fix));
}
