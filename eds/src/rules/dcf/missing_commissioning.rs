use super::files::is_named_dcf;
use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds DCFs, files that are called `….dcf`, without the section `[DeviceComissioning]`.
    ///
    /// ## Why it matters
    /// The section says which node on which network the file configures. Without it a tool has no node-ID for `$NODEID`, and no bit rate.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileName=pump1.dcf
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=pump1.dcf
    ///
    /// [DeviceComissioning]
    /// NodeID=5
    /// Baudrate=500
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.3
    pub(crate) MissingCommissioning { code: "DCF001", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for MissingCommissioning {
    fn check(reading: &Reading, report: &mut Report) {
        if reading.eds.commissioning.is_none() && is_named_dcf(&reading.document) {
            report
                .at(Span::default(), "this DCF has no section [DeviceComissioning]")
                .help("write [DeviceComissioning] with NodeID and Baudrate, or call the file `.eds` if it is for any node");
        }
    }
}
