use super::bit_rates::BIT_RATES;
use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a Baudrate in `[DeviceComissioning]` that the device, by `BaudRate_…` in `[DeviceInfo]`, does not know.
    ///
    /// ## Why it matters
    /// The node does not answer, or disturbs the network. A file that has no `BaudRate_…` at all says nothing and is left alone.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// BaudRate_500=1
    /// BaudRate_1000=0
    ///
    /// [DeviceComissioning]
    /// NodeID=5
    /// Baudrate=1000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// Baudrate=500
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 4.4.2 and 5.3
    pub(crate) UnsupportedBitRate { code: "DCF007", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for UnsupportedBitRate {
    fn check(eds: &Eds, report: &mut Report) {
        let rate = eds.commissioning.as_ref().and_then(|section| section.baud_rate);
        let info = eds.device_info.as_ref().filter(|info| !info.baud_rates.is_empty());
        let (Some(rate), Some(info)) = (rate, info) else { return };
        let known = |supported: bool| {
            let mut rates = info.baud_rates.iter();
            rates.find(|known| known.rate == rate.value && known.supported.value == supported)
        };
        // What no device knows is DCF006.
        if known(true).is_some() || !BIT_RATES.contains(&rate.value) {
            return;
        }
        let (place, label) = match known(false) {
            Some(denied) => (denied.key, "not this one"),
            None => (info.header, "others are named here"),
        };
        report
            .at(
                rate.span,
                format!("Baudrate is {}, which the device does not know", rate.value),
            )
            .related(place, label)
            .help(format!(
                "choose one that it knows, or write `BaudRate_{}=1` in [DeviceInfo]",
                rate.value
            ));
    }
}
