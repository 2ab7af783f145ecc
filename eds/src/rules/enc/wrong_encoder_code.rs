use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects of CiA 406 that are single values where the profile has an array, or the other way round.
    ///
    /// ## Why it matters
    /// A master reads the value at another sub-index than the one where it is, and gets an abort.
    ///
    /// An array in place of a record, or a record in place of an array, is all the same to it. 650Bh is a single value in V2.0 and
    /// an array on an encoder of V3.2: either is right.
    ///
    /// ## Example
    /// ```ini
    /// [6030]
    /// ParameterName=Speed value
    /// ObjectType=0x7
    /// DataType=0x0003
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6030]
    /// ParameterName=Speed value
    /// ObjectType=0x8
    /// SubNumber=2
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, chapter 8, Object Code; CANchkEDS V30, V33
    pub(crate) WrongEncoderCode { code: "ENC004", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for WrongEncoderCode {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        for (object, standard) in encoder.objects() {
            if !standard.may_be(object.code) {
                let (code, shape) = (object.code.name(), standard.shape());
                report
                    .at(
                        object.span,
                        format!("{:04X}h is a {code}; by CiA 406 it is {shape}", object.index),
                    )
                    .help(format!("describe it as {shape}"));
            }
        }
    }
}
