use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects in `[xxxxObjectLinks]` that the file does not describe.
    ///
    /// ## Why it matters
    /// Links tell a tool which objects belong together, so that it shows them on one page. It looks for one that is not there.
    ///
    /// ## Example
    /// ```ini
    /// [6000ObjectLinks]
    /// ObjectLinks=1
    /// 1=0x6002
    ///
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x6000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x6000
    /// 2=0x6002
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object links; CANchkEDS V13. Of links of an object that is not there it is EDS016.
    pub(crate) AbsentLinkedObject { code: "EDS031", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for AbsentLinkedObject {
    fn check(reading: &Reading, report: &mut Report) {
        for object in &reading.eds.objects {
            let links = object.links.iter().flat_map(|links| links.values());
            for link in links.filter(|link| reading.dictionary.object(link.value).is_none()) {
                let (index, linked) = (object.index, link.value);
                report
                    .at(
                        link.span,
                        format!("{index:04X}h is linked to {linked:04X}h, which the file does not have"),
                    )
                    .help(format!("describe {linked:04X}h, or remove the link"));
            }
        }
    }
}
