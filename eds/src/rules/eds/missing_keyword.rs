use crate::{
    diagnostic::Level,
    document::{Document, Keyword, Section, SectionName},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sections that lack a keyword which the standard asks for and which has no default.
    ///
    /// ## Why it matters
    /// Masters choose the file of a device by vendor, product and revision, and show objects by their names. A count that is
    /// missing makes a list look empty.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ObjectType=0x7
    /// DataType=0x0006
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
    /// CiA 306-1, the keywords of each section; CANchkEDS V26. A missing DataType is OBJ005, a missing AccessType OBJ007.
    pub(crate) MissingKeyword { code: "EDS002", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for MissingKeyword {
    fn check(document: &Document, report: &mut Report) {
        for section in document.sections() {
            for keyword in required(section.name) {
                if !has(section, *keyword) {
                    let name = keyword.name();
                    report
                        .at(section.header, format!("keyword {name} is missing"))
                        .help(format!("write `{name}=…` in this section"));
                }
            }
        }
    }
}

const fn required(section: SectionName) -> &'static [Keyword] {
    match section {
        SectionName::FileInfo => &[
            Keyword::FileName,
            Keyword::FileVersion,
            Keyword::FileRevision,
            Keyword::EdsVersion,
        ],
        SectionName::DeviceInfo => &[
            Keyword::VendorName,
            Keyword::VendorNumber,
            Keyword::ProductName,
            Keyword::NrOfRxPdo,
            Keyword::NrOfTxPdo,
        ],
        SectionName::MandatoryObjects | SectionName::OptionalObjects | SectionName::ManufacturerObjects => {
            &[Keyword::SupportedObjects]
        }
        SectionName::Object(_) | SectionName::Sub(..) => &[Keyword::ParameterName],
        _ => &[],
    }
}

fn has(section: &Section, keyword: Keyword) -> bool {
    section.entries.iter().any(|entry| entry.keyword == keyword)
}
