//! The SDO servers beyond the first (CiA 301, 7.5.2.33): on identifiers of their own, each with a transfer of its own.

use lexican_runtime::{
    Address, CanId, Frame, NodeId,
    od::{self, Access, DataType},
};
use lexican_tests::{
    bus::Bus,
    client::{self, Manner},
    generated::servers,
    simulated::{Object, Simulated},
};

const INVALID: u32 = 0x8000_0000;
const TEXT: Address = Address::new(0x2001, 0);

/// The parameters of a server: on these identifiers after power-on, of a client with no node-ID.
fn server(index: u16, request: u32, response: u32) -> [Object; 3] {
    [
        Object::number(index, 1, 4, request.into()),
        Object::number(index, 2, 4, response.into()),
        Object::number(index, 3, 1, 0),
    ]
}

fn text_object(length: usize) -> Object {
    Object {
        data_type: DataType::VISIBLE_STRING,
        default: b"nothing yet".to_vec(),
        capacity: length,
        ..Object::number(TEXT.index, TEXT.sub, 1, 0)
    }
}

/// 2000h, a number; 2001h, a text of up to 1000 bytes; 1201h on 680h and 690h; 1205h on 681h and 691h, not valid.
fn device() -> Simulated {
    let mut objects = vec![Object::number(0x2000, 0, 4, 0x1234_5678), text_object(1000)];
    objects.extend(server(0x1201, 0x680, 0x690));
    objects.extend(server(0x1205, INVALID | 0x681, INVALID | 0x691));
    Simulated::new(&objects)
}

fn bus() -> Bus<Simulated> {
    Bus::booted(device(), 1)
}

/// The text that the application sees.
fn text(bus: &mut Bus<Simulated>) -> Vec<u8> {
    od::read(bus.node().device_mut(), TEXT)
        .expect("a text")
        .to_bytes()
        .to_vec()
}

/// What a client writes on the first server to configure another one.
fn configure(bus: &mut Bus<Simulated>, index: u16, sub: u8, value: u32) {
    let address = Address::new(index, sub);
    client::download(bus, address, &value.to_le_bytes(), Manner::Expedited).expect("it is taken");
}

#[test]
fn a_server_answers_on_its_own_identifiers_beside_the_first() {
    bus()
        .send("680#4000200000000000")
        .expect("690#4300200078563412")
        .send("601#4000200000000000")
        .expect("581#4300200078563412")
        .send("680#2300200001020304")
        .expect("690#6000200000000000")
        .send("601#4000200000000000")
        .expect("581#4300200001020304")
        .silence();
}

#[test]
fn a_server_that_is_not_valid_in_both_directions_is_silent_until_it_is() {
    let mut bus = bus();
    bus.send("681#4000200000000000").silence();
    configure(&mut bus, 0x1205, 1, 0x681);
    bus.send("681#4000200000000000").silence();
    configure(&mut bus, 0x1205, 2, 0x691);
    bus.send("681#4000200000000000").expect("691#4300200078563412");
    configure(&mut bus, 0x1205, 2, INVALID | 0x691);
    bus.send("681#4000200000000000").silence();
    bus.send("680#4000200000000000").expect("690#4300200078563412");
}

#[test]
fn identifiers_of_29_bits_and_dynamic_connections_are_served() {
    let mut bus = bus();
    configure(&mut bus, 0x1205, 1, 0x6000_0681);
    configure(&mut bus, 0x1205, 2, 0x6ABC_DEF0);
    bus.send("681#4000200000000000").silence();
    bus.send("00000681#4000200000000000")
        .expect("0ABCDEF0#4300200078563412");
    let read = client::upload(&mut bus, Address::new(0x1205, 2)).unwrap();
    assert_eq!(read, 0x6ABC_DEF0_u32.to_le_bytes());
}

