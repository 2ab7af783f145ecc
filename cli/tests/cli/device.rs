//! A device that answers on a bus over TCP: values of up to four bytes, and that there are no others.

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread::{self, JoinHandle},
    time::Duration,
};

use lexican_bus::transport::{Transport, open};
use lexican_eds::{dump::Dump, ir};
use lexican_runtime::{
    AbortCode, CanId, Frame, NodeId,
    wire::sdo::{Expedited, Request, Response},
};

/// It answers until this is dropped, or it has answered so often as it shall.
pub(crate) struct Device {
    pub(crate) url: String,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Device {
    /// A device that has what `dump` holds.
    pub(crate) fn of(dump: &[u8]) -> Self {
        Self::that_leaves(dump, usize::MAX)
    }

    /// The same, which takes the bus with it after so many answers.
    pub(crate) fn that_leaves(dump: &[u8], after: usize) -> Self {
        let dump = Dump::from_json(dump).unwrap();
        let mut bus = open("slcan+tcp-listen://127.0.0.1:0").unwrap();
        let url = format!("slcan+tcp://{}", bus.address().unwrap());
        let stop = Arc::new(AtomicBool::new(false));
        let stopped = Arc::clone(&stop);
        let thread = thread::spawn(move || {
            let mut answers = 0;
            while answers < after && !stopped.load(Ordering::Relaxed) {
                let heard = bus.receive(Duration::from_millis(20)).unwrap();
                if let Some(answer) = heard.and_then(|frame| answer(&dump, &frame)) {
                    bus.send(&answer).unwrap();
                    answers += 1;
                }
            }
        });
        let thread = Some(thread);
        Self { url, stop, thread }
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
        let ended = self.thread.take().unwrap().join();
        assert!(ended.is_ok() || thread::panicking());
    }
}

fn answer(dump: &Dump, frame: &Frame) -> Option<Frame> {
    let node_id = NodeId::new(dump.node_id.get()).unwrap();
    let data = frame
        .full_data()
        .filter(|_| frame.id() == CanId::sdo_request(node_id))?;
    let Request::UploadInitiate { address } = Request::parse(data) else {
        return None;
    };
    let response = match dump.value(ir::Address::new(address.index, address.sub)) {
        None => Response::Abort {
            address,
            code: AbortCode::NO_SUCH_OBJECT,
        },
        Some(bytes) => Response::UploadExpedited {
            address,
            value: Expedited {
                bits: bytes.iter().rfold(0, |bits, byte| bits << 8 | u32::from(*byte)),
                length: u8::try_from(bytes.len()).ok(),
            },
        },
    };
    Some(Frame::full(CanId::sdo_response(node_id), response.emit()))
}
