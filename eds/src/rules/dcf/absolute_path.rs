use super::file_entries::file_entries;
use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds an UploadFile or DownloadFile with a path that starts at a drive, a server or the root.
    ///
    /// ## Why it matters
    /// The file is not found on another machine than the one where the DCF was made.
    ///
    /// ## Example
    /// ```ini
    /// [1F50sub1]
    /// DownloadFile=C:\projects\pump\program.bin
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1F50sub1]
    /// DownloadFile=program.bin
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.2, UploadFile and DownloadFile
    pub(crate) AbsolutePath { code: "DCF012", level: Level::Note, since: "0.1.0" }
}

impl ReadingRule for AbsolutePath {
    fn check(reading: &Reading, report: &mut Report) {
        for (entry, _) in file_entries(reading) {
            if is_absolute(report.text(entry.value)) {
                let value = report.quote(entry.value);
                report
                    .at(entry.value, format!("path {value} holds on one machine only"))
                    .help("put the file beside the DCF, and write its name");
            }
        }
    }
}

/// Whether the path starts at a drive, a server or the root, in the way of Windows or of Unix.
fn is_absolute(path: &str) -> bool {
    let drive = matches!(path.as_bytes(), [letter, b':', ..] if letter.is_ascii_alphabetic());
    drive || path.starts_with(['/', '\\'])
}
