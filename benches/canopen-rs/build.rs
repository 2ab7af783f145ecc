//! `canopen-host` generates the dictionaries.

use canopen_host::{codegen::generate_object_dictionary, eds::Eds};

fn main() {
    let out = std::path::PathBuf::from(std::env::var_os("OUT_DIR").unwrap());
    for name in ["bench_100", "bench_1000"] {
        let file = format!("../../../shared/bench/{name}.eds");
        println!("cargo:rerun-if-changed={file}");
        let eds = Eds::from_file(&file).unwrap_or_else(|error| panic!("{file}: {error:?}"));
        std::fs::write(
            out.join(format!("{name}.rs")),
            generate_object_dictionary(&eds, "dictionary"),
        )
        .unwrap();
    }
}
