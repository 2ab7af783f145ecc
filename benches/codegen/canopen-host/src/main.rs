//! Generates as a build script with `canopen-host` does.

#[path = "../../best.rs"]
mod best;

use canopen_host::{codegen::generate_object_dictionary, eds::Eds};

fn main() {
    let (file, out) = best::arguments();
    best::best(|| {
        let eds = Eds::from_file(&file).expect("an EDS");
        std::fs::write(
            out.join("bench_1000.rs"),
            generate_object_dictionary(&eds, "dictionary"),
        )
        .expect("OUT_DIR");
    });
}
