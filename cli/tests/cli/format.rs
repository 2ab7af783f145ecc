//! `lexican format`

use std::fs;

use crate::lexican::Lexican;

const LOOSE: &[u8] = b"; a pump\r\n\r\n[1000]\r\ndatatype = 0x7\r\n; its name\r\nParameterName=Device type\r\n[FileInfo]\r\nFileName=a.eds\r\n";
const CANONICAL: &[u8] = b"; a pump\r\n\r\n[FileInfo]\r\nFileName=a.eds\r\n\r\n[1000]\r\n; its name\r\nParameterName=Device type\r\nDataType=0x0007\r\n";

fn both() -> Lexican {
    Lexican::with(&[("loose.eds", LOOSE), ("canonical.eds", CANONICAL)])
}

fn read(lexican: &Lexican, name: &str) -> Vec<u8> {
    fs::read(lexican.path().join(name)).unwrap()
}

#[test]
fn a_file_is_written_in_its_canonical_form_and_then_left_alone() {
    let lexican = both();
    let ran = lexican.run(&["format", "loose.eds", "canonical.eds"]);
    let said = (ran.code, ran.stdout.as_str(), ran.stderr.as_str());
    assert_eq!(said, (Some(0), "", "note: loose.eds is in its canonical form now\n"));
    assert_eq!(read(&lexican, "loose.eds"), CANONICAL);
    assert_eq!(read(&lexican, "canonical.eds"), CANONICAL);
    assert_eq!(lexican.run(&["format", "."]).printed(0), "");
}

#[test]
fn check_names_what_is_not_canonical_and_changes_nothing() {
    let lexican = both();
    let ran = lexican.run(&["format", "--check", "loose.eds", "canonical.eds"]);
    let said = (ran.code, ran.stdout.as_str(), ran.stderr.as_str());
    assert_eq!(said, (Some(1), "", "note: loose.eds is not in its canonical form\n"));
    assert_eq!(read(&lexican, "loose.eds"), LOOSE);
    assert_eq!(lexican.run(&["format", "--check", "canonical.eds"]).printed(0), "");
}

#[test]
fn diff_shows_what_would_change() {
    let lexican = both();
    let ran = lexican.run(&["format", "--diff", "loose.eds"]);
    assert_eq!(
        (ran.code, ran.stderr.as_str()),
        (Some(1), "note: one file is not in its canonical form\n")
    );
    assert!(ran.stdout.contains("\n-datatype = 0x7\r\n"), "{}", ran.stdout);
    assert_eq!(read(&lexican, "loose.eds"), LOOSE);
}

#[test]
fn standard_input_is_formatted_to_standard_output() {
    let ran = both().run_with_input(&["format", "-"], LOOSE);
    assert_eq!(ran.printed(0).as_bytes(), CANONICAL);
}

#[test]
fn what_is_no_description_is_left_alone() {
    let lexican = Lexican::with(&[("page.eds", b"<html></html>")]);
    assert!(
        lexican
            .run(&["format", "page.eds"])
            .failed()
            .contains("page.eds is no EDS")
    );
    assert_eq!(read(&lexican, "page.eds"), b"<html></html>");
}
