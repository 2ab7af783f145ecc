//! Any traffic: a generated device, which the compiler knows all about, says what a device of the same EDS says that is put
//! together at run time; and both go on serving.

#![no_main]

use std::sync::LazyLock;

use lexican_tests::{generated::wdga, memory::Memory, simulated::Simulated, traffic};
use libfuzzer_sys::fuzz_target;

static SIMULATED: LazyLock<Simulated> = LazyLock::new(|| {
    let bytes = include_bytes!("../../eds/devices/wdga.eds").to_vec();
    Simulated::of(&lexican_eds::read("wdga.eds", bytes).dictionary)
});

fuzz_target!(|bytes: &[u8]| {
    let steps = traffic::steps(bytes);
    assert_eq!(
        traffic::play(wdga::Device::with_storage((), Memory::flash(0x1000)), &steps),
        traffic::play(SIMULATED.clone().with_memory(&Memory::flash(0x1000)), &steps)
    );
});
