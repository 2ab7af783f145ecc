//! What all the benches share: the frames of an operation, and how often to do it.
//!
//! `bench NAME DICTIONARY N` does the operation `NAME` `N` times. Run under callgrind with N and 2N, the difference is
//! what N operations cost, start-up not counted.

use std::hint::black_box;

/// Node 10h: the frames of each operation, as (CAN-ID, data).
pub fn frames(operation: &str) -> Vec<(u16, [u8; 8])> {
    let sdo = |data| (0x610, data);
    match operation {
        "upload_u32" | "harness" => vec![sdo([0x40, 0x04, 0x60, 0, 0, 0, 0, 0])],
        "download_u16" => vec![sdo([0x2B, 0x00, 0x62, 0, 0x34, 0x12, 0, 0])],
        "segmented_256" => {
            let mut frames = vec![sdo([0x40, 0x00, 0x21, 0, 0, 0, 0, 0])];
            frames.extend((0..37).map(|segment| sdo([0x60 | (segment & 1) << 4, 0, 0, 0, 0, 0, 0, 0])));
            frames
        }
        _ => Vec::new(),
    }
}

/// Does `exchange` with each frame `n` times over. It gives the response that is to be sent; `command` is the first byte
/// of one.
pub fn exchange_all<F>(
    operation: &str,
    n: u32,
    command: impl Fn(&F) -> u8,
    mut exchange: impl FnMut(u16, [u8; 8]) -> Option<F>,
) {
    let frames = frames(operation);
    for &(id, data) in &frames {
        let response = exchange(id, data).expect("a response");
        // An abort is quick, but it is not the operation.
        assert_ne!(command(&response), 0x80, "{operation} was refused");
    }
    for _ in 0..n {
        for &(id, data) in &frames {
            let response = exchange(black_box(id), black_box(data));
            assert!(black_box(response).is_some(), "{operation}: no response");
        }
    }
}

#[allow(dead_code, reason = "only a stack whose dictionary has no mapping needs it")]
/// TPDO 1 as the other dictionaries have it: three objects, 180h + node-ID, with every SYNC.
pub const MAPPING: [[u8; 8]; 7] = [
    [0x23, 0x00, 0x18, 1, 0x90, 0x01, 0x00, 0x80],
    [0x23, 0x00, 0x1A, 1, 0x20, 0x00, 0x04, 0x60],
    [0x23, 0x00, 0x1A, 2, 0x10, 0x01, 0x30, 0x60],
    [0x23, 0x00, 0x1A, 3, 0x10, 0x00, 0x00, 0x65],
    [0x2F, 0x00, 0x1A, 0, 3, 0, 0, 0],
    [0x2F, 0x00, 0x18, 2, 1, 0, 0, 0],
    [0x23, 0x00, 0x18, 1, 0x90, 0x01, 0x00, 0x40],
];

/// Starts node 10h, then gives `exchange` a SYNC `n` times over: TPDO 1 with three objects is to follow each.
pub fn sync_all<F>(n: u32, mut exchange: impl FnMut(u16, &[u8]) -> Option<F>) {
    exchange(0x000, &[0x01, 0x10]);
    for _ in 0..n {
        let frame = exchange(black_box(0x080), black_box(&[]));
        assert!(black_box(frame).is_some(), "no TPDO");
    }
}

#[allow(dead_code, reason = "not all stacks have block transfer")]
/// Reads 2101h, 4 KiB, in blocks of 127 segments, `n` times over. `send` gives the stack a request, `next` takes a frame
/// that it sends.
pub fn block_upload_all<F>(
    n: u32,
    data: impl Fn(&F) -> [u8; 8],
    mut send: impl FnMut(u16, [u8; 8]),
    mut next: impl FnMut() -> Option<F>,
) {
    for _ in 0..n {
        send(black_box(0x610), [0xA4, 0x01, 0x21, 0, 127, 0, 0, 0]);
        let response = data(&next().expect("a response"));
        assert_eq!(response[..1], [0xC6], "CRC and size");
        send(black_box(0x610), [0xA3, 0, 0, 0, 0, 0, 0, 0]);
        loop {
            let mut command = 0;
            while command & 0x80 == 0 && command < 127 {
                let [first, ..] = data(&black_box(next()).expect("a segment"));
                command = first;
            }
            send(black_box(0x610), [0xA2, command & 0x7F, 127, 0, 0, 0, 0, 0]);
            if command & 0x80 != 0 {
                break;
            }
        }
        let end = data(&next().expect("the end"));
        // 586 segments of seven bytes are six bytes more.
        assert_eq!((end[0], [end[1], end[2]]), (0xD9, CRC.to_le_bytes()));
        send(black_box(0x610), [0xA1, 0, 0, 0, 0, 0, 0, 0]);
    }
}

/// What stands in 2101h.
#[allow(dead_code, reason = "not all stacks have block transfer")]
pub fn domain() -> Vec<u8> {
    (0..4096u32).map(|at| (at * 7 + at / 256).to_le_bytes()[0]).collect()
}

/// The CRC of [`domain`].
const CRC: u16 = 0x470F;

#[allow(dead_code, reason = "one of the stacks has everything")]
/// Ends the bench of what a stack does not have.
pub fn absent() -> ! {
    std::process::exit(2)
}

/// The arguments: operation, whether the dictionary has 1000 objects, how often.
pub fn arguments() -> (String, bool, u32) {
    let arguments: Vec<String> = std::env::args().collect();
    (
        arguments[1].clone(),
        arguments[2] == "1000",
        arguments[3].parse().unwrap(),
    )
}
