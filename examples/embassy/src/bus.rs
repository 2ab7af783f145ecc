//! A CAN controller that is none: a master that follows a script, and what the device answers, printed.

use embassy_time::{Instant as Clock, Timer};
use lexican_runtime::{CanId, Frame};

use crate::{RECEIVED, TO_SEND};

/// What the master sends, and when, in ms.
const SCRIPT: [(u64, u32, &[u8]); 5] = [
    // A heartbeat every 25 ms.
    (10, 0x67F, &[0x2B, 0x17, 0x10, 0x00, 0x19, 0x00, 0x00, 0x00]),
    // OPERATIONAL.
    (30, 0x000, &[0x01, 0x7F]),
    // A preset, which is refused while it is hot, and taken afterwards.
    (80, 0x67F, &[0x23, 0x03, 0x60, 0x00, 0xE8, 0x03, 0x00, 0x00]),
    (150, 0x67F, &[0x23, 0x03, 0x60, 0x00, 0xE8, 0x03, 0x00, 0x00]),
    (200, 0x000, &[0x02, 0x7F]),
];

/// What comes in. The example is over when the script is.
#[embassy_executor::task]
pub(crate) async fn receive() {
    let started = Clock::now();
    for (millis, id, data) in SCRIPT {
        Timer::at(started + embassy_time::Duration::from_millis(millis)).await;
        let id = CanId::standard(id).expect("11 bits");
        let frame = Frame::new(id, data).expect("up to eight bytes");
        println!("{millis:4} ms  master  {frame:?}");
        RECEIVED.send(frame).await;
    }
    Timer::after_millis(50).await;
    std::process::exit(0);
}

/// What goes out.
#[embassy_executor::task]
pub(crate) async fn send() {
    loop {
        let frame = TO_SEND.receive().await;
        println!("{:4} ms  device  {frame:?}", Clock::now().as_millis());
    }
}
