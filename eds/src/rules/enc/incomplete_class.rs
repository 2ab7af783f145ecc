use super::{
    Encoder,
    missing_encoder_object::missing,
    standard::{Class, standards},
};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds encoders of class C2 without an object that this class demands. An encoder is of class C2 when 650Eh says C2 or C3; of
    /// one without 650Eh, which CiA 406 V2.0 does not have, when it has more than half of the class's objects.
    ///
    /// ## Why it matters
    /// A master that knows the class takes scaling, preset and diagnostics for granted.
    ///
    /// CiA 406 V2.0 demands 6001h of linear encoders, too; as they do not turn, they are let off. Its overview demands 6030h of
    /// all encoders, its text of those with several sensors only; the text is taken.
    ///
    /// ## Example
    /// ```ini
    /// [650E]
    /// ParameterName=Device functionality
    /// DefaultValue=0x00000002
    ///
    /// [OptionalObjects]
    /// SupportedObjects=4
    /// 1=0x6004
    /// 2=0x6501
    /// 3=0x6502
    /// 4=0x650E
    /// ```
    ///
    /// Use instead, if the device has no more:
    /// ```ini
    /// [650E]
    /// ParameterName=Device functionality
    /// DefaultValue=0x00000001
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 5.2 and 8, column C2; CANchkEDS V9
    pub(crate) IncompleteClass { code: "ENC003", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for IncompleteClass {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let missing = missing(encoder, Class::C2);
        let stated = encoder.class();
        let (extended, class) = match stated {
            Some(class) => (class == Class::C2, "class C2 demands it"),
            None => (
                has_most(encoder, missing.len()),
                "class C2, which the others are of, demands it",
            ),
        };
        let place = encoder
            .number(0x650E)
            .map_or(Span::default(), |functionality| functionality.span);
        for (index, name) in missing.into_iter().filter(|_| extended) {
            report
                .at(place, format!("object {index:04X}h, {name}, is missing; {class}"))
                .help(format!("describe {index:04X}h, and add it to [OptionalObjects]"));
        }
    }
}

/// Whether it has most of the objects of class C2 when so many are missing.
fn has_most(encoder: &Encoder<'_>, missing: usize) -> bool {
    let kind = encoder.kind();
    let demanded = standards().iter();
    let demanded = demanded.filter(|object| object.demanded_of(kind) == Some(Class::C2));
    missing * 2 < demanded.count()
}
