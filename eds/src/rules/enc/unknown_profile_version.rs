use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds encoders whose 6507h names, in its low word, a version of CiA 406 that does not exist. There are 1.0, 2.0, 3.0, 3.1, 3.2 and
    /// 4.x.
    ///
    /// ## Why it matters
    /// A master chooses by it how it reads the other objects. Often the halves are exchanged: the profile's version is in the low word, the
    /// software's in the high one.
    ///
    /// The word is read as V2.0 has it, 3.2 as 0302h; 0320h is taken for 3.2 as well.
    ///
    /// ## Example
    /// ```ini
    /// [6507]
    /// ParameterName=Profile and software version
    /// DefaultValue=0x03020105
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6507]
    /// ParameterName=Profile and software version
    /// DefaultValue=0x01050302
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.4.8; V3.1, history
    pub(crate) UnknownProfileVersion { code: "ENC020", level: Level::Note, since: "0.1.0" }
}

impl EncoderRule for UnknownProfileVersion {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let Some(versions) = encoder.number(0x6507) else { return };
        let (version, revision) = (versions.value >> 8 & 0xFF, versions.value & 0xFF);
        let exists = match version {
            1 | 2 => revision == 0,
            3 => matches!(revision, 0x00..=0x02 | 0x10 | 0x20),
            4 => true,
            _ => false,
        };
        if !exists {
            report
                .at(
                    versions.span,
                    format!("6507h says version {version:X}.{revision:X} of CiA 406, which does not exist"),
                )
                .help(
                    "give the profile's version in the low word, 0x0302 for 3.2, and the software's in the high word",
                );
        }
    }
}
