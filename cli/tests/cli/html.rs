//! `--format html`: the page is read by an XML parser, which takes no tag that is not closed and no text that is not escaped.

use roxmltree::{Document, Node, ParsingOptions};

use crate::lexican::Lexican;

const EDS: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.eds");
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.json");

fn page(files: &[(&str, &[u8])], arguments: &[&str]) -> String {
    let ran = Lexican::with(files).run(arguments);
    assert!(ran.code.is_some_and(|code| code < 2), "{ran:#?}");
    ran.stdout
}

fn validated() -> String {
    let files = [("pump.eds", EDS), ("node5.json", DENIED)];
    page(&files, &["validate", "pump.eds", "node5.json", "--format", "html"])
}

#[track_caller]
fn parse(page: &str) -> Document<'_> {
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(page, options).unwrap_or_else(|error| panic!("{error}\n{page}"))
}

fn text(node: Node) -> String {
    let texts = node.descendants().filter(Node::is_text);
    texts.filter_map(|text| text.text()).collect()
}

#[test]
fn the_page_has_the_numbers_and_every_finding() {
    let page = validated();
    let document = parse(&page);
    let findings: Vec<Node> = document
        .descendants()
        .filter(|node| node.has_tag_name("details"))
        .collect();
    assert_eq!(findings.len(), 2);
    assert_eq!(findings[1].attribute("data-level"), Some("deny"));
    let finding = text(findings[1]);
    for part in [
        "error",
        "DMP007",
        "[1018sub2]",
        "1018sub2 answers 0x00000002",
        "line 94",
        "pump.eds:94:",
    ] {
        assert!(finding.contains(part), "{part}: {finding}");
    }
    let header = document.descendants().find(|node| node.has_tag_name("header")).unwrap();
    assert!(text(header).contains("1 device checked: 2 errors"), "{}", text(header));
}

#[test]
fn the_page_loads_nothing() {
    let page = validated();
    let document = parse(&page);
    for node in document.descendants() {
        for attribute in ["src", "href", "action"] {
            assert_eq!(node.attribute(attribute), None);
        }
    }
    for loading in ["url(", "@import", "fetch(", "http"] {
        assert!(!page.contains(loading), "{loading}");
    }
}

#[test]
fn a_hostile_name_is_text_and_nothing_else() {
    let hostile = "</pre><script>alert(1)</script><img src=x onerror='alert(2)'>&\"";
    let eds = str::from_utf8(EDS)
        .unwrap()
        .replace("ParameterName=", &format!("ParameterName={hostile}"));
    let name = "a<b>&'c.eds";
    let page = page(
        &[(name, eds.as_bytes()), ("node5.json", DENIED)],
        &["check", name, "--format", "html", "--level", "OBJ=warn"],
    );
    let document = parse(&page);
    let scripts = document.descendants().filter(|node| node.has_tag_name("script"));
    assert_eq!(scripts.count(), 1);
    assert!(!document.descendants().any(|node| node.has_tag_name("img")));
    let heading = document.descendants().find(|node| node.has_tag_name("h2")).unwrap();
    assert_eq!(text(heading), name);
}

#[test]
fn what_could_not_be_read_is_on_the_page() {
    let ran = Lexican::with(&[("pump.eds", EDS)]).run(&["check", "pump.eds", "no.eds", "--format", "html"]);
    assert_eq!(ran.code, Some(2));
    assert!(
        text(parse(&ran.stdout).root()).contains("cannot read no.eds"),
        "{ran:#?}"
    );
}
