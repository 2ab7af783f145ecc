use crate::{
    diagnostic::Level,
    document::{Document, Keyword, SectionName},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sections `[DeviceComissioning]` without NodeID or without Baudrate, or with an empty one.
    ///
    /// ## Why it matters
    /// They are what the section is there for: a tool that reads the file cannot reach the node.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceComissioning]
    /// NodeName=Pump 1
    /// Baudrate=500
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// NodeName=Pump 1
    /// Baudrate=500
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.3
    pub(crate) IncompleteCommissioning { code: "DCF004", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for IncompleteCommissioning {
    fn check(document: &Document, report: &mut Report) {
        let mut sections = document.sections().iter();
        let Some(section) = sections.find(|section| section.name == SectionName::DeviceCommissioning) else {
            return;
        };
        for (keyword, example) in [
            (Keyword::NodeId, "NodeID=5"),
            (Keyword::CommissionedBaudRate, "Baudrate=500"),
        ] {
            // One without value is EDS020.
            if section.entries.iter().all(|entry| entry.keyword != keyword) {
                let name = keyword.name();
                report
                    .at(section.header, format!("keyword {name} is missing"))
                    .help(format!("write `{name}=` with that of the node, such as `{example}`"));
            }
        }
    }
}
