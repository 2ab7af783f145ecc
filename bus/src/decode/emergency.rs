//! What the codes of emergency messages mean.

/// CiA 301, table 26.
const CODES: [(u16, &str); 34] = [
    (0x0000, "error reset, no error"),
    (0x1000, "generic error"),
    (0x2000, "current"),
    (0x2100, "current at the device's input"),
    (0x2200, "current inside the device"),
    (0x2300, "current at the device's output"),
    (0x3000, "voltage"),
    (0x3100, "mains voltage"),
    (0x3200, "voltage inside the device"),
    (0x3300, "output voltage"),
    (0x4000, "temperature"),
    (0x4100, "ambient temperature"),
    (0x4200, "device temperature"),
    (0x5000, "device hardware"),
    (0x6000, "device software"),
    (0x6100, "internal software"),
    (0x6200, "user software"),
    (0x6300, "data set"),
    (0x7000, "additional modules"),
    (0x8000, "monitoring"),
    (0x8100, "communication"),
    (0x8110, "CAN overrun, frames lost"),
    (0x8120, "CAN error passive"),
    (0x8130, "life guarding or heartbeat"),
    (0x8140, "recovered from bus off"),
    (0x8150, "CAN-ID collision"),
    (0x8200, "protocol"),
    (0x8210, "PDO not processed, it is too short"),
    (0x8220, "PDO longer than its mapping"),
    (0x8230, "MPDO not processed, no such object"),
    (0x8240, "unexpected length of SYNC"),
    (0x8250, "RPDO timeout"),
    (0x9000, "external error"),
    (0xF000, "additional functions"),
];

/// CiA 406: what an encoder says beside that.
const ENCODER_CODES: [(u16, &str); 4] = [
    (0x2110, "input current too high"),
    (0x3110, "input voltage out of range"),
    (0x4200, "temperature inside out of range"),
    (0x5100, "memory"),
];

/// Bits of the error register (1001h), from 0.
pub(super) const REGISTER: [&str; 8] = [
    "generic",
    "current",
    "voltage",
    "temperature",
    "communication",
    "device profile",
    "bit 6",
    "manufacturer",
];

/// What the error code `code` says; of a detail that no standard defines what its class says.
pub(super) fn meaning(code: u16, is_encoder: bool) -> &'static str {
    if code >= 0xFF00 {
        return "device specific";
    }
    let own: &[_] = if is_encoder { &ENCODER_CODES } else { &[] };
    [code, code & 0xFFF0, code & 0xFF00, code & 0xF000]
        .into_iter()
        .find_map(|code| find(own, code).or_else(|| find(&CODES, code)))
        .unwrap_or("unknown")
}

fn find(codes: &[(u16, &'static str)], code: u16) -> Option<&'static str> {
    let at = codes.binary_search_by_key(&code, |known| known.0).ok()?;
    codes.get(at).map(|known| known.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_has_its_own_meaning_or_that_of_its_class() {
        assert!(CODES.is_sorted_by_key(|code| code.0) && ENCODER_CODES.is_sorted_by_key(|code| code.0));
        assert_eq!(meaning(0x8130, false), "life guarding or heartbeat");
        assert_eq!(meaning(0x8139, false), "life guarding or heartbeat");
        assert_eq!(meaning(0x2110, false), "current at the device's input");
        assert_eq!(meaning(0x2110, true), "input current too high");
        assert_eq!(meaning(0x50FF, true), "device hardware");
        assert_eq!(meaning(0xFF05, true), "device specific");
        assert_eq!(meaning(0xA000, false), "unknown");
    }
}
