use super::lists::{is_open, is_plain, lists};
use crate::{
    diagnostic::Level,
    fix::{Change, Fix},
    ir::ObjectList,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects in a list that their index does not belong to: 2000h to 5FFFh belong in `[ManufacturerObjects]`, 1000h,
    /// 1001h and 1018h in `[MandatoryObjects]`, all others in `[OptionalObjects]` or, where a profile demands them, in
    /// `[MandatoryObjects]`.
    ///
    /// ## Why it matters
    /// Tools read from the list whether the standard or the vendor defines an object, and treat it accordingly.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1017
    /// 2=0x2000
    ///
    /// [ManufacturerObjects]
    /// SupportedObjects=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1017
    ///
    /// [ManufacturerObjects]
    /// SupportedObjects=1
    /// 1=0x2000
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object lists; CANchkEDS V28
    pub(crate) MisfiledObject { code: "EDS008", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for MisfiledObject {
    fn check(eds: &Eds, report: &mut Report) {
        for (name, list) in lists(eds) {
            for listed in list.values() {
                let index = listed.value;
                let home = ObjectList::of(index);
                // A profile may make any of its objects mandatory.
                let fits = name == home || (name == ObjectList::Mandatory && home == ObjectList::Optional);
                if !fits {
                    let (wrong, right) = (name.section(), home.section());
                    report
                        .at(listed.span, format!("object {index:04X}h does not belong in [{wrong}]"))
                        .help(format!("move it to [{right}]"))
                        .fix((is_plain(list) && is_open(eds, home)).then(|| {
                            let enlist = Change::Enlist { list: home, index };
                            Fix::new(Change::Strike { at: listed.span }).and(enlist)
                        }));
                }
            }
        }
    }
}
