//! The dictionary, and where the memory is.

#[path = "../dictionary.rs"]
mod dictionary;
#[path = "../eds.rs"]
mod eds;

fn main() {
    let out = std::path::PathBuf::from(std::env::var_os("OUT_DIR").unwrap());
    let entries = eds::read("../../../shared/bench/bench_enc.eds");
    std::fs::write(out.join("dictionary.rs"), dictionary::generate(entries)).unwrap();
    std::fs::write(out.join("memory.x"), include_bytes!("memory.x")).unwrap();
    println!("cargo:rustc-link-search={}", out.display());
}
