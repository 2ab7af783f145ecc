use super::Encoder;
use crate::{
    diagnostic::Level,
    ir::{Object, ObjectCode},
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects of one function with different numbers of channels: of the cams (6300h to 6337h), of the work areas (6400h to 6402h),
    /// and of several sensors (presets 6010h and offsets 650Ch as many as positions 6020h; speeds 6030h, accelerations 6040h and jerks
    /// 6050h not more).
    ///
    /// ## Why it matters
    /// The channels belong together by their sub-index: one of them has a state without limits, a position without preset, or a speed of
    /// no sensor.
    ///
    /// ## Example
    /// ```ini
    /// [6010]
    /// ParameterName=Preset values for multi-sensor devices
    /// SubNumber=3
    ///
    /// [6020]
    /// ParameterName=Position values for multi-sensor devices
    /// SubNumber=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6010]
    /// ParameterName=Preset values for multi-sensor devices
    /// SubNumber=2
    ///
    /// [6020]
    /// ParameterName=Position values for multi-sensor devices
    /// SubNumber=2
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.1.7 to 8.1.9, 8.2 and 8.3
    pub(crate) UnequalChannels { code: "ENC012", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for UnequalChannels {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let cams = (0x6301..0x6340).collect::<Vec<u16>>();
        for (main, others, fewer_are_right) in [
            (0x6300, cams.as_slice(), false),
            (0x6400, &[0x6401, 0x6402], false),
            (0x6020, &[0x6010, 0x650C], false),
            (0x6020, &[0x6030, 0x6040, 0x6050], true),
        ] {
            let Some(main) = channels(encoder, main) else { continue };
            let others = others.iter().filter_map(|index| channels(encoder, *index));
            for other in others.filter(|other| other.number > main.number || !fewer_are_right) {
                if other.number != main.number {
                    report_difference(&other, &main, report);
                }
            }
        }
    }
}

struct Channels<'a> {
    object: &'a Object,
    number: u8,
}

/// How many values the array at `index` has beside the count.
fn channels<'a>(encoder: &Encoder<'a>, index: u16) -> Option<Channels<'a>> {
    let object = encoder.dictionary.object(index)?;
    let several = matches!(object.code, ObjectCode::Array | ObjectCode::Record);
    let number = object.entries.last().map_or(0, |entry| entry.address.sub);
    several.then_some(Channels { object, number })
}

fn report_difference(one: &Channels<'_>, main: &Channels<'_>, report: &mut Report) {
    let plural = if one.number == 1 { "" } else { "s" };
    report
        .at(
            one.object.span,
            format!(
                "{:04X}h has {} channel{plural}, {:04X}h has {}",
                one.object.index, one.number, main.object.index, main.number
            ),
        )
        .related(main.object.span, "the other one")
        .help("describe as many channels here as there");
}
