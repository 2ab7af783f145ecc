use super::{
    answers::{Answered, answered},
    difference::is_default,
};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{Address, DataType, Dictionary, Direction},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDO mappings in force on the device that its file does not allow: of an object that is not there, may not be mapped
    /// or not in this direction, or with another number of bits than its data type. A mapping that is the file's own default is
    /// left to `lexican check`.
    ///
    /// ## Why it matters
    /// A master that takes the PDO apart by the file finds no such object, or reads the wrong bits of every object behind it.
    ///
    /// ## Example
    /// ```json
    /// "1A00sub0": "01",
    /// "1A00sub1": "10 00 04 60"
    /// ```
    /// maps 16 bits of 6004h, an UNSIGNED32.
    ///
    /// ## Reference
    /// CiA 301, objects 1600h and 1A00h; CiA's conformance test PDO21 and PDO27
    pub(crate) ImpossibleMapping { code: "DMP020", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for ImpossibleMapping {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump) {
            if let Some((Mapped { address, bits }, reason)) = impossible(dictionary, dump, &answer) {
                let name = answer.named();
                report
                    .at(
                        answer.entry.spans.section,
                        format!("{name} maps {bits} bits of {address}; {reason}"),
                    )
                    .help("change the mapping, or take the file of this firmware");
            }
        }
    }
}

/// What is mapped here, and why the file does not allow it.
pub(super) fn impossible(dictionary: &Dictionary, dump: &Dump, answer: &Answered<'_>) -> Option<(Mapped, String)> {
    let direction = direction(answer.object.index).filter(|_| is_in_force(answer, dump))?;
    let mapped = mapped(answer.bytes).filter(|_| !is_default(answer, dump.node_id))?;
    Some((mapped, impossibility(dictionary, direction, mapped)?))
}

/// What a mapping entry holds.
#[derive(Clone, Copy)]
pub(super) struct Mapped {
    address: Address,
    bits: u8,
}

const fn direction(index: u16) -> Option<Direction> {
    match index {
        0x1600..=0x17FF => Some(Direction::Receive),
        0x1A00..=0x1BFF => Some(Direction::Transmit),
        _ => None,
    }
}

/// Whether sub-index 0 on the device counts the mapping entry among those in use; 254 and 255 mark other uses of the record.
fn is_in_force(answer: &Answered<'_>, dump: &Dump) -> bool {
    let number = dump.value(Address::new(answer.object.index, 0));
    let number = number.and_then(<[u8]>::first).copied().filter(|number| *number <= 64);
    (1..=number.unwrap_or(0)).contains(&answer.entry.address.sub)
}

/// Length, sub-index and index, as they go over the bus.
fn mapped(bytes: &[u8]) -> Option<Mapped> {
    let &[bits, sub, low, high] = bytes else {
        return None;
    };
    let address = Address::new(u16::from_le_bytes([low, high]), sub);
    Some(Mapped { address, bits })
}

/// Why the file does not allow it.
fn impossibility(dictionary: &Dictionary, direction: Direction, mapped: Mapped) -> Option<String> {
    let dummy = DataType::from_index(mapped.address.index).filter(|_| mapped.address.sub == 0);
    if let Some(data_type) = dummy {
        let allowed = direction == Direction::Receive && dictionary.dummies.contains(&data_type);
        return (!allowed).then(|| format!("the file allows no dummy {} here", data_type.name()));
    }
    let Some(entry) = dictionary.entry(mapped.address) else {
        return Some("the file has no such object".into());
    };
    let flows = match direction {
        Direction::Receive => entry.access.writable(),
        Direction::Transmit => entry.access.readable(),
    };
    if !entry.pdo_mapping || !flows {
        let (access, flag) = (entry.access.name(), u8::from(entry.pdo_mapping));
        return Some(format!("the file says {access} and PDOMapping={flag}"));
    }
    // A BOOLEAN takes one bit, or a whole byte where the device's granularity is 8.
    let bits = entry
        .data_type
        .bits()
        .filter(|bits| *bits > 1 && *bits != mapped.bits)?;
    Some(format!("{} has {bits}", entry.data_type.name()))
}