#[test]
fn an_identifier_changes_by_way_of_invalid_only_and_never_to_one_of_a_fixed_service() {
    let mut bus = bus();
    for (frame, answer) in [
        ("601#2301120182060000", "581#8001120130000906"), // valid, another number
        ("601#2301120180060020", "581#8001120130000906"), // valid, another length
        ("601#2301120180060040", "581#6001120100000000"), // bit 30 alone
        ("601#2301120182060080", "581#6001120100000000"), // not valid any more
        ("601#2301120101060000", "581#8001120130000906"), // 601h, the first server's
        ("601#2301120100080000", "581#8001120130000906"), // 800h has 12 bits
        ("601#2301120182060000", "581#6001120100000000"),
        ("682#4000200000000000", "690#4300200078563412"),
    ] {
        bus.send(frame).expect(answer);
    }
    bus.send("680#4000200000000000").silence();
}

#[test]
fn a_client_that_takes_its_own_server_away_is_answered_and_then_no_more() {
    bus()
        .send("680#2301120180060080")
        .expect("690#6001120100000000")
        .send("680#4000200000000000")
        .silence();
}

#[test]
fn a_shorter_request_and_one_by_rtr_are_ignored() {
    bus()
        .send("680#40002000000000")
        .silence()
        .send("680#R")
        .silence()
        .send("690#4000200000000000")
        .silence();
}

#[test]
fn the_clients_node_id_is_stored_and_changes_nothing() {
    bus()
        .send("680#2F0112037F000000")
        .expect("690#6001120300000000")
        .send("680#4001120300000000")
        .expect("690#4F0112037F000000");
}

#[test]
fn two_clients_write_one_object_and_each_value_is_stored_whole_the_later_one_last() {
    let mut bus = bus();
    bus.send("601#210120000A000000").expect("581#6001200000000000");
    bus.send("680#2101200008000000").expect("690#6001200000000000");
    bus.send("601#0041414141414141").expect("581#2000000000000000");
    bus.send("680#0042424242424242").expect("690#2000000000000000");
    assert_eq!(text(&mut bus), b"nothing yet");
    bus.send("680#1D42000000000000").expect("690#3000000000000000");
    assert_eq!(text(&mut bus), b"BBBBBBBB");
    bus.send("601#1941414100000000").expect("581#3000000000000000");
    assert_eq!(text(&mut bus), b"AAAAAAAAAA");
}

#[test]
fn a_download_in_blocks_goes_on_while_the_other_server_answers() {
    let mut bus = bus();
    bus.send("680#C00120000A000000").expect("690#A00120007F000000");
    bus.send("680#0130313233343536").silence();
    bus.send("601#4000200000000000").expect("581#4300200078563412");
    bus.send("680#8237383900000000").expect("690#A2027F0000000000");
    bus.send("680#D100000000000000").expect("690#A100000000000000");
    assert_eq!(text(&mut bus), b"0123456789");
}

#[test]
fn two_uploads_in_blocks_go_out_whole_and_a_short_answer_overtakes_them() {
    let mut bus = bus();
    let mut long = [b'x'; 700];
    long[699] = b'.';
    client::download(
        &mut bus,
        TEXT,
        &long,
        Manner::Block {
            announced: true,
            lost: 0,
        },
    )
    .unwrap();
    configure(&mut bus, 0x1205, 1, 0x681);
    configure(&mut bus, 0x1205, 2, 0x691);
    bus.send("601#A001200064000000").expect("581#C2012000BC020000");
    bus.send("680#A001200064000000").expect("690#C2012000BC020000");
    let (now, start) = (bus.now(), [0xA3, 0, 0, 0, 0, 0, 0, 0]);
    let node = bus.node();
    for (id, request) in [(0x601, start), (0x680, start), (0x681, [0x40, 0, 0x20, 0, 0, 0, 0, 0])] {
        node.receive(now, &Frame::new(CanId::standard(id).unwrap(), &request).unwrap());
    }
    bus.advance(0).expect("691#4300200078563412");
    let sent: Vec<String> = std::iter::from_fn(|| bus.take())
        .map(|frame| format!("{frame:?}"))
        .collect();
    for id in ["581", "690"] {
        let segments: Vec<&String> = sent.iter().filter(|frame| frame.starts_with(id)).collect();
        assert_eq!(segments.len(), 100);
        assert!(segments[99].starts_with(&format!("{id}#E4")), "{}", segments[99]);
    }
    assert_eq!(sent.len(), 200);
    bus.send("680#A264640000000000").expect("690#C1..");
    bus.send("601#A264640000000000").expect("581#C1..");
}

