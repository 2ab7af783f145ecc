use super::Encoder;
use crate::{
    diagnostic::Level,
    ir::DataType,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values of CiA 406 with another data type than the profile gives them.
    ///
    /// ## Why it matters
    /// A master that knows the profile sends and expects values of the profile's length; the device answers with abort 0607 0010h,
    /// or a position beyond the type's middle becomes negative.
    ///
    /// Where the versions differ each of them is right: the values of 6010h are UNSIGNED32 in V2.0 and INTEGER32 from V3.1 on, those
    /// of 6330h to 6337h are UNSIGNED16 in V2.0 and UNSIGNED32 on an encoder of V3.2.
    ///
    /// ## Example
    /// ```ini
    /// [6004]
    /// ParameterName=Position value
    /// DataType=0x0004
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6004]
    /// ParameterName=Position value
    /// DataType=0x0007
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, chapter 8, Data Type and Value Range; V3.1, history; CANchkEDS V30
    pub(crate) WrongEncoderType { code: "ENC005", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for WrongEncoderType {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        for value in encoder.values(|spans| spans.data_type) {
            let (found, types) = (value.entry.data_type, value.standard.types);
            // A type that cannot be read is lowered to DOMAIN, and was reported.
            let Some(usual) = types
                .first()
                .filter(|_| found != DataType::Domain && !types.contains(&found))
            else {
                continue;
            };
            let right: Vec<&str> = types.iter().copied().map(DataType::name).collect();
            let (name, found, right) = (value.named(), found.name(), right.join(" or "));
            report
                .at(value.at, format!("{name} is {found}; CiA 406 gives it {right}"))
                .help(format!("write `DataType=0x{:04X}`", usual.index()));
        }
    }
}
