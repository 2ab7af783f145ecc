use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects with both SubNumber and CompactSubObj, neither of them 0.
    ///
    /// ## Why it matters
    /// The one says that the sub-objects have sections, the other that they have none. Readers take the one or the other.
    ///
    /// ## Example
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// SubNumber=3
    /// CompactSubObj=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// CompactSubObj=2
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, SubNumber and CompactSubObj
    pub(crate) MixedStructure { code: "OBJ025", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for MixedStructure {
    fn check(eds: &Eds, report: &mut Report) {
        for object in &eds.objects {
            let Some(description) = &object.description else {
                continue;
            };
            let number = description.sub_number.filter(|number| number.value > 0);
            let compact = description.compact_sub_obj.filter(|number| number.value > 0);
            if let Some((number, compact)) = number.zip(compact) {
                let index = object.index;
                report
                    .at(
                        compact.span,
                        format!("{index:04X}h has CompactSubObj, but SubNumber as well"),
                    )
                    .related(number.span, "how many sub-objects have sections")
                    .help("write only one of them");
            }
        }
    }
}
