use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds `[xxxxName]` and `[xxxxValue]` of an object without CompactSubObj.
    ///
    /// ## Why it matters
    /// These lists name the sub-objects that have no section of their own. Readers look for them only behind CompactSubObj; the names and
    /// values are lost.
    ///
    /// ## Example
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// SubNumber=2
    ///
    /// [2100Value]
    /// NrOfEntries=1
    /// 1=100
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100]
    /// ParameterName=Calibration
    /// CompactSubObj=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, CompactSubObj
    pub(crate) ListWithoutCompactForm { code: "EDS033", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for ListWithoutCompactForm {
    fn check(eds: &Eds, report: &mut Report) {
        for object in &eds.objects {
            // Of an object without section it is EDS016.
            let Some(description) = &object.description else {
                continue;
            };
            if description.compact_sub_obj.is_some_and(|count| count.value > 0) {
                continue;
            }
            let names = object.names.as_ref().map(|list| (list.header, "names"));
            let values = object.values.as_ref().map(|list| (list.header, "values"));
            for (header, what) in names.into_iter().chain(values) {
                let index = object.index;
                report
                    .at(
                        header,
                        format!("{what} are listed, but {index:04X}h has no CompactSubObj"),
                    )
                    .help("write CompactSubObj at the object, or give each sub-object a section");
            }
        }
    }
}
