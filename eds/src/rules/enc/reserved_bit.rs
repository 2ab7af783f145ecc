use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values of 6000h, 6500h and 6503h to 6506h after power-on with bits that CiA 406 reserves: bits 4 to 11 of parameters and
    /// status, 2 to 11 of alarms, 6 to 11 of warnings. Bits 12 to 15 are the manufacturer's.
    ///
    /// ## Why it matters
    /// A master of a later version takes the bit for what that version makes of it.
    ///
    /// Bit 3 of 6000h and 6500h is reserved in V2.0 and the measuring direction from V3.1 on; it is left alone.
    ///
    /// ## Example
    /// ```ini
    /// [6000]
    /// ParameterName=Operating parameters
    /// DefaultValue=0x0014
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6000]
    /// ParameterName=Operating parameters
    /// DefaultValue=0x1004
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.1.1, 8.4.1 and 8.4.4 to 8.4.7; V3.1, history
    pub(crate) ReservedBit { code: "ENC008", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for ReservedBit {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        for (index, reserved) in RESERVED {
            let Some(number) = encoder.number(index) else { continue };
            if let Some(bit) = (0..16).find(|bit| number.value & reserved & 1 << bit != 0) {
                let value = report.quote(number.span);
                report
                    .at(
                        number.span,
                        format!("{index:04X}h is {value}; its bit {bit} is reserved"),
                    )
                    .help("clear it; bits 12 to 15 are for functions of your own");
            }
        }
    }
}

/// The bits without meaning.
const RESERVED: [(u16, i128); 6] = [
    (0x6000, 0x0FF0),
    (0x6500, 0x0FF0),
    (0x6503, 0x0FFC),
    (0x6504, 0x0FFC),
    (0x6505, 0x0FC0),
    (0x6506, 0x0FC0),
];
