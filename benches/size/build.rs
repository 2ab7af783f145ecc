//! The dictionary, and where the memory is.

use std::{env, error::Error, fs, path::PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-env-changed=DICTIONARY");
    let dictionary = env::var("DICTIONARY").unwrap_or_else(|_| "bench_enc".to_owned());
    lexican_codegen::Builder::new(format!("../../../shared/bench/{dictionary}.eds"))
        .module_name("dictionary")
        .generate()?
        .write_to_out_dir()?;
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    fs::write(out.join("memory.x"), include_bytes!("memory.x"))?;
    println!("cargo:rustc-link-search={}", out.display());
    Ok(())
}
