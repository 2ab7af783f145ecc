use super::files::is_named_eds;
use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds EDSs, files that are called `….eds`, with the section `[DeviceComissioning]`, which belongs in a DCF.
    ///
    /// ## Why it matters
    /// An EDS describes every device of its kind. Some tools take the node-ID in it for that of each node that they add, others pass over
    /// it.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    ///
    /// [DeviceComissioning]
    /// NodeID=5
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=pump1.dcf
    /// LastEDS=pump.eds
    ///
    /// [DeviceComissioning]
    /// NodeID=5
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.3
    pub(crate) CommissionedEds { code: "DCF002", level: Level::Note, since: "0.1.0" }
}

impl ReadingRule for CommissionedEds {
    fn check(reading: &Reading, report: &mut Report) {
        let commissioning = reading.eds.commissioning.as_ref();
        if let Some(section) = commissioning.filter(|_| is_named_eds(&reading.document)) {
            report
                .at(section.header, "this EDS says how one device is configured")
                .help("remove the section, or call the file `.dcf`");
        }
    }
}
