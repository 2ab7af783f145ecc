//! The dump format: what is written can be read by a person and by us, and what is not a dump is refused with its place.

use std::collections::BTreeMap;

use lexican_eds::dump::{AbortCode, Answer, Dump, Identity, JsonError};
use lexican_eds::ir::{Address, NodeId};
use proptest::prelude::*;

fn node(id: u8) -> NodeId {
    NodeId::new(id).expect("a test's node-ID")
}

/// The dump that docs/dump-format.md shows.
fn documented() -> Dump {
    let objects = [
        (0x1000, 0, Answer::Value(vec![0x96, 0x01, 0x02, 0x00])),
        (0x1003, 0, Answer::Value(vec![0])),
        (0x1003, 1, Answer::Abort(AbortCode(0x0800_0024))),
        (0x1008, 0, Answer::Value(b"WDGA".to_vec())),
        (0x1018, 1, Answer::Value(vec![0x9B, 0, 0, 0])),
        (0x2000, 0, Answer::Timeout),
    ];
    Dump {
        node_id: node(5),
        taken: Some("2026-11-23T04:17:00Z".into()),
        device: Some(Identity {
            device_type: Some(0x0002_0196),
            vendor_id: Some(0x9B),
            ..Identity::default()
        }),
        objects: objects
            .into_iter()
            .map(|(index, sub, answer)| (Address::new(index, sub), answer))
            .collect(),
    }
}

#[test]
fn the_documentation_shows_what_is_written_and_read() {
    let page = include_str!("../../docs/dump-format.md");
    let (_, rest) = page.split_once("```json\n").unwrap();
    let (example, _) = rest.split_once("```").unwrap();
    assert_eq!(documented().to_json(), example);
    assert_eq!(Dump::from_json(example.as_bytes()), Ok(documented()));
}

#[test]
fn a_dump_of_nothing_is_a_dump() {
    let empty = Dump::new(node(127));
    assert_eq!(Dump::from_json(empty.to_json().as_bytes()), Ok(empty));
}

#[test]
fn any_layout_order_and_case_is_read() {
    let text = "\u{FEFF} {\"objects\":{\"1A00SUBfe\":\"0aFf 01\",\"1000sub00\":{\"timeout\":true}},\r\n\
                \"node\":1,\"version\":1,\"format\":\"lexican-dump\",\"taken\":\"2026-11-23T04:17:00.25+01:00\"}";
    let dump = Dump::from_json(text.as_bytes()).unwrap();
    assert_eq!(dump.value(Address::new(0x1A00, 0xFE)), Some(&[0x0A, 0xFF, 0x01][..]));
    assert_eq!(dump.answer(Address::new(0x1000, 0)), Some(&Answer::Timeout));
    assert_eq!(dump.taken.as_deref(), Some("2026-11-23T04:17:00.25+01:00"));
}

/// A dump with `objects` as the text between the braces, on line 5.
fn with_objects(objects: &str) -> String {
    format!("{{\n\"format\": \"lexican-dump\",\n\"version\": 1,\n\"node\": 5, \"objects\": {{\n{objects}\n}} }}\n")
}

fn refusal(text: &str) -> JsonError {
    Dump::from_json(text.as_bytes()).expect_err("this is no dump")
}

#[track_caller]
fn assert_refused(text: &str, expected: &str) {
    let error = refusal(text);
    assert_eq!(error.to_string(), expected, "for {text}");
    assert!(!error.help().is_empty());
}

