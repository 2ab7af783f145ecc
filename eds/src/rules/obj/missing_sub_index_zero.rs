use crate::{
    Reading,
    diagnostic::Level,
    document::{Keyword, SectionName},
    fix::{Change, Fix},
    ir::{Address, Problem},
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays and records with sub-objects, but without sub-index 0.
    ///
    /// ## Why it matters
    /// Sub-index 0 says how many there are. A master that asks for it first gets an abort and gives up.
    ///
    /// ## Example
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// ObjectType=0x8
    /// SubNumber=1
    ///
    /// [1003sub1]
    /// ParameterName=Standard error field 1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// ObjectType=0x8
    /// SubNumber=2
    ///
    /// [1003sub0]
    /// ParameterName=Number of errors
    ///
    /// [1003sub1]
    /// ParameterName=Standard error field 1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, sub-index 0; CANchkEDS V14
    pub(crate) MissingSubIndexZero { code: "OBJ009", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl ReadingRule for MissingSubIndexZero {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::MissingSubZero { index, highest, at } = *problem {
                let count = sub_number(reading, index, report);
                let fix = count
                    .into_iter()
                    .fold(Fix::new(section(reading, index, highest)), Fix::and);
                report
                    .at(at, format!("object {index:04X}h has no sub-index 0"))
                    .help(format!("write a section [{index:04X}sub0] with DefaultValue={highest}"))
                    .fix(fix);
            }
        }
    }
}

/// The section as the dictionary has it already.
fn section(reading: &Reading, index: u16, highest: u8) -> Change {
    let assumed = reading.dictionary.entry(Address::new(index, 0));
    let name = assumed.map(|entry| entry.name.clone()).unwrap_or_default();
    let entries = [
        (Keyword::ParameterName, name),
        (Keyword::ObjectType, "0x7".to_owned()),
        (Keyword::DataType, "0x0005".to_owned()),
        (Keyword::AccessType, "ro".to_owned()),
        (Keyword::DefaultValue, highest.to_string()),
        (Keyword::PdoMapping, "0".to_owned()),
    ];
    Change::Section {
        name: SectionName::Sub(index, 0),
        entries: entries.into(),
    }
}

/// One more in SubNumber, where that is the number of sections so far. Otherwise it is EDS009.
fn sub_number(reading: &Reading, index: u16, report: &Report) -> Option<Change> {
    let object = reading.eds.object(index)?;
    let number = object.description.as_ref()?.sub_number?;
    (usize::from(number.value) == object.subs.len()).then(|| Change::Replace {
        at: report.bare(number.span),
        text: (object.subs.len() + 1).to_string(),
    })
}
