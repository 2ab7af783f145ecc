//! Edits: what is asked for changes, and nothing else.

use lexican_eds::document::{Document, EditError, Keyword, SectionName};

use crate::files::{document, real_eds};

/// Lines that are as hard as real ones: two encodings, three line ends, blanks, no end at the end.
const HARD: &[u8] =
    b"; Sch\x94naich\r\n[FileInfo]\r\nCreatedBy = M\x81ller \r\nDescription=\r\n\t[1017]\nParameterName=\tZeit\r\
    DefaultValue=0   \r\n\r\n; L\xC3\xBCfter\r\nHighLimit=0xFFFF";

fn lines(bytes: &[u8]) -> Vec<&[u8]> {
    bytes.split_inclusive(|byte| *byte == b'\n').collect()
}

/// Sets each value of `document` alone, and looks at all other bytes.
fn assert_each_value_can_be_set_alone(document: &Document, every: usize) {
    let before = document.to_bytes();
    let entries = document.sections().iter().flat_map(|section| &section.entries);
    for entry in entries.step_by(every) {
        let mut edit = document.edit();
        edit.set(entry, "edited 42").unwrap();
        let edited = edit.apply().unwrap();
        let after = edited.to_bytes();
        let start = prefix(&before, &after);
        let end = prefix_back(&before, &after).min(before.len().min(after.len()) - start);
        let old = &before[start..before.len() - end];
        assert!(
            !old.contains(&b'\n'),
            "more than one line changed at {:?}",
            document.text(entry.key)
        );
        let places = edited.sections().iter().flat_map(|section| &section.entries);
        let changed = places.zip(document.sections().iter().flat_map(|section| &section.entries));
        for (now, was) in changed {
            let expected = if was == entry {
                "edited 42"
            } else {
                document.text(was.value)
            };
            assert_eq!(edited.text(now.value), expected);
        }
    }
}

fn prefix(one: &[u8], other: &[u8]) -> usize {
    one.iter().zip(other).take_while(|(one, other)| one == other).count()
}

fn prefix_back(one: &[u8], other: &[u8]) -> usize {
    one.iter()
        .rev()
        .zip(other.iter().rev())
        .take_while(|(one, other)| one == other)
        .count()
}

#[test]
fn each_value_of_a_hard_file_can_be_set_alone() {
    assert_each_value_can_be_set_alone(&document(HARD), 1);
}

#[test]
fn values_of_real_files_can_be_set_alone() {
    for file in real_eds().filter(|file| file.bytes.len() < 12_000).take(40) {
        assert_each_value_can_be_set_alone(&file.document, 29);
    }
}

#[test]
fn one_edited_value_is_one_changed_line() {
    let document = document(HARD);
    let entry = document.sections()[0].entry(Keyword::CreatedBy).unwrap();
    let mut edit = document.edit();
    edit.set(entry, "Böhm").unwrap();
    let written = edit.apply().unwrap().to_bytes();
    let mut expected = lines(HARD);
    expected[2] = b"CreatedBy = B\x94hm \r\n";
    assert_eq!(written, expected.concat());
}

#[test]
fn a_new_value_in_an_ascii_line_takes_the_encoding_of_the_file() {
    for (comment, value) in [
        (&b"; M\x81ller\n"[..], &b"B\x94hm"[..]),
        (b"; M\xFCller\n", b"B\xF6hm"),
        (b"; M\xC3\xBCller\n", b"B\xC3\xB6hm"),
        (b"; Mueller\n", b"B\xC3\xB6hm"),
    ] {
        let document = document([comment, b"[FileInfo]\nCreatedBy=x\n"].concat());
        let mut edit = document.edit();
        edit.set(&document.sections()[0].entries[0], "Böhm").unwrap();
        let written = edit.apply().unwrap().to_bytes();
        assert_eq!(written, [comment, b"[FileInfo]\nCreatedBy=", value, b"\n"].concat());
    }
}

