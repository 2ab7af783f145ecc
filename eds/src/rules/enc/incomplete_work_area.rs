use super::{Encoder, standard::standard};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds encoders with some of the three objects of work areas: 6400h state, 6401h low limit, 6402h high limit.
    ///
    /// ## Why it matters
    /// Limits without state tell nobody; a state without limits never changes, or changes at a place that nobody knows.
    ///
    /// CiA 406 has each of them optional, but describes a work area by all of them.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// 1=0x6400
    /// 2=0x6402
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// 1=0x6400
    /// 2=0x6401
    /// 3=0x6402
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.3
    pub(crate) IncompleteWorkArea { code: "ENC011", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for IncompleteWorkArea {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let area = 0x6400..=0x6402;
        let mut objects = encoder.dictionary.objects.iter();
        let Some(witness) = objects.find(|object| area.contains(&object.index)) else {
            return;
        };
        for index in area.filter(|index| !encoder.has(*index)) {
            let name = standard(index).map_or("", |standard| standard.name).to_lowercase();
            report
                .at(
                    witness.span,
                    format!("{:04X}h is there, but {index:04X}h, {name}, is not", witness.index),
                )
                .help(format!("describe {index:04X}h, and add it to [OptionalObjects]"));
        }
    }
}
