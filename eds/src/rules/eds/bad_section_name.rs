use crate::{
    diagnostic::Level,
    document::{Document, Problem, SectionName},
    fix::Fix,
    rules::{DocumentRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds sections whose name can be understood but is not written as the standard writes it: `[0x1000]`, `[1018sub01]`,
    /// `[ 1000]`, `[1018 sub 1]`.
    ///
    /// ## Why it matters
    /// Readers look for the name letter by letter and do not find the object.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub01]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object sections; CANchkEDS V12
    pub(crate) BadSectionName { code: "EDS011", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl DocumentRule for BadSectionName {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::BadSectionName { at } = *problem {
                let section = report.quote(at);
                let spelled = SectionName::parse(report.text(at)).spelling();
                report
                    .at(
                        at,
                        format!("section name {section} is not written as the standard has it"),
                    )
                    .help(
                        "write four hexadecimal digits for an index, no `0x`, no blank, no leading zero in a sub-index",
                    )
                    .fix(spelled.map(|spelled| Fix::replace(between_brackets(document, at), spelled)));
            }
        }
    }
}

/// The label with the blanks around it, which belong to the name as some readers take it.
fn between_brackets(document: &Document, label: Span) -> Span {
    document.section_around(label).map_or(label, |section| {
        let header = document.text(section.header);
        let opening = u32::from(header.starts_with('['));
        let closing = u32::from(header.ends_with(']'));
        Span::new(section.header.start + opening, section.header.end - closing)
    })
}
