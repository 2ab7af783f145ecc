use super::mapped::kind;
use crate::{
    diagnostic::Level,
    ir::{AccessType, Dictionary, Direction, Entry},
    rules::{DictionaryRule, Report, declare_rule, more},
};

declare_rule! {
    /// ## What it does
    /// Finds devices without any TPDO whose objects can be mapped only into one, and devices without any RPDO likewise. One finding for
    /// each direction, at the first such object.
    ///
    /// ## Why it matters
    /// PDOMapping=1 promises that the value can be had in a PDO, and there is none for it.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// NrOfTXPDO=0
    ///
    /// [6000sub1]
    /// AccessType=ro
    /// PDOMapping=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6000sub1]
    /// AccessType=ro
    /// PDOMapping=0
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, PDOMapping; CANchkEDS V61
    pub(crate) PointlessMappability { code: "PDO024", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for PointlessMappability {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for direction in [Direction::Receive, Direction::Transmit] {
            if dictionary.pdos(direction).next().is_some() {
                continue;
            }
            let fits = |entry: &&Entry| entry.pdo_mapping && only_way(entry) == Some(direction);
            let mut mappable = dictionary.entries().filter(fits);
            if let Some(first) = mappable.next() {
                let (address, kind, more) = (first.address, kind(direction), more(mappable.count()));
                report
                    .at(
                        first.spans.pdo_mapping,
                        format!("{address} may be mapped, but the device has no {kind}{more}"),
                    )
                    .help(format!("write `PDOMapping=0`, or describe a {kind}"));
            }
        }
    }
}

/// The direction in which alone the value can be mapped. An error register is mappable in each device (CiA 301, 1001h).
const fn only_way(entry: &Entry) -> Option<Direction> {
    match entry.access {
        _ if entry.address.index < 0x2000 => None,
        AccessType::Ro | AccessType::Const | AccessType::Rwr => Some(Direction::Transmit),
        AccessType::Wo | AccessType::Rww => Some(Direction::Receive),
        AccessType::Rw => None,
    }
}
