//! The dictionary, and where the memory is.

fn main() -> Result<(), Box<dyn std::error::Error>> {
    lexican_codegen::compile("../../../shared/bench/bench_enc.eds")?;
    let out = std::path::PathBuf::from(std::env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    std::fs::write(out.join("memory.x"), include_bytes!("memory.x"))?;
    println!("cargo:rustc-link-search={}", out.display());
    Ok(())
}
