//! A rule as SARIF's metadata.

use lexican_eds::{diagnostic::Code, rules};

use super::log::{Configuration, MarkdownMessage, Message, Properties, ReportingDescriptor};

/// Where all rules are described, on the web.
const MANUAL: &str = concat!(env!("CARGO_PKG_REPOSITORY"), "/blob/main/docs/rules.md");

/// The rule of `code`, with its page.
pub(super) fn described(code: Code) -> Option<ReportingDescriptor> {
    let rule = rules::find(code.as_str())?;
    let page = rules::page(rule);
    Some(ReportingDescriptor {
        id: code.as_str(),
        name: camel_case(&rule.name()),
        short_description: Message::new(rule.name()),
        full_description: Message::new(rule.summary()),
        help: MarkdownMessage {
            text: page.clone(),
            markdown: page,
        },
        help_uri: format!("{MANUAL}#{}", rules::anchor(rule)),
        default_configuration: Configuration {
            level: super::level(rule.level()),
        },
        properties: Properties {
            tags: ["canopen", code.family()],
        },
    })
}

/// `JunkLine`, as SARIF wants an identifier that a person can read.
fn camel_case(name: &str) -> String {
    let words = name.split(' ').map(|word| {
        let (first, rest) = word.split_at(word.chars().next().map_or(0, char::len_utf8));
        first.to_uppercase() + rest
    });
    words.collect()
}
