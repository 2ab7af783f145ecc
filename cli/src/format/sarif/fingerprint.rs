//! What stays the same of a finding when lines are put in above it, so that a service knows it again.

use std::collections::HashMap;

use lexican_eds::{diagnostic::Diagnostic, source::Source};

/// The fingerprints of one file's findings.
pub(super) struct Fingerprints<'a> {
    source: &'a Source,
    /// How many findings had this hash before: lines may be alike.
    seen: HashMap<u64, usize>,
}

impl<'a> Fingerprints<'a> {
    pub(super) fn new(source: &'a Source) -> Self {
        let seen = HashMap::new();
        Self { source, seen }
    }

    /// Of the rule, the section and the line; the next finding of the same rule on the same line in the same section
    /// has another number behind the colon.
    pub(super) fn of(&mut self, finding: &Diagnostic) -> String {
        let line = if finding.about_file() {
            ""
        } else {
            self.source.line_text(self.source.line_column(finding.span).line)
        };
        let section = finding.section.map_or("", |header| self.source.slice(header));
        let parts = [finding.code.as_str(), section, line.trim()];
        let hash = fnv_1a(parts.join("\n").as_bytes());
        let count = self.seen.entry(hash).or_default();
        *count += 1;
        format!("{hash:016x}:{count}")
    }
}

/// The hash of Fowler, Noll and Vo: the same in each version of Lexican, unlike that of the standard library.
fn fnv_1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01B3)
    })
}

#[cfg(test)]
mod tests {
    use super::fnv_1a;

    #[test]
    fn the_hash_is_that_of_its_authors() {
        // From the test vectors of their page.
        assert_eq!(fnv_1a(b""), 0xCBF2_9CE4_8422_2325);
        assert_eq!(fnv_1a(b"a"), 0xAF63_DC4C_8601_EC8C);
        assert_eq!(fnv_1a(b"foobar"), 0x8594_4171_F739_67E8);
    }
}
