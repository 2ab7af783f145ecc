use super::standard::standard;
use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds communication objects whose ObjectType is not the one that CiA 301, CiA 302 or EN 50325-5 gives them. An array described as a record, and the
    /// other way round, is left alone: a client does not see the difference.
    ///
    /// ## Why it matters
    /// A master that looks for sub-indices by the standard finds none, or takes the only value for their number.
    ///
    /// ## Example
    /// ```ini
    /// [1016]
    /// ParameterName=Consumer heartbeat time
    /// ObjectType=0x7
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1016]
    /// ParameterName=Consumer heartbeat time
    /// ObjectType=0x8
    /// SubNumber=2
    /// ```
    ///
    /// ## Reference
    /// CiA 301 and CiA 302, objects 1000h to 1FFFh; CANchkEDS V33
    pub(crate) WrongStandardCode { code: "COM005", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for WrongStandardCode {
    fn check(reading: &Reading, report: &mut Report) {
        for object in &reading.dictionary.objects {
            let Some(standard) = standard(object.index).filter(|standard| !standard.is_like(object.code)) else {
                continue;
            };
            let description = reading
                .eds
                .object(object.index)
                .and_then(|object| object.description.as_ref());
            let stated = description.and_then(|description| description.object_type);
            let at = stated.map_or(object.span, |code| code.span);
            let (index, found, expected, number) = (
                object.index,
                object.code.name(),
                standard.code.name(),
                standard.code.number(),
            );
            let (name, document) = (standard.name, standard.document);
            report
                .at(
                    at,
                    format!("{index:04X}h, {name}, has ObjectType {found}; {document} gives it {expected}"),
                )
                .help(format!("describe it with `ObjectType=0x{number:X}`"));
        }
    }
}
