//! Lexican.

#[path = "../../harness.rs"]
mod harness;

include!(concat!(env!("OUT_DIR"), "/bench_100.rs"));
include!(concat!(env!("OUT_DIR"), "/bench_1000.rs"));

use std::{cell::RefCell, hint::black_box};

use lexican_runtime::{Address, CanId, Device, Frame, Instant, Node, NodeId, od};

fn main() {
    let (operation, large, n) = harness::arguments();
    if large {
        run(bench_1000::Device::new(()), &operation, n);
    } else {
        run(bench_100::Device::new(()), &operation, n);
    }
}

fn run<D: Device>(device: D, operation: &str, n: u32) {
    let mut node = Node::new(device, NodeId::new(0x10).unwrap());
    let now = Instant::from_micros(1);
    black_box(node.poll(now)).unwrap();
    match operation {
        "lookup" => {
            for _ in 0..n {
                let entry = node.device().table().find(black_box(Address::new(0x6004, 0)));
                black_box(entry.map(|entry| entry.slot)).unwrap();
            }
        }
        "idle" => {
            for _ in 0..n {
                assert!(black_box(node.poll(black_box(now))).is_none());
            }
        }
        "tpdo_on_sync" => harness::sync_all(n, |id, data| {
            let frame = black_box(Frame::new(CanId::standard(id.into())?, data)?);
            node.receive(black_box(now), &frame);
            node.poll(black_box(now))
        }),
        "block_upload_4k" => {
            od::set(node.device_mut(), Address::new(0x2101, 0), &harness::domain()).unwrap();
            node.poll(now);
            let node = RefCell::new(node);
            harness::block_upload_all(
                n,
                |frame: &Frame| frame.word().to_le_bytes(),
                |id, data| {
                    let frame = black_box(frame(id, data).unwrap());
                    node.borrow_mut().receive(black_box(now), &frame);
                },
                || node.borrow_mut().poll(black_box(now)),
            );
        }
        // What sending the frames to nobody costs.
        "harness" => harness::exchange_all(operation, n, command, |id, data| frame(id, data)),
        _ => harness::exchange_all(operation, n, command, |id, data| {
            let frame = black_box(frame(id, data)?);
            node.receive(black_box(now), &frame);
            node.poll(black_box(now))
        }),
    }
}

fn frame(id: u16, data: [u8; 8]) -> Option<Frame> {
    Some(Frame::full(CanId::standard(id.into())?, data))
}

fn command(frame: &Frame) -> u8 {
    frame.data()[0]
}
