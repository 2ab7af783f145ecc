use super::Encoder;
use crate::{
    diagnostic::Level,
    ir::{Direction, Pdo},
    rules::{EncoderRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds encoders none of whose TPDOs carries a position after power-on: 6004h, 6008h, 600Ch or 6020h.
    ///
    /// ## Why it matters
    /// By the profile the first two TPDOs carry it, one on change or in a cycle, one on SYNC. A master that knows the profile starts the
    /// encoder and waits for its position.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// ParameterName=Mapped object 1
    /// DefaultValue=0x65030010
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub1]
    /// ParameterName=Mapped object 1
    /// DefaultValue=0x60040020
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 7.1 and 7.2
    pub(crate) UnmappedPosition { code: "ENC018", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for UnmappedPosition {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let mut pdos = encoder.dictionary.pdos(Direction::Transmit);
        let carries = |pdo: &Pdo<'_>| pdo.mapped().any(|object| POSITIONS.contains(&object.address.index));
        if pdos.any(|pdo| carries(&pdo)) {
            return;
        }
        let first = encoder.dictionary.object(0x1A00);
        let place = first.map_or(Span::default(), |mapping| mapping.span);
        report
            .at(place, "no TPDO carries the position after power-on")
            .help("map the position into TPDO 1: DefaultValue=0x60040020, of several sensors 0x60200120");
    }
}

const POSITIONS: [u16; 4] = [0x6004, 0x6008, 0x600C, 0x6020];
