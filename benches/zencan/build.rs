//! `zencan-build` generates the dictionaries, from TOML: the EDS is written as such first.

mod config;
#[path = "../eds.rs"]
mod eds;

use std::path::Path;

fn main() {
    let out = std::env::var("OUT_DIR").unwrap();
    for (name, label) in [("bench_100", "BENCH_100"), ("bench_1000", "BENCH_1000")] {
        let toml = Path::new(&out).join(format!("{name}.toml"));
        std::fs::write(&toml, config::config(&format!("../../../shared/bench/{name}.eds"))).unwrap();
        zencan_build::build_node_from_device_config(label, &toml).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
