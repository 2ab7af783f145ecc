use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds devices that are neither SimpleBootUpMaster nor SimpleBootUpSlave, though the file has one of the two keywords.
    ///
    /// ## Why it matters
    /// Each device is started by a master or is one. A tool that sets up the network has no part to give this one.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// SimpleBootUpMaster=0
    /// SimpleBootUpSlave=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// SimpleBootUpMaster=0
    /// SimpleBootUpSlave=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, SimpleBootUpMaster and SimpleBootUpSlave; CiA 301, 7.3.2, NMT state machine
    pub(crate) MissingBootUpRole { code: "DEV015", level: Level::Note, since: "0.1.0" }
}

impl ReadingRule for MissingBootUpRole {
    fn check(reading: &Reading, report: &mut Report) {
        let Some(device) = &reading.eds.device_info else { return };
        let roles = [device.simple_boot_up_slave, device.simple_boot_up_master];
        let mut stated = roles.into_iter().flatten();
        let has_role = roles.into_iter().flatten().any(|role| role.value);
        if let Some(role) = stated.next().filter(|_| !has_role) {
            report
                .at(role.span, "the device is neither a boot-up slave nor a boot-up master")
                .help("write `SimpleBootUpSlave=1`");
        }
    }
}
