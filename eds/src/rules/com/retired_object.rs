use super::standard::standard;
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that CiA 301 has taken back: 100Bh node-ID, 100Eh COB-ID guarding, 100Fh number of SDOs.
    ///
    /// ## Why it matters
    /// Masters of today do not look there. The node-ID of a device is that under which it answers, the
    /// guarding COB-ID is fixed by the predefined connection set, and SDOs are counted by their objects.
    ///
    /// ## Example
    /// ```ini
    /// [100E]
    /// ParameterName=COB-ID guarding protocol
    /// DefaultValue=$NODEID+0x700
    /// ```
    ///
    /// Use instead: nothing; the COB-ID cannot be another one.
    ///
    /// ## Reference
    /// CiA 301 version 3, objects 100Bh, 100Eh and 100Fh. What 1004h says is DEV004.
    pub(crate) RetiredObject { code: "COM020", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for RetiredObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for index in [0x100B, 0x100E, 0x100F] {
            let retired = dictionary.object(index).zip(standard(index));
            if let Some((object, standard)) = retired {
                report
                    .at(
                        object.span,
                        format!("{index:04X}h, {}, is not in CiA 301 any more", standard.name),
                    )
                    .help("remove the object, unless a master of old needs it");
            }
        }
    }
}
