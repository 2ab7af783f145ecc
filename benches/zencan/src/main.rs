//! zencan-node 0.0.5, with a critical section that does nothing: there is but one thread.

#[path = "../../harness.rs"]
mod harness;

mod bench_100 {
    zencan_node::include_modules!(BENCH_100);
}
mod bench_1000 {
    zencan_node::include_modules!(BENCH_1000);
}

use std::hint::black_box;

use zencan_node::{
    Callbacks, Node, NodeMbox,
    common::{
        NodeId,
        messages::{CanId, CanMessage},
    },
    object_dict::{ODEntry, find_object},
};

struct Nothing;
critical_section::set_impl!(Nothing);

// SAFETY: there is but one thread, and no interrupt.
unsafe impl critical_section::Impl for Nothing {
    unsafe fn acquire() -> critical_section::RawRestoreState {}
    unsafe fn release(_: critical_section::RawRestoreState) {}
}

fn main() {
    let (operation, large, n) = harness::arguments();
    let id = NodeId::new(0x10).unwrap();
    if large {
        use bench_1000::{NODE_MBOX, NODE_STATE, OD_TABLE};
        run(
            Node::new(id, Callbacks::default(), &NODE_MBOX, &NODE_STATE, &OD_TABLE),
            &NODE_MBOX,
            &OD_TABLE,
            &operation,
            n,
        );
    } else {
        use bench_100::{NODE_MBOX, NODE_STATE, OD_TABLE};
        run(
            Node::new(id, Callbacks::default(), &NODE_MBOX, &NODE_STATE, &OD_TABLE),
            &NODE_MBOX,
            &OD_TABLE,
            &operation,
            n,
        );
    }
}

fn run(mut node: Node<'_>, mbox: &NodeMbox, table: &'static [ODEntry<'static>], operation: &str, n: u32) {
    node.process(0);
    while mbox.next_transmit_message().is_some() {}
    match operation {
        "lookup" => {
            for _ in 0..n {
                black_box(find_object(black_box(table), black_box(0x6004))).unwrap();
            }
        }
        "idle" => {
            for _ in 0..n {
                black_box(node.process(black_box(1)));
                assert!(black_box(mbox.next_transmit_message()).is_none());
            }
        }
        "tpdo_on_sync" => {
            let mut exchange = |id, data: &[u8]| {
                mbox.store_message(CanMessage::new(CanId::std(id), data)).ok()?;
                node.process(1);
                mbox.next_transmit_message()
            };
            // The dictionary of the other stacks has this mapping; zencan-build has no place for it.
            for request in harness::MAPPING {
                let response = exchange(0x610, &request).expect("a response");
                assert_eq!(response.data()[0], 0x60, "{request:02X?} was refused");
            }
            harness::sync_all(n, exchange);
        }
        "harness" => harness::absent(),
        _ => harness::exchange_all(
            operation,
            n,
            |frame: &CanMessage| frame.data()[0],
            |id, data| {
                mbox.store_message(CanMessage::new(CanId::std(id), &data)).unwrap();
                node.process(1);
                mbox.next_transmit_message()
            },
        ),
    }
}
