use super::standard::{Access, field, standard};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds communication objects that a client cannot read, or cannot write, though the standard demands it: a COB-ID with access type
    /// wo, a heartbeat time with ro. An object that the device may fix is left alone. One finding for an object.
    ///
    /// ## Why it matters
    /// A master configures the device by the standard, and its write ends in abort code 0601 0002h; or it reads back what it wrote, and
    /// gets 0601 0001h.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// AccessType=ro
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 301 and CiA 302, objects 1000h to 1FFFh; CANchkEDS V30. Of what may never be written it is COM006.
    pub(crate) WrongStandardAccess { code: "COM010", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongStandardAccess {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for object in &dictionary.objects {
            let wrong = object.entries.iter().find_map(|entry| Some((entry, demanded(entry)?)));
            if let Some((entry, demanded)) = wrong {
                let (address, access) = (entry.address, entry.access.name());
                let name = standard(object.index).map_or("the object", |standard| standard.name);
                let verb = if entry.access.readable() { "written" } else { "read" };
                report
                    .at(
                        entry.spans.access,
                        format!("{address} of {name} is {access}, so that it cannot be {verb}"),
                    )
                    .help(format!("write `{}`", demanded.name()));
            }
        }
    }
}

/// The access that the standard demands, where it is more.
fn demanded(entry: &Entry) -> Option<Access> {
    let access = field(entry.address)?.access;
    let too_much = access == Access::Read && entry.access.readable();
    (!too_much && !access.allows(entry.access)).then_some(access)
}
