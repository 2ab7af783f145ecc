//! The runtime's frames as those of the crate embedded-can: what a driver does with them, by its trait alone.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on stops")]

use embedded_can::{ExtendedId, Frame as _, Id, StandardId};
use lexican_runtime::{CanId, Frame};
use lexican_tests::line;

/// A driver's own frame, as HALs have them: it knows nothing of the runtime.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Mailbox {
    id: Id,
    is_remote: bool,
    dlc: usize,
    data: Vec<u8>,
}

impl embedded_can::Frame for Mailbox {
    fn new(id: impl Into<Id>, data: &[u8]) -> Option<Self> {
        let (id, data) = (id.into(), data.to_vec());
        let dlc = data.len();
        (dlc <= 8).then_some(Self {
            id,
            is_remote: false,
            dlc,
            data,
        })
    }

    fn new_remote(id: impl Into<Id>, dlc: usize) -> Option<Self> {
        (dlc <= 8).then_some(Self {
            id: id.into(),
            is_remote: true,
            dlc,
            data: Vec::new(),
        })
    }

    fn is_extended(&self) -> bool {
        matches!(self.id, Id::Extended(_))
    }

    fn is_remote_frame(&self) -> bool {
        self.is_remote
    }

    fn id(&self) -> Id {
        self.id
    }

    fn dlc(&self) -> usize {
        self.dlc
    }

    fn data(&self) -> &[u8] {
        &self.data
    }
}

/// What any bridge between two drivers does.
fn convert<To: embedded_can::Frame>(from: &impl embedded_can::Frame) -> To {
    if from.is_remote_frame() {
        To::new_remote(from.id(), from.dlc()).unwrap()
    } else {
        To::new(from.id(), from.data()).unwrap()
    }
}

#[test]
fn every_kind_of_frame_goes_to_a_driver_and_comes_back() {
    for (text, extended, remote, dlc) in [
        ("601#4000100000000000", false, false, 8),
        ("000#", false, false, 0),
        ("7FF#R8", false, true, 8),
        ("701#R0", false, true, 0),
        ("00000601#01", true, false, 1),
        ("000007FF#R1", true, true, 1),
        ("1FFFFFFF#0102030405060708", true, false, 8),
    ] {
        let frame = line::frame(text);
        let mailbox: Mailbox = convert(&frame);
        assert_eq!(mailbox.is_extended(), extended, "{text}");
        assert_eq!((mailbox.is_remote, mailbox.dlc), (remote, dlc), "{text}");
        assert_eq!(mailbox.data, frame.data(), "{text}");
        assert_eq!(convert::<Frame>(&mailbox), frame, "{text}");
    }
}

#[test]
fn every_identifier_of_11_bits_keeps_its_number() {
    for number in 0..=0x7FF {
        let id = CanId::standard(u32::from(number)).unwrap();
        assert_eq!(Id::from(id), Id::Standard(StandardId::new(number).unwrap()));
        assert_eq!(CanId::from(Id::from(id)), id);
    }
}

#[test]
fn identifiers_of_29_bits_stay_so_however_small_they_are() {
    for number in [0, 1, 0x7FF, 0x800, 0x1_0000, 0x1FFF_FFFF] {
        let id = CanId::extended(number).unwrap();
        assert_eq!(Id::from(id), Id::Extended(ExtendedId::new(number).unwrap()));
        assert_eq!(CanId::from(ExtendedId::new(number).unwrap()), id);
    }
}

#[test]
fn more_than_eight_bytes_are_no_frame() {
    let id = StandardId::new(1).unwrap();
    assert_eq!(<Frame as embedded_can::Frame>::new(id, &[0; 9]), None);
    assert_eq!(<Frame as embedded_can::Frame>::new_remote(id, 9), None);
    assert_eq!(<Frame as embedded_can::Frame>::new_remote(id, 256), None);
}
