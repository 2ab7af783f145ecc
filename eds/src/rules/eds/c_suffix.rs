use crate::{
    diagnostic::Level,
    fix::Fix,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds numbers with a suffix of the language C: `100UL`, `0x1000LL`, `1.5f`.
    ///
    /// ## Why it matters
    /// An EDS knows no suffixes: most readers cannot read the number.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DefaultValue=1000U
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// DefaultValue=1000
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers; CANchkEDS V21
    pub(crate) CSuffix { code: "EDS026", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl ModelRule for CSuffix {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, at, .. } in unusual(eds, Note::Suffix) {
            let (value, bare) = (report.quote(at), report.bare(at));
            let plain = without_suffix(report.text(bare));
            report
                .at(at, format!("{keyword} {value} has a suffix of C"))
                .help("leave out the suffix")
                .fix(Fix::replace(bare, plain));
        }
    }
}

/// The number, or each number of a formula, without its suffix.
fn without_suffix(text: &str) -> String {
    let plain = |part: &str| {
        let number = part.trim_end();
        let integer = number.trim_end_matches(['u', 'U', 'l', 'L']);
        let is_real = integer == number && !number.starts_with(['$', 'N', 'n']);
        let plain = if is_real {
            number.trim_end_matches(['f', 'F'])
        } else {
            integer
        };
        format!("{plain}{}", &part[number.len()..])
    };
    text.split('+').map(plain).collect::<Vec<_>>().join("+")
}

#[cfg(test)]
mod tests {
    use super::without_suffix;

    #[test]
    fn a_suffix_goes_from_each_number_of_a_value() {
        assert_eq!(without_suffix("100UL"), "100");
        assert_eq!(without_suffix("0xFFLL"), "0xFF");
        assert_eq!(without_suffix("1.5f"), "1.5");
        assert_eq!(without_suffix("0x180U + $NODEID"), "0x180 + $NODEID");
        assert_eq!(without_suffix("$NODEID+0x180L"), "$NODEID+0x180");
    }
}
