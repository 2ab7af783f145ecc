use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a NetNumber in `[DeviceComissioning]` above 127.
    ///
    /// ## Why it matters
    /// Networks are numbered from 1 to 127, and 0 stands for the device's own: a request through a gateway finds no other.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// NetNumber=256
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// NetNumber=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.3; CiA 302-7, network numbers; CiA 309-1
    pub(crate) ImpossibleNetNumber { code: "DCF008", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for ImpossibleNetNumber {
    fn check(eds: &Eds, report: &mut Report) {
        let number = eds.commissioning.as_ref().and_then(|section| section.net_number);
        if let Some(number) = number.filter(|number| number.value > 127) {
            let value = report.quote(number.span);
            report
                .at(number.span, format!("NetNumber is {value}; networks have 1 to 127"))
                .help("give the network's number, or 0");
        }
    }
}
