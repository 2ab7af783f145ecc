//! Every telegram with SDO bytes that the encoders' manuals print, held with devices of their EDS files.

use std::{fs, path::Path};

use lexican_tests::{
    bus::Bus,
    dialogue::{self, Summary},
    simulated::Simulated,
};

fn hold(name: &str) -> Summary {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let eds = fs::read(root.join(format!("../eds/devices/{name}.eds"))).expect("the device's file");
    let device = Simulated::of(&lexican_eds::read(name, eds).dictionary);
    let text = fs::read_to_string(root.join(format!("dialogues/{name}.txt"))).expect("its dialogues");
    dialogue::hold(&text, |node_id| Bus::booted(device.clone(), node_id))
}

#[test]
fn the_telegrams_of_the_wdga() {
    assert_eq!(hold("wdga"), Summary { held: 27, later: 2 });
}

#[test]
fn the_telegrams_of_the_wv58mr() {
    assert_eq!(hold("wv58mr"), Summary { held: 6, later: 2 });
}
