//! Every telegram with SDO bytes that the encoders' manuals print, held with the devices that are generated from their
//! EDS files, with devices simulated from the same, and with the virtual WDGA.

use std::{fs, path::Path};

use lexican_runtime::Device;
use lexican_tests::{
    bus::Bus,
    dialogue::{self, Summary},
    encoder,
    generated::{wdga, wv58mr},
    memory::Memory,
    simulated::Simulated,
};

fn hold<D: Device>(name: &str, device: impl Fn() -> D) -> Summary {
    dialogue::hold(&dialogues(name), |node_id| Bus::booted(device(), node_id))
}

fn dialogues(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("dialogues/{name}.txt"));
    fs::read_to_string(file).expect("the dialogues")
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
    let text = dialogues("wdga");
    let virtual_encoder = |node_id| encoder::booted_wdga(node_id, Memory::flash(4096));
    assert_eq!(dialogue::hold(&text, virtual_encoder), all);
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
