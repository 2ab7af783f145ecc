//! The encoder's EDS becomes `OUT_DIR/wdga.rs`.

fn main() -> Result<(), lexican_codegen::Error> {
    lexican_codegen::Builder::new("../../eds/devices/wdga.eds")
        .handle([0x6003]) // the objects that the application answers for
        .generate()?
        .write_to_out_dir()
}
