use super::file_entries::file_entries;
use crate::{
    Reading,
    diagnostic::Level,
    ir::DataType,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds UploadFile and DownloadFile of objects that are no DOMAIN.
    ///
    /// ## Why it matters
    /// Only a DOMAIN is transferred as a file; a value of another type stands in ParameterValue. Most tools pass over the file.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// ParameterName=Gain
    /// DataType=0x0006
    /// DownloadFile=gain.bin
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// ParameterName=Gain
    /// DataType=0x0006
    /// ParameterValue=100
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.2, UploadFile and DownloadFile
    pub(crate) FileForValue { code: "DCF010", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for FileForValue {
    fn check(reading: &Reading, report: &mut Report) {
        for (entry, value) in file_entries(reading) {
            if value.data_type != DataType::Domain {
                let (keyword, data_type) = (entry.keyword.name(), value.data_type.name());
                report
                    .at(
                        entry.key,
                        format!("{keyword} stands at {data_type}; it goes with DOMAIN"),
                    )
                    .help("write the value as ParameterValue, or fix the DataType");
            }
        }
    }
}
