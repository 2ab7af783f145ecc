//! canopen-rs 0.6.1.

#[path = "../../harness.rs"]
mod harness;

mod bench_100 {
    include!(concat!(env!("OUT_DIR"), "/bench_100.rs"));
}
mod bench_1000 {
    include!(concat!(env!("OUT_DIR"), "/bench_1000.rs"));
}

use std::hint::black_box;

use canopen_rs::{
    Address, NodeId, ObjectDictionary,
    node::{Node, TxFrame},
};

fn main() {
    let (operation, large, n) = harness::arguments();
    if large {
        run(bench_1000::dictionary(), &operation, n);
    } else {
        run(bench_100::dictionary(), &operation, n);
    }
}

fn run<const N: usize>(dictionary: ObjectDictionary<N>, operation: &str, n: u32) {
    let mut node = Node::new(NodeId::new(0x10).unwrap(), dictionary);
    black_box(node.boot());
    match operation {
        "lookup" => {
            for _ in 0..n {
                black_box(node.od().entry(black_box(Address::new(0x6004, 0)))).unwrap();
            }
        }
        "tpdo_on_sync" => {
            node.configure_pdos_from_od();
            harness::sync_all(n, |id, data| {
                // A SYNC is the caller's to know.
                if id == 0x080 {
                    return node.sync_tpdos().first().copied();
                }
                node.on_frame(id, data)
            });
        }
        "harness" | "idle" => harness::absent(),
        _ => harness::exchange_all(
            operation,
            n,
            |frame: &TxFrame| frame.data()[0],
            |id, data| node.on_frame(id, &data),
        ),
    }
}
