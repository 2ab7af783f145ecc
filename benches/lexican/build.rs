//! `lexican-codegen` generates the dictionaries.

fn main() -> Result<(), lexican_codegen::Error> {
    for name in ["bench_100", "bench_1000"] {
        lexican_codegen::compile(format!("../../../shared/bench/{name}.eds"))?;
    }
    Ok(())
}
