//! Generates as a build script with `zencan-build` does, from the TOML that the EDS was written as before.

#[path = "../../best.rs"]
mod best;
#[path = "../../../zencan/config.rs"]
mod config;
#[path = "../../../eds.rs"]
mod eds;

fn main() {
    let (file, out) = best::arguments();
    let toml = out.join("bench_1000.toml");
    std::fs::write(&toml, config::config(&file)).expect("OUT_DIR");
    best::best(|| {
        zencan_build::build_node_from_device_config("BENCH_1000", &toml).expect("code");
    });
}
