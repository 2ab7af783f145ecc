use super::{Encoder, standard::standard};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects from 6000h to 65FFh that CiA 406 does not define, as far as we know its versions: V2.0 in full, of V3.0 to V3.2 the
    /// additions that their histories and two encoders name.
    ///
    /// ## Why it matters
    /// The range is the profile's: what a device puts there by itself may mean something else in the next version. A device's own objects
    /// are at 2000h to 5FFFh. As V4.x may have more objects it is a note.
    ///
    /// ## Example
    /// ```ini
    /// [6100]
    /// ParameterName=Temperature
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100]
    /// ParameterName=Temperature
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8 and 8.5
    pub(crate) UnknownEncoderObject { code: "ENC021", level: Level::Note, since: "0.1.0" }
}

impl EncoderRule for UnknownEncoderObject {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let objects = encoder.dictionary.objects.iter();
        let of_profile = objects.filter(|object| (0x6000..=0x65FF).contains(&object.index));
        for object in of_profile.filter(|object| standard(object.index).is_none()) {
            report
                .at(object.span, format!("{:04X}h is no object of CiA 406", object.index))
                .help("move it to 2000h to 5FFFh, where a device's own objects are");
        }
    }
}
