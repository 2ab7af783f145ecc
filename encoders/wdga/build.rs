//! The encoder's EDS becomes `OUT_DIR/wdga.rs`.

use lexican_eds::devices;

fn main() -> Result<(), lexican_codegen::Error> {
    lexican_codegen::Builder::from_bytes("wdga.eds", devices::WDGA)
        // What a singleturn encoder has in another way.
        .handle_reads([0x1000, 0x1008, 0x6502])
        // What is more than stored, or may not be written at any time.
        .handle_writes([0x2100, 0x2101, 0x2120, 0x6000, 0x6001, 0x6002, 0x6003, 0x6009])
        .handle_writes([(0x2504, 0)])
        .handle_writes((0x1800..=0x1803).flat_map(|index| [(index, 1), (index, 2), (index, 5)]))
        .handle_writes(0x1A00..=0x1A03)
        .handle_writes(cams())
        .capacity(0x1009, 16)
        .capacity(0x100A, 16)
        .generate()?
        .write_to_out_dir()
}

/// Enable and polarity registers, low limits, high limits, hystereses.
fn cams() -> impl Iterator<Item = u16> {
    [0x6301, 0x6302]
        .into_iter()
        .chain(0x6310..=0x6317)
        .chain(0x6320..=0x6327)
        .chain(0x6330..=0x6337)
}
