//! Generates as a build script with `lexican-codegen` does.

#[path = "../../best.rs"]
mod best;

fn main() {
    let (file, out) = best::arguments();
    best::best(|| {
        let generated = lexican_codegen::Builder::new(&file).generate().expect("code");
        std::fs::write(out.join("bench_1000.rs"), generated.source()).expect("OUT_DIR");
    });
}
