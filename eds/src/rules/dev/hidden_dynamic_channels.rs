use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a section `[DynamicChannels]` of a device with DynamicChannelsSupported=0, and a device that supports dynamic channels without
    /// the section.
    ///
    /// ## Why it matters
    /// The number says whether a tool looks for the section, the section where the objects go that a program creates. One without
    /// the other is of no use.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// DynamicChannelsSupported=0
    ///
    /// [DynamicChannels]
    /// NrOfSeg=1
    /// Type1=0x0005
    /// Dir1=ro
    /// Range1=0xA000-0xA03F
    /// PPOffset1=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// DynamicChannelsSupported=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[DynamicChannels]`; CiA 302-4; CANchkEDS W6
    pub(crate) HiddenDynamicChannels { code: "DEV009", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for HiddenDynamicChannels {
    fn check(reading: &Reading, report: &mut Report) {
        let device = reading.eds.device_info.as_ref();
        let stated = device.and_then(|device| device.dynamic_channels_supported);
        let supported = stated.filter(|supported| supported.value > 0);
        match (&reading.eds.dynamic_channels, supported) {
            (Some(channels), None) => {
                report
                    .at(
                        channels.header,
                        "[DynamicChannels] is here, but DynamicChannelsSupported is 0",
                    )
                    .help("write `DynamicChannelsSupported=1`, or remove the section");
            }
            (None, Some(supported)) => {
                let number = supported.value;
                report
                    .at(
                        supported.span,
                        format!("DynamicChannelsSupported is {number}, but there is no [DynamicChannels]"),
                    )
                    .help("write the section, or `DynamicChannelsSupported=0`");
            }
            _ => {}
        }
    }
}
