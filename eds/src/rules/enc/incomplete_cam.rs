use super::{Encoder, standard::standard};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds encoders with a part of what cams need: the registers 6300h state, 6301h enable and 6302h polarity, and of each cam n, 1 to 8,
    /// a low limit (6310h and on), a high limit (6320h and on) and a hysteresis (6330h and on).
    ///
    /// ## Why it matters
    /// A cam without limits cannot be placed, one without enable bit is never switched on: its state is always 0.
    ///
    /// CiA 406 has each of them optional, but describes a cam by all of them.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// 1=0x6300
    /// 2=0x6301
    /// 3=0x6310
    /// 4=0x6320
    /// 5=0x6330
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// 1=0x6300
    /// 2=0x6301
    /// 3=0x6302
    /// 4=0x6310
    /// 5=0x6320
    /// 6=0x6330
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.2
    pub(crate) IncompleteCam { code: "ENC010", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for IncompleteCam {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let cams: Vec<[u16; 3]> = (0..8).map(|cam| [0x6310 + cam, 0x6320 + cam, 0x6330 + cam]).collect();
        let begun = |set: &[u16]| set.iter().any(|index| encoder.has(*index));
        let (any_cam, any_register) = (cams.iter().any(|cam| begun(cam)), begun(&REGISTERS));
        if any_cam || any_register {
            report_missing(encoder, &REGISTERS, report);
        }
        for (number, cam) in cams.iter().enumerate() {
            // Registers alone are those of a first cam.
            if begun(cam) || (any_register && !any_cam && number == 0) {
                report_missing(encoder, cam, report);
            }
        }
    }
}

const REGISTERS: [u16; 3] = [0x6300, 0x6301, 0x6302];

fn report_missing(encoder: &Encoder<'_>, set: &[u16], report: &mut Report) {
    let cam_objects = encoder.objects().map(|(object, _)| object);
    let mut cam_objects = cam_objects.filter(|object| (0x6300..0x6340).contains(&object.index));
    let near = encoder
        .dictionary
        .objects
        .iter()
        .find(|object| set.contains(&object.index));
    let Some(witness) = near.or_else(|| cam_objects.next()) else {
        return;
    };
    for index in set.iter().filter(|index| !encoder.has(**index)) {
        let name = standard(*index).map_or("", |standard| standard.name).to_lowercase();
        report
            .at(
                witness.span,
                format!("{:04X}h is there, but {index:04X}h, {name}, is not", witness.index),
            )
            .help(format!("describe {index:04X}h, and add it to [OptionalObjects]"));
    }
}
