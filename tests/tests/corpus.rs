//! Reads every real file there is, and pins what each gives: objects, values, and what was stumbled over.

use std::collections::BTreeMap;
use std::fmt::Debug;

use lexican_eds::{Reading, document, model};
use lexican_tests::corpus::{CorpusFile, corpus};

#[test]
fn every_file_of_the_corpus_reads_as_it_did() {
    let Some(files) = corpus("files") else { return };
    insta::assert_snapshot!("corpus", table(files));
}

#[test]
fn a_file_of_another_format_is_told_so_and_nothing_else() {
    let Some(mut files) = corpus("not-canopen") else { return };
    files.extend(corpus("files").into_iter().flatten().filter(CorpusFile::is_xml));
    assert_eq!(files.len(), 33);
    for file in files {
        let reading = lexican_eds::read(file.name, file.bytes);
        let name = reading.document.source().name();
        let [document::Problem::NotCanopen { .. }] = reading.document.problems() else {
            panic!("{name}: {:?}", reading.document.problems());
        };
        assert!(reading.dictionary.objects.is_empty(), "{name}");
        assert!(
            reading.eds.problems().is_empty() && reading.problems.is_empty(),
            "{name}"
        );
    }
}

/// A line for each file: its name, how many objects and values it has, and how often it gave which problem.
fn table(files: Vec<CorpusFile>) -> String {
    files.into_iter().map(line).collect()
}

fn line(file: CorpusFile) -> String {
    let reading = lexican_eds::read(file.name.as_str(), file.bytes);
    let objects = reading.dictionary.objects.len();
    let values = reading.dictionary.entries().count();
    let problems = problems(&reading)
        .into_iter()
        .map(|(kind, count)| format!(" {kind} {count}"));
    let problems: String = problems.collect();
    format!("{} | {objects} | {values} |{problems}\n", file.name)
}

fn problems(reading: &Reading) -> BTreeMap<String, usize> {
    let of_document = reading.document.problems().iter().map(kind);
    let of_model = reading.eds.problems().iter().map(model_kind);
    let of_dictionary = reading.problems.iter().map(kind);
    let mut counts = BTreeMap::new();
    for kind in of_document.chain(of_model).chain(of_dictionary) {
        *counts.entry(kind).or_default() += 1;
    }
    counts
}

fn model_kind(problem: &model::Problem) -> String {
    match problem {
        model::Problem::Unreadable { keyword, fault, .. } => format!("{keyword:?}:{fault:?}"),
        model::Problem::Unusual { note, .. } => kind(note),
        other => kind(other),
    }
}

/// The name of an enum's variant.
fn kind(problem: &impl Debug) -> String {
    let text = format!("{problem:?}");
    let name = text.split([' ', '{', '(']).next();
    name.unwrap_or_default().to_owned()
}
