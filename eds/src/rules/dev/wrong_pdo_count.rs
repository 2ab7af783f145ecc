use crate::{
    Reading,
    diagnostic::Level,
    fix::Fix,
    ir::{Dictionary, Direction},
    rules::{ReadingRule, Report, declare_rule},
    span::Spanned,
};

declare_rule! {
    /// ## What it does
    /// Finds an NrOfRXPDO or NrOfTXPDO that is not the number of PDOs in the dictionary.
    ///
    /// ## Why it matters
    /// A master that reserves room by the number has no room for a PDO, or waits for one that is not there.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// NrOfTXPDO=4
    ///
    /// [1800]
    /// …
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// NrOfTXPDO=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, NrOfRXPDO and NrOfTXPDO; CANchkEDS V62
    pub(crate) WrongPdoCount { code: "DEV001", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ReadingRule for WrongPdoCount {
    fn check(reading: &Reading, report: &mut Report) {
        let Some(device) = &reading.eds.device_info else {
            return;
        };
        let dictionary = &reading.dictionary;
        check_count(dictionary, Direction::Receive, device.nr_of_rx_pdo, report);
        check_count(dictionary, Direction::Transmit, device.nr_of_tx_pdo, report);
    }
}

fn check_count(dictionary: &Dictionary, direction: Direction, stated: Option<Spanned<u16>>, report: &mut Report) {
    let (keyword, kind) = match direction {
        Direction::Receive => ("NrOfRXPDO", "RPDO"),
        Direction::Transmit => ("NrOfTXPDO", "TPDO"),
    };
    let number = dictionary.pdos(direction).count();
    let Some(stated) = stated.filter(|stated| usize::from(stated.value) != number) else {
        return;
    };
    let have = match number {
        0 => format!("no {kind}"),
        1 => format!("one {kind}"),
        number => format!("{number} {kind}s"),
    };
    // With CompactPDO the number makes PDOs.
    let bare = report.bare(stated.span);
    report
        .at(
            stated.span,
            format!("{keyword} is {}, but the file has {have}", stated.value),
        )
        .help(format!("write `{keyword}={number}`"))
        .fix((dictionary.device.compact_pdo == 0).then(|| Fix::replace(bare, number.to_string())));
}
