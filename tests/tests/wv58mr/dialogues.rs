//! Every telegram with SDO or LSS bytes that the manual prints, in its order.

use std::{fs, path::Path};

use lexican_tests::dialogue::{self, Summary};

use crate::device;

#[test]
fn the_telegrams_of_the_manual_are_those_of_the_virtual_encoder() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("dialogues/wv58mr.txt");
    let text = fs::read_to_string(file).expect("the dialogues");
    let summary = dialogue::hold(&text, |_| device::delivered().0);
    assert_eq!(summary, Summary { held: 20, later: 0 });
}
