use super::file_entries::file_entries;
use crate::{
    Reading,
    diagnostic::Level,
    document::Keyword,
    ir::DataType,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds an UploadFile of an object that cannot be read, and a DownloadFile of one that cannot be written.
    ///
    /// ## Why it matters
    /// Upload and download are seen from the device: an upload reads the object into the file, a download writes the file into the object.
    /// The device aborts the transfer.
    ///
    /// ## Example
    /// ```ini
    /// [1F50sub1]
    /// ParameterName=Program data
    /// DataType=0x000F
    /// AccessType=wo
    /// UploadFile=program.bin
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1F50sub1]
    /// ParameterName=Program data
    /// DataType=0x000F
    /// AccessType=wo
    /// DownloadFile=program.bin
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.2, UploadFile and DownloadFile; CANchkEDS V28
    pub(crate) ContraryFile { code: "DCF011", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for ContraryFile {
    fn check(reading: &Reading, report: &mut Report) {
        // What is no DOMAIN is DCF010.
        for (entry, value) in file_entries(reading).filter(|(_, value)| value.data_type == DataType::Domain) {
            let (fact, right) = match entry.keyword {
                Keyword::UploadFile if !value.access.readable() => ("cannot be read", Keyword::DownloadFile),
                Keyword::DownloadFile if !value.access.writable() => ("cannot be written", Keyword::UploadFile),
                _ => continue,
            };
            let (keyword, right) = (entry.keyword.name(), right.name());
            report
                .at(entry.key, format!("{keyword} stands at an object that {fact}"))
                .help(format!("write `{right}=`, or fix the AccessType"));
        }
    }
}
