use super::{Encoder, standard::Kind};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds rotary encoders that promise more than they measure: more units per revolution (6001h) than the single-turn resolution
    /// (6501h), or a greater measuring range (6002h) than units per revolution times the number of revolutions (6502h), after power-on.
    ///
    /// ## Why it matters
    /// The lower bits of the position say nothing, or the position ends before the range does.
    ///
    /// ## Example
    /// ```ini
    /// [6001]
    /// DefaultValue=65536
    ///
    /// [6501]
    /// DefaultValue=8192
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6001]
    /// DefaultValue=8192
    ///
    /// [6501]
    /// DefaultValue=8192
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.1.2, 8.1.3, 8.4.2 and 8.4.3
    pub(crate) ImpossibleResolution { code: "ENC014", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for ImpossibleResolution {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        if encoder.kind() != Kind::Rotary {
            return;
        }
        check_units(encoder, report);
        check_range(encoder, report);
    }
}

fn check_units(encoder: &Encoder<'_>, report: &mut Report) {
    let (Some(units), Some(resolution)) = (encoder.number(0x6001), encoder.number(0x6501)) else {
        return;
    };
    // What is 0 is ENC016.
    if units.value > resolution.value && resolution.value > 0 {
        let (finer, coarser) = (units.value, resolution.value);
        report
            .at(
                units.span,
                format!("6001h is {finer}, finer than 6501h, which is {coarser}"),
            )
            .related(resolution.span, "what the encoder measures")
            .help("give the units that the encoder has, or fix 6501h");
    }
}

fn check_range(encoder: &Encoder<'_>, report: &mut Report) {
    let units = encoder.number(0x6001).or_else(|| encoder.number(0x6501));
    let (Some(range), Some(units), Some(turns)) = (encoder.number(0x6002), units, encoder.number(0x6502)) else {
        return;
    };
    // What is 0 is ENC016.
    let most = units.value * turns.value;
    if range.value > most && most > 0 {
        report
            .at(
                range.span,
                format!(
                    "6002h is {}; {} revolutions of {} units are {most}",
                    range.value, turns.value, units.value
                ),
            )
            .related(turns.span, "the revolutions")
            .help(format!("give at most {most}"));
    }
}
