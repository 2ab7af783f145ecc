use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds devices that have only one of guard time (100Ch) and life time factor (100Dh), and devices with NG_Slave=1 that have neither.
    ///
    /// ## Why it matters
    /// The life time is the product of the two: with one of them alone a master cannot set up guarding.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x100C
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x100C
    /// 2=0x100D
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 100Ch and 100Dh; CiA 306-1, NG_Slave
    pub(crate) HalfNodeGuarding { code: "COM018", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for HalfNodeGuarding {
    fn check(reading: &Reading, report: &mut Report) {
        let dictionary = &reading.dictionary;
        let half = match (dictionary.object(0x100C), dictionary.object(0x100D)) {
            (Some(guard_time), None) => Some((guard_time, 0x100D)),
            (None, Some(life_time)) => Some((life_time, 0x100C)),
            (Some(_), Some(_)) => return,
            (None, None) => None,
        };
        if let Some((there, missing)) = half {
            report
                .at(
                    there.span,
                    format!("{:04X}h is here, but {missing:04X}h is missing", there.index),
                )
                .help(format!("describe object {missing:04X}h"));
            return;
        }
        let device = reading.eds.device_info.as_ref();
        let guarded = device
            .and_then(|device| device.ng_slave)
            .filter(|guarded| guarded.value);
        if let Some(guarded) = guarded {
            report
                .at(guarded.span, "NG_Slave is 1, but 100Ch and 100Dh are missing")
                .help("describe both objects, or write `NG_Slave=0`");
        }
    }
}
