//! Files that nobody wrote: random bytes, damaged real files, extremes.

use lexican_eds::document::Document;
use lexican_eds::span::Span;

use crate::files::{Random, document, real_eds};

/// What holds for every file.
fn assert_sound(bytes: &[u8]) {
    let document = document(bytes);
    assert!(
        document.to_bytes() == bytes,
        "not written back: {:?}",
        bytes.escape_ascii().to_string()
    );
    let mut end = 0;
    let mut after = |span: Span| {
        assert!(end <= span.start && span.start <= span.end, "{span:?} is out of order");
        end = span.end;
        assert_eq!(document.text(span).len(), span.len(), "{span:?} is not in the text");
    };
    for section in document.sections() {
        assert!(document.text(section.header).contains(document.text(section.label)));
        after(section.header);
        for entry in &section.entries {
            after(entry.key);
            assert!(document.text(Span::new(entry.key.end, entry.value.start)).contains('='));
            after(entry.value);
        }
    }
    for problem in document.problems() {
        assert_eq!(document.text(problem.span()).len(), problem.span().len());
        let _ = document.source().line_column(problem.span());
    }
}

#[test]
fn random_bytes_are_read_and_written_back() {
    let mut random = Random::new(1);
    for _ in 0..2_000 {
        let length = random.below(200);
        let bytes: Vec<u8> = (0..length).map(|_| random.byte()).collect();
        assert_sound(&bytes);
    }
}

#[test]
fn random_pieces_of_eds_are_read_and_written_back() {
    const PIECES: [&[u8]; 32] = [
        b"[",
        b"]",
        b"[1000]",
        b"[1018sub1]",
        b"[FileInfo]",
        b"=",
        b"==",
        b"ParameterName",
        b"DataType=0x7",
        b"1=0x1000",
        b";",
        b"#",
        b"\n",
        b"\r",
        b"\r\n",
        b"\n\n",
        b" ",
        b"\t",
        b"\\",
        b"\\\n",
        b":",
        b"\"",
        b"'",
        b"\0",
        b"\x1A",
        b"\xEF\xBB\xBF",
        b"\x84",
        b"\xFC",
        b"\xC3\xBC",
        b"\xC2\xA0",
        b"\xC2\x85",
        b"\xE2\x80\xA8",
    ];
    let mut random = Random::new(2);
    for _ in 0..6_000 {
        let count = random.below(24);
        let bytes: Vec<u8> = (0..count).flat_map(|_| random.pick(&PIECES)).copied().collect();
        assert_sound(&bytes);
        assert_sound(&[b"[FileInfo]\n", &bytes[..]].concat());
    }
}

#[test]
fn damaged_real_files_are_read_and_written_back() {
    let mut random = Random::new(3);
    for file in real_eds().filter(|file| file.bytes.len() < 20_000).take(60) {
        for _ in 0..4 {
            let mut bytes = file.bytes.clone();
            for _ in 0..=random.below(20) {
                damage(&mut bytes, &mut random);
            }
            assert_sound(&bytes);
        }
    }
}

fn damage(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len().max(1));
    match random.below(4) {
        0 => bytes.truncate(at),
        1 if at < bytes.len() => drop(bytes.remove(at)),
        2 => bytes.insert(at.min(bytes.len()), random.byte()),
        _ => bytes.extend_from_within(at.min(bytes.len())..(at + 30).min(bytes.len())),
    }
}

#[test]
fn extremes_take_no_more_than_their_size() {
    const MANY: usize = 20_000;
    for bytes in [
        b"[1000]\n".repeat(MANY),
        b"[FileInfo\r".repeat(MANY),
        [&b"[1000]\n"[..], &b"DataType=7\n".repeat(MANY)].concat(),
        [&b"[1000]\n"[..], &b"x=".repeat(MANY)].concat(),
        [&b"[1000]\n"[..], &b"\\=\\\n".repeat(MANY)].concat(),
        [&b"[1000]\r"[..], &b"a=1\r".repeat(MANY)].concat(),
        b"[".repeat(MANY),
        b"\xFF\n".repeat(MANY),
        [&b"[1000]\nParameterName="[..], &b"x".repeat(20 * MANY)].concat(),
        (0..MANY)
            .flat_map(|number| format!("[x{number}]\ny{number}=1\n").into_bytes())
            .collect(),
    ] {
        assert_sound(&bytes);
    }
}

#[test]
fn a_default_document_is_an_empty_one() {
    assert!(Document::default().sections().is_empty());
    assert!(Document::default().to_bytes().is_empty());
}
