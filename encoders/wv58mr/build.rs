//! The encoder's EDS becomes `OUT_DIR/wv58mr.rs`.

/// What the application checks or acts upon when a client writes it.
const WRITES: [u16; 16] = [
    0x1005, 0x1014, 0x1017, 0x1800, 0x1801, 0x2001, 0x2002, 0x5F0A, 0x6000, 0x6001, 0x6002, 0x6003, 0x6031, 0x6200,
    0x6401, 0x6402,
];
/// What is constant in the EDS, and not the same in all variants: it becomes a field.
const FIELDS: [u16; 2] = [0x1000, 0x1008];

fn main() -> Result<(), lexican_codegen::Error> {
    lexican_codegen::Builder::from_bytes("wv58mr.eds", lexican_eds::devices::WV58MR)
        .handle_writes(WRITES)
        .handle_reads(FIELDS)
        .generate()?
        .write_to_out_dir()
}