#[test]
fn lines_are_added_in_the_manner_of_their_neighbours() {
    let document = document(HARD);
    let [file_info, object] = document.sections() else {
        panic!("two sections")
    };
    let mut edit = document.edit();
    edit.insert_after(&file_info.entries[0], "ModifiedBy", "Böhm").unwrap();
    edit.insert_first(object, "ObjectType", "7").unwrap();
    edit.insert_after(&object.entries[2], "ObjFlags", "0").unwrap();
    edit.insert_after(&object.entries[2], "SubNumber", "1").unwrap();
    edit.remove(&object.entries[0]);
    edit.add_section(
        Some(file_info),
        "DeviceInfo",
        &[("VendorName", "x"), ("LSS_Supported", "0")],
    )
    .unwrap();
    let written = edit.apply().unwrap().to_bytes();
    let expected = [
        &b"; Sch\x94naich\r\n[FileInfo]\r\nCreatedBy = M\x81ller \r\nModifiedBy = B\x94hm\r\nDescription=\r\n"[..],
        b"\r\n[DeviceInfo]\r\nVendorName=x\r\nLSS_Supported=0\r\n",
        b"\t[1017]\nObjectType=7\nDefaultValue=0   \r\n\r\n; L\xC3\xBCfter\r\nHighLimit=0xFFFF\r\nObjFlags=0\r\nSubNumber=1",
    ];
    assert_eq!(
        written.escape_ascii().to_string(),
        expected.concat().escape_ascii().to_string()
    );
}

#[test]
fn sections_are_added_at_the_end_and_taken_out() {
    let text = "[FileInfo]\r\nFileName=x\r\n\r\n[1017]\r\nDataType=6\r\n; why\r\nObjectType=7\r\n\r\n; end\r\n";
    let document = document(text);
    let mut edit = document.edit();
    edit.remove_section(&document.sections()[1]);
    edit.add_section(None, "1018", &[("ObjectType", "9")]).unwrap();
    let edited = edit.apply().unwrap();
    let expected = "[FileInfo]\r\nFileName=x\r\n\r\n\r\n; end\r\n\r\n[1018]\r\nObjectType=9\r\n";
    assert_eq!(String::from_utf8(edited.to_bytes()).unwrap(), expected);
    assert_eq!(edited.sections()[1].name, SectionName::Object(0x1018));
}

#[test]
fn a_section_can_be_added_to_nothing() {
    let document = document("");
    let mut edit = document.edit();
    edit.add_section(None, "FileInfo", &[("FileName", "x.eds")]).unwrap();
    assert_eq!(edit.apply().unwrap().to_bytes(), b"[FileInfo]\nFileName=x.eds\n");
}

#[test]
fn a_byte_order_mark_stays() {
    let document = document("\u{FEFF}[FileInfo]\nFileName=x\n");
    let mut edit = document.edit();
    edit.set(&document.sections()[0].entries[0], "y").unwrap();
    assert_eq!(
        edit.apply().unwrap().to_bytes(),
        "\u{FEFF}[FileInfo]\nFileName=y\n".as_bytes()
    );
}

#[test]
fn text_that_would_not_read_back_is_refused() {
    let document = document("[FileInfo]\nFileName=x\n");
    let section = &document.sections()[0];
    let entry = &section.entries[0];
    let mut edit = document.edit();
    for value in ["a\nb", "a\rb", " a", "a\t", "a\x1A"] {
        let text = value.to_owned();
        assert_eq!(edit.set(entry, value), Err(EditError::Unreadable { text }));
    }
    for key in ["", "a=b", ";a", "#a", "[a", " a"] {
        let text = key.to_owned();
        assert_eq!(edit.insert_after(entry, key, "1"), Err(EditError::Unreadable { text }));
    }
    let text = "a]".to_owned();
    assert_eq!(edit.add_section(None, "a]", &[]), Err(EditError::Unreadable { text }));
    assert_eq!(edit.apply().unwrap().to_bytes(), document.to_bytes());
}

#[test]
fn text_that_the_encoding_has_not_is_refused() {
    let document = document(HARD);
    let entry = document.sections()[0].entry(Keyword::CreatedBy).unwrap();
    for value in ["cos φ", "中"] {
        let mut edit = document.edit();
        edit.set(entry, value).unwrap();
        let error = edit.apply().unwrap_err();
        assert_eq!(
            error.to_string(),
            "line 3 is CP850 and cannot hold this text; write it in ASCII"
        );
    }
}

#[test]
fn two_changes_of_one_value_are_refused() {
    let document = document("[FileInfo]\nDescription=\nFileName=x\n");
    for entry in &document.sections()[0].entries {
        let mut edit = document.edit();
        edit.set(entry, "y").unwrap();
        edit.set(entry, "z").unwrap();
        assert!(matches!(edit.apply(), Err(EditError::Conflict { .. })));
        let mut edit = document.edit();
        edit.set(entry, "y").unwrap();
        edit.remove(entry);
        assert!(matches!(edit.apply(), Err(EditError::Conflict { .. })));
    }
}