#[test]
fn each_server_gives_its_own_transfer_up_in_time() {
    let mut bus = bus();
    bus.send("601#210120000A000000").expect("581#6001200000000000");
    bus.advance(600);
    bus.send("680#210120000A000000").expect("690#6001200000000000");
    bus.advance(399).silence();
    bus.advance(1).expect("581#8001200000000405").silence();
    bus.advance(599).silence();
    bus.advance(1).expect("690#8001200000000405").silence();
    bus.node().set_sdo_timeout(50);
    bus.send("680#210120000A000000").expect("690#6001200000000000");
    bus.advance(50).expect("690#8001200000000405").silence();
    assert_eq!(bus.node().poll_at(), None);
}

#[test]
fn other_identifiers_end_the_transfer_without_a_word() {
    let mut bus = bus();
    bus.send("680#210120000A000000").expect("690#6001200000000000");
    configure(&mut bus, 0x1201, 2, INVALID | 0x690);
    configure(&mut bus, 0x1201, 2, 0x690);
    bus.send("680#0041414141414141").expect("690#8000000001000405");
    bus.advance(2000).silence();
}

#[test]
fn stop_ends_all_transfers_and_silences_all_servers_until_the_node_is_started() {
    let mut bus = bus();
    bus.send("680#210120000A000000").expect("690#6001200000000000");
    bus.send("000#0201").send("680#4000200000000000").silence();
    bus.advance(2000).silence();
    bus.send("000#0101")
        .send("680#0041414141414141")
        .expect("690#8000000001000405");
}

#[test]
fn a_reset_puts_the_identifiers_back_and_ends_all_transfers() {
    let mut bus = bus();
    configure(&mut bus, 0x1205, 1, 0x681);
    configure(&mut bus, 0x1205, 2, 0x691);
    bus.send("680#210120000A000000").expect("690#6001200000000000");
    bus.send("000#8201").expect("701#00").silence();
    bus.send("681#4000200000000000").silence();
    bus.send("680#0041414141414141").expect("690#8000000001000405");
    bus.advance(2000).silence();
}

#[test]
fn identifiers_that_follow_the_node_id_do_so() {
    let mut objects = server(0x1201, 0x640, 0x5C0);
    for object in &mut objects[..2] {
        *object = object.clone().with(Access::NODE_ID);
    }
    let mut bus = Bus::booted(Simulated::new(&objects), 5);
    bus.send("645#4001120100000000").expect("5C5#4301120145060000");
    bus.node().set_node_id(NodeId::new(6).unwrap());
    bus.advance(0).expect("706#00");
    bus.send("645#4001120100000000").silence();
    bus.send("646#4001120100000000").expect("5C6#4301120146060000");
}

/// `tests/fixtures/codegen/servers.eds` has 1201h, and 1203h that is not valid after power-on.
#[test]
fn a_generated_device_has_the_servers_of_its_file() {
    struct Quiet;
    impl servers::Handlers for Quiet {}
    let mut bus = Bus::booted(servers::Device::new(Quiet), 2);
    bus.send("682#4003120300000000").expect("6A2#4F03120301000000");
    bus.send("682#2303120183060000").expect("6A2#6003120100000000");
    bus.send("682#23031202A3060000").expect("6A2#6003120200000000");
    bus.send("683#4000200000000000").expect("6A3#410020001D000000");
    bus.send("683#6000000000000000").expect("6A3#0041206E6F746520"); // "A note "
}
