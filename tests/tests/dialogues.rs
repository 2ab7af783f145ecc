//! Every telegram with SDO bytes that the encoders' manuals print, held with the devices that are generated from their
//! EDS files, and with devices simulated from the same.

use std::{fs, path::Path};

use lexican_runtime::Device;
use lexican_tests::{
    bus::Bus,
    dialogue::{self, Summary},
    generated::{wdga, wv58mr},
    memory::Memory,
    simulated::Simulated,
};

fn hold<D: Device>(name: &str, device: impl Fn() -> D) -> Summary {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("dialogues/{name}.txt"));
    let text = fs::read_to_string(file).expect("the dialogues");
    dialogue::hold(&text, |node_id| Bus::booted(device(), node_id))
}

fn simulated(name: &str) -> Simulated {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../eds/devices/{name}.eds"));
    let eds = lexican_eds::read(name, fs::read(file).expect("the device's file"));
    Simulated::of(&eds.dictionary).with_memory(&Memory::eeprom(4096))
}

#[test]
fn the_telegrams_of_the_wdga() {
    let all = Summary { held: 34, later: 0 };
    assert_eq!(
        hold("wdga", || wdga::Device::with_storage((), Memory::flash(4096))),
        all
    );
    assert_eq!(hold("wdga", || simulated("wdga")), all);
}

#[test]
fn the_telegrams_of_the_wv58mr() {
    let all = Summary { held: 20, later: 0 };
    assert_eq!(
        hold("wv58mr", || wv58mr::Device::with_storage((), Memory::flash(4096))),
        all
    );
    assert_eq!(hold("wv58mr", || simulated("wv58mr")), all);
}
