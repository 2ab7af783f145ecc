//! The full circle over the real files that lie beside the repository: simulated, dumped, validated. A device made of its file
//! differs from it only where the file contradicts itself.

use std::{collections::BTreeMap, fmt::Write as _};

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    ir::NodeId,
    rules::{self, Levels},
};
use lexican_tests::{
    bus::Bus,
    corpus::{CorpusFile, corpus},
    sdo_client,
    simulated::{Simulated, complete},
};

/// What is found in the device that is simulated from `reading`.
fn circle(reading: &Reading) -> Vec<Diagnostic> {
    let commissioned = reading
        .dictionary
        .commissioning
        .as_ref()
        .and_then(|commissioning| commissioning.node_id);
    let node_id = commissioned.map_or(1, NodeId::get);
    let mut bus = Bus::booted(Simulated::of(&complete(&reading.dictionary)), node_id);
    let addresses = reading.dictionary.entries().map(|entry| entry.address);
    let dump = sdo_client::dump(&mut bus, addresses);
    rules::validate(reading, &dump, &Levels::default())
}

#[test]
fn a_device_made_of_a_real_file_differs_from_it_only_where_the_file_contradicts_itself() {
    let Some(files) = corpus("files") else { return };
    let mut report = String::new();
    let mut devices = 0;
    for CorpusFile { name, bytes, .. } in files {
        let reading = lexican_eds::read(name.clone(), bytes);
        if reading.dictionary.objects.is_empty() {
            continue;
        }
        devices += 1;
        let found = circle(&reading);
        let mut counts: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for diagnostic in &found {
            counts
                .entry(diagnostic.code.as_str())
                .or_default()
                .push(&diagnostic.message);
        }
        for (code, messages) in counts {
            let _ = writeln!(report, "{name}: {} × {code}: {}", messages.len(), messages[0]);
        }
    }
    insta::assert_snapshot!(format!("{devices} devices\n\n{report}"));
}
