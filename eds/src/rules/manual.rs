//! The rules' documentation as users read it, in Markdown.

use std::fmt::Write as _;

use super::{Family, Fixable, Rule, all, canchkeds, catalogue, families, real_files};

/// One rule's page: what `lexican explain CODE` prints.
#[must_use]
pub fn page(rule: &Rule) -> String {
    let (code, name, level, since) = (rule.code(), rule.name(), rule.level(), rule.since());
    format!(
        "# {code}: {name}\n\nLevel: {level}. Since {since}.{}\n\n{}",
        fixable(rule),
        rule.documentation()
    )
}

/// The page's place in [`manual`], as the part of a link behind `#`: `ini001-junk-line`.
#[must_use]
pub fn anchor(rule: &Rule) -> String {
    format!("{}-{}", rule.code(), rule.name().replace(' ', "-")).to_lowercase()
}

fn fixable(rule: &Rule) -> &'static str {
    match rule.fixable() {
        Fixable::Never => "",
        Fixable::Sometimes => " `lexican check --fix` mends it where only one cure is possible.",
        Fixable::Always => " `lexican check --fix` mends it.",
    }
}

/// All rules: `docs/rules.md`.
#[must_use]
pub fn manual() -> String {
    let mut text = INTRODUCTION.to_owned();
    for family in families() {
        text.push_str(&table(family));
    }
    text.push_str(&real_files::section());
    text.push_str(&canchkeds::table());
    text.push_str(&catalogue::table());
    for rule in all() {
        let _ = write!(text, "\n{}", below(&page(rule)));
    }
    text
}

const INTRODUCTION: &str = "\
# The rules of `lexican check` and `lexican validate`

<!-- Made by `lexican explain --all`: change the rules' doc comments in eds/src/rules, not this file. -->

A *deny* means that a master or a generator will go wrong, a *warn* that the standard is broken, a *note* is a matter of
style; an *allow* is not looked for unless you ask. `--level CODE=allow|note|warn|deny` changes that for a rule, or with its
letters for a family.

`lexican check --fix` mends what has a safe cure: where only one cure is possible, the device stays as it is described but for
the fact that the finding is about, and nothing is lost. `--diff` shows what it would change.
";

fn table(family: &Family) -> String {
    let mut text = format!("\n## {}: {}\n\n", family.letters, family.title);
    text.push_str("| code | allow … | level | fix | files | what it does |\n|---|---|---|---|---|---|\n");
    for rule in all().iter().filter(|rule| rule.code().family() == family.letters) {
        let (code, name, level, summary) = (rule.code(), rule.name(), rule.level(), rule.summary());
        let (anchor, files) = (anchor(rule), real_files::files(rule));
        let fix = match rule.fixable() {
            Fixable::Never => "",
            Fixable::Sometimes => "sometimes",
            Fixable::Always => "always",
        };
        let _ = writeln!(
            text,
            "| [{code}](#{anchor}) | {name} | {level} | {fix} | {files} | {summary} |"
        );
    }
    text
}

/// The page with its headings one level down, so that it fits below the manual's; examples stay as they are.
fn below(page: &str) -> String {
    let mut in_example = false;
    let mut lower = |line: &str| {
        in_example ^= line.starts_with("```");
        let heading = !in_example && line.starts_with('#');
        format!("{}{line}\n", if heading { "#" } else { "" })
    };
    page.lines().map(&mut lower).collect()
}
