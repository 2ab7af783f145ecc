//! The numbers of CANchkEDS, the checker in CiA's conformance test, and our codes for them.

use std::{collections::BTreeMap, fmt::Write as _};

use super::{Rule, all};

/// The errors (V) and warnings (W) of CANchkEDS, each with the rules that cite it, in Markdown.
pub(super) fn table() -> String {
    let mut text = INTRODUCTION.to_owned();
    for (Number(letter, number), codes) in numbers() {
        let _ = writeln!(text, "| {letter}{number} | {} |", codes.join(", "));
    }
    text.push_str(MISSING);
    text
}

const INTRODUCTION: &str = "
## The numbers of CANchkEDS

CANchkEDS is the checker in CiA's conformance test. A vendor who knows its errors (V) and warnings (W) finds them here by our codes.

| CANchkEDS | here |
|---|---|
";

/// The numbers that no rule stands for.
const MISSING: &str = "
Without a rule of ours are V1600 and W1000 to W1003, and what V30, V38, V39 and W30 say of device profiles other than CiA 406: they
hold a file against Vector's database of profiles, which is not public.
";

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Number(char, u16);

fn numbers() -> BTreeMap<Number, Vec<&'static str>> {
    let mut numbers: BTreeMap<Number, Vec<&'static str>> = BTreeMap::new();
    for rule in all() {
        for number in cited(rule) {
            numbers.entry(number).or_default().push(rule.code().as_str());
        }
    }
    numbers
}

/// The numbers in the rule's Reference.
fn cited(rule: &Rule) -> Vec<Number> {
    let page = rule.documentation();
    let reference = page.split_once("CANchkEDS").map_or("", |(_, after)| after);
    let words = reference.split(|c: char| !c.is_ascii_alphanumeric());
    words.filter_map(number).collect()
}

fn number(word: &str) -> Option<Number> {
    let letter = word.chars().next().filter(|letter| matches!(letter, 'V' | 'W'))?;
    Some(Number(letter, word.get(1..)?.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_found_by_the_rules_that_cite_it() {
        let numbers = numbers();
        assert_eq!(numbers.get(&Number('V', 64)), Some(&vec!["PDO001"]));
        assert_eq!(numbers.get(&Number('W', 4)), Some(&vec!["PDO006", "PDO007"]));
    }
}
