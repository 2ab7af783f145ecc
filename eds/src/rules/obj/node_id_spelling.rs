use crate::{
    diagnostic::Level,
    fix::Fix,
    literal::Note,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule, value_name},
};

declare_rule! {
    /// ## What it does
    /// Finds formulas whose `$NODEID` is spelled in another way: `$NodeID`, `NODEID`.
    ///
    /// ## Why it matters
    /// Readers that know `$NODEID` alone take the formula for a text, or its value for 0.
    ///
    /// ## Example
    /// ```ini
    /// [1014]
    /// DefaultValue=$NodeID+0x80
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1014]
    /// DefaultValue=$NODEID+0x80
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, DefaultValue
    pub(crate) NodeIdSpelling { code: "OBJ014", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for NodeIdSpelling {
    fn check(eds: &Eds, report: &mut Report) {
        let mut last = None;
        for problem in eds.problems() {
            if let Problem::Unusual {
                keyword,
                note: Note::NodeIdCase | Note::NodeIdWithoutDollar,
                at,
                ..
            } = *problem
                && last != Some(at)
            {
                let (keyword, value, bare) = (value_name(keyword), report.quote(at), report.bare(at));
                let fix = spelled(report.text(bare)).map(|text| Fix::replace(bare, text));
                report
                    .at(
                        at,
                        format!("{keyword} {value} does not spell $NODEID as the standard does"),
                    )
                    .help("write `$NODEID`")
                    .fix(fix);
                last = Some(at);
            }
        }
    }
}

/// The formula with `$NODEID` as the standard spells it.
fn spelled(text: &str) -> Option<String> {
    let name = text.to_ascii_uppercase().find("NODEID")?;
    let before = text.get(..name)?;
    let before = before.trim_end().strip_suffix('$').unwrap_or(before);
    let after = text.get(name + "NODEID".len()..)?;
    Some(format!("{before}$NODEID{after}"))
}
