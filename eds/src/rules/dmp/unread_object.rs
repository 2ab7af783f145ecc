use super::answers::named;
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{Dictionary, Entry, Object},
    rules::{DumpRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds objects that the file declares readable and the dump does not hold, neither with a value nor with an abort code.
    /// Those that a scan shall not read (ObjFlags bit 1) may be missing.
    ///
    /// ## Why it matters
    /// Nothing is known of them: the dump was broken off, or taken with another file. Without this finding, an empty dump would
    /// pass for a good device.
    ///
    /// ## Example
    /// A dump without `"1018sub4"`, although the file has a section `[1018sub4]`.
    ///
    /// ## Reference
    /// CiA's conformance test OD01
    pub(crate) UnreadObject { code: "DMP012", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for UnreadObject {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        if dump.objects.is_empty() {
            report.at(Span::default(), "the dump holds no objects").help(CURE);
            return;
        }
        for object in &dictionary.objects {
            report_unread(object, dump, report);
        }
    }
}

const CURE: &str = "take the dump again, to its end";

/// One finding for an object of which nothing is known, else one for each sub-index.
fn report_unread(object: &Object, dump: &Dump, report: &mut Report) {
    let unread: Vec<&Entry> = object.entries.iter().filter(|entry| is_unread(entry, dump)).collect();
    if unread.len() == object.entries.len() && unread.len() > 1 {
        let message = format!("the dump holds nothing of object {:04X}h", object.index);
        report.at(object.span, message).help(CURE);
        return;
    }
    for entry in unread {
        let name = named(object, entry.address);
        report
            .at(entry.spans.section, format!("the dump does not hold {name}"))
            .help(CURE);
    }
}

fn is_unread(entry: &Entry, dump: &Dump) -> bool {
    entry.access.readable() && !entry.refuse_read_on_scan && dump.answer(entry.address).is_none()
}
