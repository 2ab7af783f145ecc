//! What single lines become, one matter a test.

use lexican_eds::document::{Format, Keyword, Problem, SectionName};
use lexican_eds::source::{Encoding, LineEnd, Source};

use crate::files::document;

/// The problems of a file: the name of each, where it stands, and the text there.
fn problems(bytes: impl Into<Vec<u8>>) -> Vec<String> {
    let document = document(bytes);
    let shown = document.problems().iter().map(|problem| {
        let name = format!("{problem:?}");
        let name = name.split([' ', '{']).next().unwrap_or_default();
        let place = document.source().line_column(problem.span());
        let text = document.text(problem.span());
        format!("{}:{} {name} {text:?}", place.line, place.column)
    });
    shown.collect()
}

#[test]
fn a_clean_file_has_no_problem() {
    let text = "; comment\n[FileInfo]\nFileName=x.eds\n\n[1000]\nParameterName=Device type\n";
    assert_eq!(problems(text), [""; 0]);
}

#[test]
fn lines_that_are_no_entry_are_told_and_passed_over() {
    let text = "[1000]\nParameterName=Device\ntype\n=7\n#ObjectType=9\nObjectType=7\n";
    assert_eq!(
        problems(text),
        [
            r#"3:1 JunkLine "type""#,
            r#"4:1 MissingKeyword "=7""#,
            r##"5:1 HashComment "#ObjectType=9""##
        ]
    );
    let document = document(text);
    let values: Vec<_> = document.sections()[0]
        .entries
        .iter()
        .map(|entry| document.text(entry.value))
        .collect();
    assert_eq!(values, ["Device", "7"]);
}

#[test]
fn a_comment_behind_a_value_is_part_of_it() {
    let document = document("[1005]\nAccessType=rw # rw;\nObjectType=0x07 ; VAR\n");
    let values: Vec<_> = document.sections()[0]
        .entries
        .iter()
        .map(|entry| document.text(entry.value))
        .collect();
    assert_eq!(values, ["rw # rw;", "0x07 ; VAR"]);
}

#[test]
fn headers_are_read_whatever_is_wrong_with_them() {
    let text = "  [1000]\n[1001] # repeat\n[1002\n1003]\n[0x1004]\n[ 1005 ]\n[1018sub01]\n[PreDefines]\n";
    assert_eq!(
        problems(text),
        [
            r#"1:3 IndentedHeader "[1000]""#,
            r##"2:8 TextAfterHeader "# repeat""##,
            r#"3:1 MalformedHeader "[1002""#,
            r#"4:1 MalformedHeader "1003]""#,
            r#"5:2 BadSectionName "0x1004""#,
            r#"6:3 BadSectionName "1005""#,
            r#"7:2 BadSectionName "1018sub01""#,
            r#"8:2 UnknownSection "PreDefines""#,
        ]
    );
    let names: Vec<_> = document(text).sections().iter().map(|section| section.name).collect();
    let objects = (0x1000..=0x1005).map(SectionName::Object);
    let others = [SectionName::Sub(0x1018, 1), SectionName::Unknown];
    assert_eq!(names, objects.chain(others).collect::<Vec<_>>());
}

#[test]
fn what_stands_twice_is_kept_and_told_with_the_first() {
    let text =
        "[1000]\nDataType=7\nObjectType=7\ndatatype=5\nMy=1\nmy=2\n[1001]\n[0x1000]\nDataType=7\n[Mine]\n[MINE]\n";
    let document = document(text);
    let twice = document.problems().iter().filter_map(|problem| match *problem {
        Problem::DuplicateSection { at, first } | Problem::DuplicateKeyword { at, first } => {
            let line = |span| document.source().line_column(span).line;
            Some((line(first), line(at), document.text(at)))
        }
        _ => None,
    });
    let expected = [(2, 4, "datatype"), (5, 6, "my"), (1, 8, "0x1000"), (10, 11, "MINE")];
    assert_eq!(twice.collect::<Vec<_>>(), expected);
    assert_eq!(document.sections().len(), 5);
    let first = document.sections()[0].entry(Keyword::DataType).unwrap();
    assert_eq!(document.text(first.value), "7");
}

