//! Whatever the bytes: checking them ends, panics never, and lets nothing through that steers a terminal.

use std::{fs, path::Path};

use lexican_eds::{
    Reading, fix, format,
    render::Renderer,
    rules::{self, Levels},
};
use proptest::{prelude::*, sample::Index};

/// Checks the bytes and renders what was found.
fn report(bytes: Vec<u8>) -> String {
    let reading = lexican_eds::read("any.eds", bytes);
    let found = rules::check(&reading, &Levels::default());
    let source = reading.document.source();
    found
        .iter()
        .map(|diagnostic| Renderer::plain().render(source, diagnostic))
        .collect()
}

/// The bytes after `check --fix`.
fn mended(bytes: Vec<u8>) -> Vec<u8> {
    let check = |reading: &Reading| rules::check(reading, &Levels::default());
    let mended = fix::mend(lexican_eds::read("any.eds", bytes), check);
    mended.reading.document.to_bytes()
}

fn is_harmless(text: &str) -> bool {
    !text.chars().any(|c| c.is_control() && c != '\n')
}

fn fixture(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules").join(name);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Pieces that an EDS is made of, and some that it should not be.
fn line() -> impl Strategy<Value = String> {
    let section = prop_oneof![
        Just("FileInfo".to_owned()),
        Just("DeviceInfo".to_owned()),
        Just("OptionalObjects".to_owned()),
        Just("ConnectedModules".to_owned()),
        Just("DeviceComissioning".to_owned()),
        (0x1FFEu16..0x2002).prop_map(|index| format!("{index:04X}")),
        (0x1FFEu16..0x2002, any::<u8>()).prop_map(|(index, sub)| format!("{index:04x}sub{sub:x}")),
        (0x1FFEu16..0x2002).prop_map(|index| format!("{index:04X}Value")),
        (0u16..3, 0x1FFEu16..0x2002).prop_map(|(number, index)| format!("M{number}SubExt{index:04X}")),
    ];
    let keyword = proptest::sample::select(vec![
        "ParameterName",
        "ObjectType",
        "DataType",
        "AccessType",
        "DefaultValue",
        "ParameterValue",
        "LowLimit",
        "HighLimit",
        "SubNumber",
        "CompactSubObj",
        "SupportedObjects",
        "NrOfEntries",
        "NrOfRXPDO",
        "CompactPDO",
        "Count",
        "ObjExtend",
        "1",
        "2",
        "255",
        "Nonsense",
    ]);
    let value = prop_oneof![
        Just(String::new()),
        any::<u8>().prop_map(|value| value.to_string()),
        any::<u64>().prop_map(|value| format!("0x{value:X}")),
        any::<i64>().prop_map(|value| value.to_string()),
        Just("$NodeID+0x180 ; comment".to_owned()),
        Just("0899".to_owned()),
        Just("rw".to_owned()),
        "\\PC{0,12}",
    ];
    prop_oneof![
        2 => section.prop_map(|section| format!("[{section}]")),
        5 => (keyword, value).prop_map(|(keyword, value)| format!("{keyword}={value}")),
        1 => ".{0,20}",
    ]
}

proptest! {
    #[test]
    fn any_bytes_are_checked(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
        prop_assert!(is_harmless(&report(bytes)));
    }

    #[test]
    fn any_lines_are_checked(lines in proptest::collection::vec(line(), 0..60)) {
        prop_assert!(is_harmless(&report(lines.join("\r\n").into_bytes())));
    }

    #[test]
    fn any_lines_are_mended_once_and_for_all(lines in proptest::collection::vec(line(), 0..60)) {
        let once = mended(lines.join("\r\n").into_bytes());
        let twice = mended(once.clone());
        prop_assert_eq!(String::from_utf8_lossy(&twice), String::from_utf8_lossy(&once));
    }

    #[test]
    fn any_lines_are_formatted_once_and_for_all(lines in proptest::collection::vec(line(), 0..60)) {
        let reading = lexican_eds::read("any.eds", lines.join("\r\n").into_bytes());
        if let Ok(once) = format::format(reading) {
            let once = once.document.to_bytes();
            let twice = format::format(lexican_eds::read("any.eds", once.clone()));
            let twice = twice.expect("what was written can be written").document.to_bytes();
            prop_assert_eq!(String::from_utf8_lossy(&twice), String::from_utf8_lossy(&once));
        }
    }

    #[test]
    fn a_damaged_file_is_checked(at in any::<Index>(), bytes in proptest::collection::vec(any::<u8>(), 0..8)) {
        let mut file = fixture("EDS030.dcf");
        let at = at.index(file.len());
        file.splice(at..at, bytes);
        prop_assert!(is_harmless(&report(file)));
    }
}

#[test]
fn a_line_of_megabytes_is_cut_to_what_a_reader_wants_to_see() {
    let mut file = fixture("OBJ003.fixed.eds");
    file.extend(b"[2001]\nParameterName=Long\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=");
    file.resize(file.len() + 5_000_000, b'9');
    let text = report(file);
    assert!(text.contains("is out of the range of UNSIGNED32"), "{}", text.len());
    assert!(text.len() < 5_000, "{}", text.len());
}
