//! The shortest of five runs.

use std::time::Instant;

/// Runs `generate` five times and prints the shortest in milliseconds.
pub fn best(mut generate: impl FnMut()) {
    let times = (0..5).map(|_| {
        let start = Instant::now();
        generate();
        start.elapsed().as_secs_f64() * 1000.0
    });
    println!("{:.0}", times.fold(f64::INFINITY, f64::min));
}

/// The EDS file, and the folder that a build script would write into.
pub fn arguments() -> (String, std::path::PathBuf) {
    let file = std::env::args().nth(1).expect("an EDS file");
    (file, std::env::var_os("OUT_DIR").expect("OUT_DIR").into())
}