#[test]
fn unknown_keywords_are_told_in_known_sections_only() {
    let text = "[1000]\nUnit=mm\n[PreDefines]\nUnit=mm\n";
    assert_eq!(
        problems(text),
        [r#"2:1 UnknownKeyword "Unit""#, r#"3:2 UnknownSection "PreDefines""#]
    );
}

#[test]
fn keywords_before_the_first_section_are_told() {
    assert_eq!(
        problems("DataType=7\n[1000]\n"),
        [r#"1:1 KeywordOutsideSection "DataType""#]
    );
}

#[test]
fn characters_that_an_eds_shall_not_have_are_told_once_a_line() {
    let text = "\u{FEFF}[1000]\nParameterName=Ä, Ö\nDefaultValue=\0\0x\nHighLimit=9\x1A";
    assert_eq!(
        problems(text),
        [
            r#"1:1 ByteOrderMark "[1000]""#,
            r#"2:15 NotAscii "Ä""#,
            r#"3:14 ControlCharacter "\0""#,
            r#"4:12 ControlCharacter "\u{1a}""#,
        ]
    );
    let document = document(text);
    let last = document.sections()[0].entries.last().unwrap();
    assert_eq!(document.text(last.value), "9");
}

#[test]
fn a_pair_may_have_255_characters() {
    let value = "é".repeat(255 - "ParameterName=".len());
    let fits = format!("[1000]\nParameterName={value}\n");
    assert!(!problems(fits).iter().any(|problem| problem.contains("Overlong")));
    let document = document(format!("[1000]\n  ParameterName={value}x  \n"));
    let overlong = document.problems().iter().find_map(|problem| match *problem {
        Problem::OverlongLine { at, characters } => Some((document.source().line_column(at).column, characters)),
        _ => None,
    });
    assert_eq!(overlong, Some((3, 256)));
}

#[test]
fn lines_may_end_as_they_like_and_the_first_other_end_is_told() {
    for end in ["\n", "\r\n", "\r"] {
        let text = ["[1000]", "; comment", "DataType=7", "", "ObjectType=7"].join(end);
        assert_eq!(problems(text.as_str()), [""; 0]);
        let document = document(text);
        assert_eq!(document.sections()[0].entries.len(), 2);
        assert_eq!(document.source().line_count(), 5);
        assert_eq!(document.source().line_text(3), "DataType=7");
    }
    let mixed = "[1000]\r\nDataType=7\nObjectType=7\r\r\n";
    assert_eq!(problems(mixed), [r#"2:1 MixedLineEnds "DataType=7""#]);
    let source = Source::decode("x", mixed.into());
    let ends: Vec<_> = (1..=5).map(|line| source.line_end(line)).collect();
    assert_eq!(
        ends,
        [LineEnd::CrLf, LineEnd::Lf, LineEnd::Cr, LineEnd::CrLf, LineEnd::None]
    );
}

#[test]
fn encodings_are_decided_line_by_line() {
    let bytes = b"[1000]\nParameterName=L\x81fter\nDenotation=L\xFCfter\nDefaultValue=L\xC3\xBCfter\n";
    let document = document(&bytes[..]);
    let values: Vec<_> = document.sections()[0]
        .entries
        .iter()
        .map(|entry| document.text(entry.value))
        .collect();
    assert_eq!(values, ["Lüfter"; 3]);
    let encodings: Vec<_> = (1..=4).map(|line| document.source().encoding(line)).collect();
    assert_eq!(
        encodings,
        [Encoding::Utf8, Encoding::Cp850, Encoding::Windows1252, Encoding::Utf8]
    );
    assert_eq!(document.to_bytes(), bytes);
}

#[test]
fn places_are_lines_and_columns_of_characters() {
    let document = document("[1000]\r\nParameterName=Ä=ö\r\n");
    let entry = document.sections()[0].entries[0];
    let place = document.source().line_column(entry.value);
    assert_eq!((place.line, place.column), (2, 15));
    let after = lexican_eds::span::Span::new(entry.value.end, entry.value.end);
    assert_eq!(document.source().line_column(after).column, 18);
}

#[test]
fn other_files_are_named() {
    let utf16: Vec<u8> = "[FileInfo]\r\nFileName=x\r\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let marked: Vec<u8> = [&b"\xFF\xFE"[..], &utf16].concat();
    let swapped: Vec<u8> = utf16.chunks(2).flat_map(|pair| [pair[1], pair[0]]).collect();
    for (bytes, format) in [
        (b"".to_vec(), Format::Empty),
        (b" \r\n\t\x1A\0\0".to_vec(), Format::Empty),
        (b"\xEF\xBB\xBF".to_vec(), Format::Empty),
        (utf16, Format::Utf16),
        (marked, Format::Utf16),
        (swapped, Format::Utf16),
        (b"PK\x03\x04\x14\0\x06\0\x08\0\0\0!\0".to_vec(), Format::Binary),
        (
            b"<?xml version=\"1.0\"?><ISO15745Profile xmlns=\"http://www.canopen.org/xml/1.0\"/>".to_vec(),
            Format::CanopenXml,
        ),
        (
            b"\xEF\xBB\xBF\n <a xmlns='http://www.ethernet-powerlink.org'/>".to_vec(),
            Format::PowerlinkXml,
        ),
        (b"<!DOCTYPE html><html>404 Not Found</html>".to_vec(), Format::Html),
        (b"<svg/>".to_vec(), Format::Xml),
        (
            b"$ EDS\n[File]\nDescText = \"x\";\n[Device]\nVendCode = 1;\n".to_vec(),
            Format::Odva,
        ),
        (b"[package]\nname = \"x\"\n".to_vec(), Format::Ini),
        (b"Dear reader,\nthis is a letter.\n".to_vec(), Format::Text),
    ] {
        let document = document(bytes.clone());
        assert!(document.sections().is_empty());
        let [Problem::NotCanopen { what, .. }] = document.problems() else {
            panic!("{format:?}: {:?}", document.problems());
        };
        assert_eq!(*what, format);
        assert_eq!(document.to_bytes(), bytes);
    }
}
