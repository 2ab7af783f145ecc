use super::{
    Encoder,
    standard::{Class, standards},
};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds encoders without an object of class C1, which every encoder has: 1010h store parameters, 6004h position value (of
    /// several sensors 6020h), 6501h single-turn resolution or measuring step, and 6502h number of revolutions if it is rotary.
    ///
    /// ## Why it matters
    /// A master reads the position, and what its steps are, where the profile has them.
    ///
    /// CiA 406 V2.0 demands 6502h of linear encoders, too; as they do not turn, they are let off.
    ///
    /// ## Example
    /// ```ini
    /// [1000]
    /// ParameterName=Device type
    /// DefaultValue=0x00080196
    ///
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x6004
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=3
    /// 1=0x1010
    /// 2=0x6004
    /// 3=0x6501
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 5.1, 7.3 and 8, column C1; CANchkEDS V9
    pub(crate) MissingEncoderObject { code: "ENC002", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for MissingEncoderObject {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        for (index, name) in missing(encoder, Class::C1) {
            report
                .at(
                    Span::default(),
                    format!("object {index:04X}h, {name}, is missing; every encoder has it"),
                )
                .help(format!("describe {index:04X}h, and add it to [OptionalObjects]"));
        }
    }
}

const STORE_PARAMETERS: u16 = 0x1010;

/// What the encoder would have to have of `class`, and has not.
pub(super) fn missing(encoder: &Encoder<'_>, class: Class) -> Vec<(u16, String)> {
    let stores = (class == Class::C1).then(|| (STORE_PARAMETERS, "store parameters".to_owned()));
    let kind = encoder.kind();
    let demanded = standards()
        .iter()
        .filter(|object| object.demanded_of(kind) == Some(class));
    let demanded = demanded.map(|object| (object.index(), object.name.to_lowercase()));
    let all = stores.into_iter().chain(demanded);
    all.filter(|(index, _)| !encoder.has(*index)).collect()
}
