//! What checkers of EDS files look for, ours and others: CANchkEDS, Lely's dcfchk, EdsDcfNet, libEDSsharp, eds-utils,
//! objdictgen, node-canopen, zencan, CiA's conformance test. Each check has a rule here or a reason why not.

use std::fmt::Write as _;

const TABLE: &str = include_str!("catalogue.tsv");

/// The checks with the rules that make them, in Markdown.
pub(super) fn table() -> String {
    let mut text = INTRODUCTION.to_owned();
    for (check, here) in checks() {
        let _ = writeln!(text, "| {check} | {here} |");
    }
    text
}

const INTRODUCTION: &str = "
## What other checkers look for

CANchkEDS, Lely's dcfchk, EdsDcfNet, libEDSsharp, eds-utils, objdictgen, node-canopen, zencan and CiA's conformance test look for
this; here it is found by:

| check | here |
|---|---|
";

/// What is looked for, and the codes or the reason.
fn checks() -> impl Iterator<Item = (&'static str, &'static str)> {
    TABLE.lines().skip(1).filter_map(|line| line.split_once('\t'))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rules::find;

    #[test]
    fn each_check_names_rules_that_exist_or_says_why_there_is_none() {
        for (check, here) in checks() {
            let words = here.split(|c: char| !c.is_ascii_alphanumeric());
            let is_code = |word: &&str| word.len() == 6 && word.ends_with(|c: char| c.is_ascii_digit());
            let codes: Vec<&str> = words.filter(is_code).collect();
            for code in &codes {
                assert!(find(code).is_some(), "{check}: there is no rule {code}");
            }
            let is_explained = here.starts_with("family ") || here.starts_with("no rule: ");
            assert!(is_explained || !codes.is_empty(), "{check}: {here}");
        }
        assert!(checks().count() > 100);
    }
}
