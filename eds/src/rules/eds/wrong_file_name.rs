use crate::{
    Reading,
    diagnostic::Level,
    fix::Fix,
    rules::{ReadingRule, Report, declare_rule, quoted},
};

declare_rule! {
    /// ## What it does
    /// Finds a FileName that is not the name of the file. Upper and lower case count as the same; so does a DCF that keeps the name of the
    /// EDS it was made of.
    ///
    /// ## Why it matters
    /// Tools that manage many files, and support engineers, tell files apart by this name. Mostly a file was copied for a new device, and
    /// the name is that of the old one. But a third of the real files have been renamed for a good reason, such as a version or a
    /// blank in the name, so that nothing is said unless you ask for it: `--level EDS034=note`.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    /// ```
    /// in a file with the name `valve.eds`.
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=valve.eds
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, FileName
    pub(crate) WrongFileName { code: "EDS034", level: Level::Allow, since: "0.1.0", fixable: Sometimes }
}

impl ReadingRule for WrongFileName {
    fn check(reading: &Reading, report: &mut Report) {
        let stated = reading.eds.file_info.as_ref().and_then(|info| info.file_name.as_ref());
        let Some(stated) = stated.filter(|stated| !stated.value.is_empty()) else {
            return;
        };
        let actual = without_folders(reading.document.source().name());
        // What comes from standard input has no name.
        if is_description(actual) && !is_same(without_folders(&stated.value), actual) {
            let wrong = report.quote(stated.span);
            report
                .at(
                    stated.span,
                    format!("FileName is {wrong}, but the file is {}", quoted(actual)),
                )
                .help(format!("write `FileName={actual}`, or rename the file"))
                .fix(actual.is_ascii().then(|| Fix::replace(stated.span, actual)));
        }
    }
}

fn without_folders(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

fn is_description(name: &str) -> bool {
    extension(name).is_some_and(|extension| extension == "eds" || extension == "dcf")
}

fn is_same(stated: &str, actual: &str) -> bool {
    let of_its_eds = extension(actual).as_deref() == Some("dcf") && extension(stated).as_deref() == Some("eds");
    stated.eq_ignore_ascii_case(actual) || of_its_eds
}

fn extension(name: &str) -> Option<String> {
    Some(name.rsplit_once('.')?.1.to_ascii_lowercase())
}
