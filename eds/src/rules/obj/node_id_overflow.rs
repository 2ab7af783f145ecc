use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds formulas whose sum does not fit for each node-ID from 1 to 127: into the data type, or, of a COB-ID, into the 11 bits of a
    /// CAN-ID.
    ///
    /// ## Why it matters
    /// For the higher node-IDs the value wraps: the device sends under the CAN-ID of another node.
    ///
    /// ## Example
    /// ```ini
    /// [1014]
    /// ParameterName=COB-ID EMCY
    /// DefaultValue=$NODEID+0x7F0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1014]
    /// ParameterName=COB-ID EMCY
    /// DefaultValue=$NODEID+0x80
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `$NODEID`; CiA 301, 7.3.3
    pub(crate) NodeIdOverflow { code: "OBJ031", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for NodeIdOverflow {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries() {
            let Some(Value::NodeIdPlus(base)) = entry.default else {
                continue;
            };
            let bits = room(entry, base);
            let highest = (base & mask(bits)) + HIGHEST_NODE_ID;
            if highest > mask(bits) {
                let (address, at) = (entry.address, entry.spans.default);
                let value = report.quote(at);
                report
                    .at(
                        at,
                        format!("{value} of {address} does not fit into {bits} bits for node-ID 127"),
                    )
                    .help(format!(
                        "write $NODEID plus 0x{:X} or less",
                        mask(bits) - HIGHEST_NODE_ID
                    ));
            }
        }
    }
}

const HIGHEST_NODE_ID: u64 = 127;
/// The CAN-ID has 29 bits: bit 29 of the COB-ID.
const EXTENDED: u64 = 1 << 29;

/// As many bits as the sum may have.
fn room(entry: &Entry, base: u64) -> u32 {
    let is_cob_id = matches!(
        (entry.address.index, entry.address.sub),
        (0x1005 | 0x1012 | 0x1014, 0) | (0x1200..=0x12FF, 1 | 2) | (0x1400..=0x15FF | 0x1800..=0x19FF, 1)
    );
    let bits = entry.data_type.bits().map_or(64, u32::from);
    match is_cob_id {
        true if base & EXTENDED == 0 => bits.min(11),
        true => bits.min(29),
        false if entry.data_type.is_signed() => bits - 1,
        false => bits,
    }
}

const fn mask(bits: u32) -> u64 {
    u64::MAX >> (64 - bits)
}
