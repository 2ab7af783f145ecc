use crate::{
    diagnostic::Level,
    dump::{AbortCode, Answer, Dump},
    ir::{Address, Dictionary},
    rules::{DumpRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds objects and sub-indices that the device answers for but the file does not have.
    ///
    /// ## Why it matters
    /// The file is not of this device or not of this version of its firmware; a tool that reads only the file never sees
    /// the object.
    ///
    /// ## Example
    /// ```json
    /// "2100sub0": "01 00"
    /// ```
    /// although the file has no section `[2100]`. The data types below 1000h and sub-index FFh, which tells an object's
    /// structure, need no section.
    ///
    /// ## Reference
    /// CiA 306-1, object lists: an EDS describes all objects of a device
    pub(crate) UndeclaredObject { code: "DMP002", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for UndeclaredObject {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        let mut reported = None;
        for address in undeclared(dictionary, dump) {
            let object = dictionary.object(address.index);
            let message = match object {
                Some(_) => format!("the device has {address}, the file has not"),
                None if reported == Some(address.index) => continue,
                None => format!("the device has an object {:04X}h, the file has not", address.index),
            };
            let span = object.map_or(Span::default(), |object| object.span);
            report
                .at(span, message)
                .help("describe it in the file, or take the file of this firmware");
            reported = Some(address.index);
        }
    }
}

fn undeclared<'a>(dictionary: &'a Dictionary, dump: &'a Dump) -> impl Iterator<Item = Address> + 'a {
    let found = dump.objects.iter().filter(|(_, answer)| is_presence(answer));
    let addresses = found.map(|(address, _)| *address);
    let described = addresses.filter(|address| address.index >= 0x1000 && address.sub != 0xFF);
    described.filter(|address| dictionary.entry(*address).is_none())
}

/// Whether the answer shows that there is something: a value, or a refusal that only something can give.
const fn is_presence(answer: &Answer) -> bool {
    matches!(answer, Answer::Value(_) | Answer::Abort(AbortCode::WRITE_ONLY))
}
