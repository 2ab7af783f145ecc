//! The encoder's EDS becomes `OUT_DIR/wdga.rs`.

use lexican_eds::devices;

fn main() -> Result<(), lexican_codegen::Error> {
    lexican_codegen::Builder::from_bytes("wdga.eds", devices::WDGA)
        // What a singleturn encoder has in another way.
        .handle_reads([0x1000, 0x1008, 0x6502])
        // What is more than stored, or may not be written at any time.
        .handle_writes([0x2100, 0x2101, 0x2120, 0x6000, 0x6001, 0x6002, 0x6003, 0x6009])
        .handle_writes([(0x2504, 0)])
        .capacity(0x1009, 16)
        .capacity(0x100A, 16)
        .generate()?
        .write_to_out_dir()
}
