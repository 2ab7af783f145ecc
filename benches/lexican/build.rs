//! `lexican-codegen` generates the dictionaries.

fn main() -> Result<(), lexican_codegen::Error> {
    for name in ["bench_100", "bench_1000"] {
        lexican_codegen::Builder::new(format!("../../../shared/bench/{name}.eds"))
            .capacity(0x2101, 4096)
            .generate()?
            .write_to_out_dir()?;
    }
    Ok(())
}
