//! Bytes ↔ meaning, both ways, for whatever bytes there are.

use lexican_runtime::{
    AbortCode, Address, CanId, Frame,
    wire::sdo::{Expedited, Request, Response, Segment},
};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_request_says_the_same_after_it_was_emitted(bytes in any::<[u8; 8]>()) {
        let request = Request::parse(bytes);
        prop_assert_eq!(Request::parse(request.emit()), request);
    }

    #[test]
    fn a_response_says_the_same_after_it_was_emitted(bytes in any::<[u8; 8]>()) {
        let response = Response::parse(bytes);
        prop_assert_eq!(Response::parse(response.emit()), response);
    }
}

/// Byte by byte from CiA 301, 7.2.4.3.
#[test]
fn requests_have_the_bytes_of_the_standard() {
    let address = Address::new(0x1017, 0x02);
    let value = |bits, length| Expedited { bits, length };
    for (request, bytes) in [
        (
            Request::DownloadExpedited {
                address,
                value: value(0x03E8, Some(2)),
            },
            [0x2B, 0x17, 0x10, 0x02, 0xE8, 0x03, 0, 0],
        ),
        (
            Request::DownloadExpedited {
                address,
                value: value(0x1122_3344, None),
            },
            [0x22, 0x17, 0x10, 0x02, 0x44, 0x33, 0x22, 0x11],
        ),
        (
            Request::DownloadInitiate {
                address,
                size: Some(10),
            },
            [0x21, 0x17, 0x10, 0x02, 10, 0, 0, 0],
        ),
        (
            Request::DownloadInitiate { address, size: None },
            [0x20, 0x17, 0x10, 0x02, 0, 0, 0, 0],
        ),
        (
            Request::DownloadSegment(Segment {
                toggle: true,
                last: true,
                length: 3,
                data: [1, 2, 3, 0, 0, 0, 0],
            }),
            [0x19, 1, 2, 3, 0, 0, 0, 0],
        ),
        (
            Request::UploadInitiate { address },
            [0x40, 0x17, 0x10, 0x02, 0, 0, 0, 0],
        ),
        (Request::UploadSegment { toggle: true }, [0x70, 0, 0, 0, 0, 0, 0, 0]),
        (
            Request::Abort {
                address,
                code: AbortCode::GENERAL,
            },
            [0x80, 0x17, 0x10, 0x02, 0, 0, 0, 0x08],
        ),
    ] {
        assert_eq!(request.emit(), bytes);
        assert_eq!(Request::parse(bytes), request);
    }
}

#[test]
fn a_frame_knows_its_identifier_its_kind_and_its_length() {
    let id = CanId::standard(0x7FF).unwrap();
    assert_eq!(CanId::standard(0x800), None);
    assert_eq!(CanId::extended(0x2000_0000), None);
    assert_eq!(Frame::new(id, &[0; 9]), None);
    assert_eq!(Frame::remote(id, 9), None);

    let frame = Frame::new(id, &[1, 2]).unwrap();
    assert_eq!((frame.id(), frame.length(), frame.data()), (id, 2, &[1, 2][..]));
    assert_eq!((frame.data_id(), frame.full_data()), (Some(id), None));
    assert_eq!(format!("{frame:?}"), "7FF#0102");

    let remote = Frame::remote(id, 8).unwrap();
    assert_eq!((remote.id(), remote.length(), remote.data()), (id, 8, &[][..]));
    assert_eq!((remote.data_id(), remote.full_data()), (None, None));
    assert_eq!(format!("{remote:?}"), "7FF#R8");

    let extended = CanId::extended(0x7FF).unwrap();
    assert_ne!(extended, id, "the same number in another length is another identifier");
    assert_eq!(format!("{:?}", Frame::byte(extended, 5)), "000007FF#05");
}