#[test]
fn a_value_that_cannot_be_is_refused_with_its_place() {
    let cases = [
        (r#""1000sub0": "9""#, "5:15: `9` is not bytes as 92 01 02 00"),
        (
            r#""1000sub0": "96 1 02""#,
            "5:21: `96 1 02` is not bytes as 92 01 02 00",
        ),
        (r#""1000sub0": "+6""#, "5:16: `+6` is not bytes as 92 01 02 00"),
        (r#""1000": "96""#, "5:6: `1000` is not an address as 1018sub1"),
        (
            r#""1000sub100": "96""#,
            "5:12: `1000sub100` is not an address as 1018sub1",
        ),
        (r#""100é": "96""#, "5:7: `100é` is not an address as 1018sub1"),
        (r#""+100sub0": "96""#, "5:10: `+100sub0` is not an address as 1018sub1"),
        (
            r#""1000sub0": {"abort": 5}"#,
            "5:23: invalid type: integer `5`, expected a number as \"0x06090011\"",
        ),
        (
            r#""1000sub0": {"abort": "06090011"}"#,
            "5:32: `06090011` is not a number as \"0x06090011\"",
        ),
        (
            r#""1000sub0": {"abort": "0x106090011"}"#,
            "5:35: `0x106090011` is not a number as \"0x06090011\"",
        ),
        (
            "\"1000sub0\": \"96\",\n\"1000SUB0\": \"96\"",
            "6:10: 1000sub0 has two answers",
        ),
        (
            r#""1000sub0": {"abort": "0x08000000", "timeout": true}"#,
            "5:45: an address has one answer",
        ),
    ];
    for (objects, expected) in cases {
        assert_refused(&with_objects(objects), expected);
    }
    let expected = "invalid type: floating point `1.5`, expected bytes as \"92 01 02 00\", { \"abort\": \"0x06020000\" } or { \"timeout\": true }";
    assert_refused(&with_objects(r#""1000sub0": 1.5"#), &format!("5:15: {expected}"));
    for answer in ["{}", r#"{"timeout": false}"#, r#"{"value": "00"}"#] {
        let error = refusal(&with_objects(&format!(r#""1000sub0": {answer}"#)));
        assert!(error.message().contains("expected bytes as"), "{error}");
    }
}

#[test]
fn a_header_that_cannot_be_is_refused_with_its_place() {
    let good = with_objects("");
    let cases = [
        (good.replace("5,", "0,"), "4:9: node 0 cannot be; a node-ID is 1 to 127"),
        (
            good.replace("5,", "128,"),
            "4:11: node 128 cannot be; a node-ID is 1 to 127",
        ),
        (
            good.replace("5,", "5, \"taken\": \"yesterday\","),
            "4:31: `yesterday` is not a time as 2026-11-23T04:17:00Z",
        ),
        (
            good.replace("lexican-dump", "odump"),
            "2:1: this JSON is of another format",
        ),
        (good.replace("\"node\": 5,", ""), "6:3: missing field `node`"),
        (
            good.replace(": 1", ": 0"),
            "3:1: there is no version 0 of the dump format",
        ),
        (good.replace("\"version\": 1,", ""), "1:1: the dump has no \"version\""),
        (
            "{}".into(),
            "1:1: this JSON is not a dump: it has no \"format\": \"lexican-dump\"",
        ),
    ];
    for (text, expected) in cases {
        assert_refused(&text, expected);
    }
}

#[test]
fn a_newer_version_is_called_newer_whatever_else_it_holds() {
    let text = "{\n\"format\": \"lexican-dump\",\n\"version\": 2, \"nodes\": [{\"objects\": 7}] }";
    assert_refused(
        text,
        "3:1: the dump is of version 2; this program reads up to version 1",
    );
    assert_eq!(refusal(text).help(), "use a newer release of Lexican");
}

#[test]
fn what_is_no_json_says_what_it_looks_like() {
    assert_refused("", "1:1: the dump is empty");
    assert_refused(
        "[FileInfo]\nFileName=x.eds\n",
        "1:1: this looks like an EDS file, not a dump",
    );
    assert_refused(
        "(1.0) can0 601#40",
        "1:1: this is not a dump: it does not begin with `{`",
    );
    let utf16: Vec<u8> = "\u{FEFF}{}".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(
        Dump::from_json(&utf16).unwrap_err().message(),
        "the dump is not UTF-8 text"
    );
}

#[test]
fn a_member_that_the_format_does_not_name_is_refused() {
    let text = with_objects("").replace("\"node\"", "\"nod\\u001b\": 1, \"node\"");
    let error = refusal(&text);
    assert!(
        error
            .message()
            .starts_with("unknown field `nod\u{FFFD}`, expected one of"),
        "{error}"
    );
}

#[test]
fn every_beginning_of_a_dump_is_refused_without_panic() {
    let text = documented().to_json();
    for end in 0..text.len() - 2 {
        let error = refusal(&text[..end]);
        assert!(
            end == 0 || error.message().starts_with("the dump ends in the middle"),
            "{end}: {error}"
        );
    }
}

#[test]
fn hostile_nesting_is_refused_without_overflow() {
    for (open, answer) in [("[", r#""1000sub0": "#), (r#"{"a":"#, r#""1000sub0": "#)] {
        refusal(&with_objects(&format!("{answer}{}", open.repeat(1_000_000))));
    }
}

fn any_answer() -> impl Strategy<Value = Answer> {
    prop_oneof![
        proptest::collection::vec(any::<u8>(), 0..40).prop_map(Answer::Value),
        any::<u32>().prop_map(|code| Answer::Abort(AbortCode(code))),
        Just(Answer::Timeout),
    ]
}

fn any_identity() -> impl Strategy<Value = Identity> {
    any::<[Option<u32>; 5]>().prop_map(
        |[device_type, vendor_id, product_code, revision_number, serial_number]| Identity {
            device_type,
            vendor_id,
            product_code,
            revision_number,
            serial_number,
        },
    )
}

fn any_dump() -> impl Strategy<Value = Dump> {
    let objects = proptest::collection::btree_map(any::<(u16, u8)>(), any_answer(), 0..60);
    let taken = proptest::option::of(
        "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}(\\.[0-9]{1,9})?(Z|[+-][0-9]{2}:[0-9]{2})",
    );
    (1..=127u8, taken, proptest::option::of(any_identity()), objects).prop_map(|(id, taken, device, objects)| Dump {
        node_id: node(id),
        taken,
        device,
        objects: objects
            .into_iter()
            .map(|((index, sub), answer)| (Address::new(index, sub), answer))
            .collect::<BTreeMap<_, _>>(),
    })
}

proptest! {
    #[test]
    fn what_was_written_is_what_is_read(dump in any_dump()) {
        prop_assert_eq!(Dump::from_json(dump.to_json().as_bytes()), Ok(dump));
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = Dump::from_json(&bytes);
    }

    #[test]
    fn a_damaged_dump_is_read_or_refused(at in 0usize..400, byte in any::<u8>()) {
        let mut text = documented().to_json().into_bytes();
        if let Some(place) = text.get_mut(at) {
            *place = byte;
        }
        if let Err(error) = Dump::from_json(&text) {
            prop_assert!(error.line() <= 20 && !error.message().contains(char::is_control));
        }
    }
}
