//! The dictionaries.

#[path = "../dictionary.rs"]
mod dictionary;
#[path = "../eds.rs"]
mod eds;

fn main() {
    let out = std::path::PathBuf::from(std::env::var_os("OUT_DIR").unwrap());
    for name in ["bench_100", "bench_1000"] {
        let entries = eds::read(&format!("../../../shared/bench/{name}.eds"));
        std::fs::write(out.join(format!("{name}.rs")), dictionary::generate(entries)).unwrap();
    }
}
