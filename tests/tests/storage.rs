//! Storing and restoring parameters, as a client sees it (CiA 301, 7.5.2.13, 7.5.2.14 and 7.5.2.18).

use lexican_runtime::{
    AbortCode, Address, Emergency, Event, Node, NodeId,
    lss::BitRate,
    od::{Access, DataType},
    storage::{self, Failed, Group, NoStorage, Slot, Storage},
};
use lexican_tests::{
    bus::Bus,
    generated::wdga,
    memory::Memory,
    simulated::{Object, Simulated},
};

/// One object of each group, a COB-ID that follows the node-ID, process data, and what is not stored.
fn objects() -> Vec<Object> {
    let text = Object {
        data_type: DataType::VISIBLE_STRING,
        capacity: 10,
        default: b"tag".to_vec(),
        ..Object::number(0x2009, 0, 1, 0)
    };
    let limited = Object {
        limits: Some((vec![1], vec![10])),
        ..Object::number(0x6010, 0, 1, 5)
    };
    let mut objects = vec![
        Object::number(0x1003, 0, 1, 0),
        Object::number(0x1003, 1, 4, 0),
        Object::number(0x1014, 0, 4, 0x80).with(Access::NODE_ID),
        Object::number(0x1015, 0, 2, 0),
        Object::number(0x1020, 0, 1, 2),
        Object::number(0x1020, 1, 4, 0),
        Object::number(0x1020, 2, 4, 0),
        Object::number(0x2000, 0, 4, 100),
        text,
        Object::number(0x6000, 0, 2, 1000),
        Object::number(0x6001, 0, 2, 1),
        limited,
        Object::number(0x6200, 0, 1, 7).with(Access::RPDO),
    ];
    for index in [0x1010, 0x1011] {
        objects.push(Object::number(index, 0, 1, 4));
        objects.extend((1..=4).map(|sub| Object::number(index, sub, 4, 0xFF)));
    }
    objects
}

fn switched_on(memory: &Memory) -> Bus<Simulated> {
    Bus::booted(Simulated::new(&objects()).with_memory(memory), 1)
}

const SAVE_ALL: &str = "601#2310100173617665";
const LOAD_ALL: &str = "601#231110016C6F6164";

fn set(bus: &mut Bus<Simulated>, index: u16, sub: u8, value: &[u8]) {
    bus.node()
        .write(Address::new(index, sub), value)
        .expect("such an object");
}

fn number(bus: &mut Bus<Simulated>, index: u16, sub: u8) -> u64 {
    bus.node()
        .read(Address::new(index, sub))
        .expect("such an object")
        .bits()
}

#[track_caller]
fn saved(bus: &mut Bus<Simulated>, sub: u8) {
    bus.send(&format!("601#231010{sub:02X}73617665"))
        .expect(&format!("581#601010{sub:02X}00000000"));
}

#[track_caller]
fn restored(bus: &mut Bus<Simulated>, sub: u8) {
    bus.send(&format!("601#231110{sub:02X}6C6F6164"))
        .expect(&format!("581#601110{sub:02X}00000000"));
}

/// Gives each group's object another value.
fn changed(memory: &Memory) -> Bus<Simulated> {
    let mut bus = switched_on(memory);
    set(&mut bus, 0x1015, 0, &[0x10, 0x27]);
    set(&mut bus, 0x2000, 0, &[1, 2, 3, 4]);
    set(&mut bus, 0x2009, 0, b"a name");
    set(&mut bus, 0x6000, 0, &[5, 6]);
    bus
}

/// 1015h, 2000h, 6000h.
fn values(bus: &mut Bus<Simulated>) -> [u64; 3] {
    [0x1015, 0x2000, 0x6000].map(|index| number(bus, index, 0))
}

const DEFAULTS: [u64; 3] = [0, 100, 1000];
const CHANGED: [u64; 3] = [10000, 0x0403_0201, 0x0605];

#[test]
fn what_is_saved_is_there_after_power_off() {
    for memory in [Memory::flash(256), Memory::eeprom(256)] {
        let mut bus = changed(&memory);
        bus.send(SAVE_ALL).expect("581#6010100100000000").silence();
        let mut bus = switched_on(&memory);
        assert_eq!(values(&mut bus), CHANGED);
        assert_eq!(bus.node().read(Address::new(0x2009, 0)).unwrap().to_bytes(), b"a name");
    }
}

#[test]
fn what_is_not_saved_is_lost_at_power_off() {
    let memory = Memory::flash(256);
    changed(&memory);
    assert_eq!(values(&mut switched_on(&memory)), DEFAULTS);
}

#[test]
fn a_wrong_signature_is_refused_and_changes_nothing() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    bus.send("601#2310100165766173").expect("581#8010100120000008");
    bus.send("601#231010016C6F6164").expect("581#8010100120000008");
    bus.send("601#2311100173617665").expect("581#8011100120000008");
    assert_eq!(memory.erased(), 0);
    bus.send("601#231010056C6F6164").expect("581#8010100511000906");
    bus.send("601#2B10100173610000").expect("581#8010100113000706");
}

#[test]
fn capabilities_are_read_before_and_after_a_command() {
    let memory = Memory::flash(256);
    let mut bus = switched_on(&memory);
    for _ in 0..2 {
        bus.send("601#4010100100000000").expect("581#4310100101000000");
        bus.send("601#4010100400000000").expect("581#4310100401000000");
        bus.send("601#4011100100000000").expect("581#4311100101000000");
        bus.send(SAVE_ALL).expect("581#60..").send(LOAD_ALL).expect("581#60..");
    }
    bus.send("000#8100").expect("701#00");
    bus.send("601#4010100100000000").expect("581#4310100101000000");
}

#[test]
fn a_device_without_storage_says_so_and_refuses() {
    let mut bus = Bus::booted(wdga::Device::new(()), 1);
    bus.send("601#4010100100000000").expect("581#4310100100000000");
    bus.send("601#4011100100000000").expect("581#4311100100000000");
    bus.send(SAVE_ALL).expect("581#8010100120000008");
    bus.send(LOAD_ALL).expect("581#8011100120000008");
    // One that was not even asked for its storage says what its dictionary says.
    let mut bus = Bus::booted(Simulated::new(&objects()), 1);
    bus.send("601#4010100100000000").expect("581#43101001FF000000");
    bus.send(SAVE_ALL).expect("581#8010100120000008");
}

#[test]
fn a_command_that_the_application_answers_for_is_its_own() {
    let memory = Memory::flash(256);
    let handled = objects().into_iter().map(|object| match object.address.index {
        0x1010 => object.with(Access::WRITE_HANDLER),
        _ => object,
    });
    let handled: Vec<Object> = handled.collect();
    let mut bus = Bus::booted(Simulated::new(&handled).with_memory(&memory), 1);
    bus.send("601#4010100100000000").expect("581#43101001FF000000");
    bus.send("601#2310100101020304").expect("581#6010100100000000");
    assert_eq!(memory.erased(), 0);
    bus.send(LOAD_ALL).expect("581#60..");
    assert_eq!(memory.erased(), 1);
}

#[test]
fn each_group_is_saved_for_itself() {
    for (sub, expected) in [
        (2, [CHANGED[0], DEFAULTS[1], DEFAULTS[2]]),
        (3, [DEFAULTS[0], DEFAULTS[1], CHANGED[2]]),
        (4, [DEFAULTS[0], CHANGED[1], DEFAULTS[2]]),
    ] {
        let memory = Memory::eeprom(256);
        saved(&mut changed(&memory), sub);
        assert_eq!(values(&mut switched_on(&memory)), expected, "{sub}");
    }
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    saved(&mut bus, 2);
    saved(&mut bus, 3);
    set(&mut bus, 0x1015, 0, &[0, 0]);
    saved(&mut bus, 4);
    assert_eq!(values(&mut switched_on(&memory)), CHANGED);
}

#[test]
fn restored_defaults_are_there_after_the_reset_of_their_group() {
    for (sub, command, expected) in [
        (1, "81", DEFAULTS),
        // A reset communication is about the communication parameters only.
        (1, "82", [DEFAULTS[0], CHANGED[1], CHANGED[2]]),
        (2, "82", [DEFAULTS[0], CHANGED[1], CHANGED[2]]),
        (3, "81", [CHANGED[0], CHANGED[1], DEFAULTS[2]]),
        (4, "81", [CHANGED[0], DEFAULTS[1], CHANGED[2]]),
    ] {
        let memory = Memory::flash(256);
        let mut bus = changed(&memory);
        saved(&mut bus, 1);
        restored(&mut bus, sub);
        assert_eq!(values(&mut bus), CHANGED, "not before the reset");
        bus.send(&format!("000#{command}01")).expect("701#00");
        assert_eq!(values(&mut bus), expected, "{sub}");
    }
}

#[test]
fn restored_defaults_are_there_after_power_off() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    saved(&mut bus, 1);
    restored(&mut bus, 3);
    assert_eq!(values(&mut switched_on(&memory)), [CHANGED[0], CHANGED[1], DEFAULTS[2]]);
    restored(&mut bus, 1);
    assert_eq!(values(&mut switched_on(&memory)), DEFAULTS);
}

#[test]
fn a_reset_brings_what_is_saved() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    saved(&mut bus, 1);
    set(&mut bus, 0x1015, 0, &[0, 0]);
    set(&mut bus, 0x6000, 0, &[0, 0]);
    bus.send("000#8201").expect("701#00");
    assert_eq!(values(&mut bus), [CHANGED[0], CHANGED[1], 0]);
    bus.send("000#8101").expect("701#00");
    assert_eq!(values(&mut bus), CHANGED);
}

#[test]
fn process_data_and_the_error_history_are_not_stored() {
    let memory = Memory::flash(256);
    let mut bus = switched_on(&memory);
    set(&mut bus, 0x6200, 0, &[9]);
    bus.node().raise_emergency(Emergency::new(0x2310, 0x02));
    bus.advance(0).expect("081#..");
    saved(&mut bus, 1);
    let mut bus = switched_on(&memory);
    assert_eq!(number(&mut bus, 0x6200, 0), 7);
    assert_eq!(number(&mut bus, 0x1003, 0), 0);
}

#[test]
fn an_error_history_with_a_group_of_its_own_outlives_power_off() {
    let history = Group(5);
    let memory = Memory::flash(256).with_group(0x1003, Some(history));
    let mut bus = switched_on(&memory);
    set(&mut bus, 0x6000, 0, &[5, 6]);
    bus.node().raise_emergency(Emergency::new(0x2310, 0x02));
    bus.node().save(history).expect("a memory");
    let mut bus = switched_on(&memory);
    assert_eq!(number(&mut bus, 0x1003, 0), 1);
    assert_eq!(number(&mut bus, 0x1003, 1), 0x2310);
    assert_eq!(number(&mut bus, 0x6000, 0), 1000);
    // An object without a group of its own is not stored.
    let memory = Memory::flash(256).with_group(0x6000, None);
    saved(&mut changed(&memory), 1);
    assert_eq!(values(&mut switched_on(&memory)), [CHANGED[0], CHANGED[1], DEFAULTS[2]]);
}

#[test]
fn a_group_from_128_on_is_the_applications_alone_and_outlives_every_restore() {
    let own = Group(0x80);
    let memory = Memory::eeprom(4096).with_group(0x2000, Some(own));
    let mut bus = switched_on(&memory);
    set(&mut bus, 0x2000, 0, &[7, 0, 0, 0]);
    saved(&mut bus, 1);
    assert_eq!(
        number(&mut switched_on(&memory), 0x2000, 0),
        100,
        "a client saves it not"
    );
    bus.node().save(own).expect("a memory that works");
    saved(&mut bus, 1);
    restored(&mut bus, 1);
    assert_eq!(number(&mut switched_on(&memory), 0x2000, 0), 7);
}

#[test]
fn the_application_configures_node_id_and_bit_rate_as_lss_does() {
    let memory = Memory::eeprom(4096);
    let mut bus = switched_on(&memory);
    let node_id = NodeId::new(5).expect("a node-ID");
    let configured = (Some(node_id), Some(BitRate::KBIT_250));
    bus.node()
        .configure_lss(node_id, Some(BitRate::KBIT_250))
        .expect("a memory that works");
    assert_eq!(bus.node().configured_lss(), configured);
    assert_eq!(bus.node().node_id(), NodeId::new(1), "not before a reset");
    bus.send("000#8101").expect("705#00");

    memory.fail_after(0);
    let failed = bus.node().configure_lss(node_id, None);
    assert_eq!(failed, Err(AbortCode::HARDWARE_ERROR));
    memory.power_on();
    let mut bus = Bus::new(Simulated::new(&objects()).with_memory(&memory), 1);
    bus.advance(0).expect("705#00");
    assert_eq!(bus.node().configured_lss(), configured);
    let mut forgetful = Bus::booted(Simulated::new(&objects()), 1);
    assert_eq!(
        forgetful.node().configure_lss(node_id, None),
        Err(AbortCode::NOT_STORED)
    );
}

#[test]
fn what_the_application_prepares_for_lss_is_stored_later_and_forgotten_by_a_reset_until_then() {
    let memory = Memory::eeprom(4096);
    let mut bus = switched_on(&memory);
    let node_id = NodeId::new(5).expect("a node-ID");
    bus.node().prepare_lss(node_id, Some(BitRate::KBIT_250));
    bus.send("000#8101").expect("701#00");
    bus.node().prepare_lss(node_id, Some(BitRate::KBIT_250));
    bus.send("000#8201").expect("705#00");
    assert_eq!(bus.node().bit_rate(), None, "that has not switched");
    bus.node().adopt_bit_rate();
    bus.node().adopt_bit_rate();
    assert_eq!(bus.node().bit_rate(), Some(BitRate::KBIT_250));
    let told = bus.node().device().told().iter();
    assert_eq!(told.filter(|event| matches!(event, Event::BitRate(_))).count(), 1);
    switched_on(&memory);
    bus.node().store_lss().expect("a memory that works");
    let mut bus = Bus::new(Simulated::new(&objects()).with_memory(&memory), 1);
    bus.advance(0).expect("705#00");
}

#[test]
fn the_application_is_told_what_a_client_has_saved_and_restored() {
    let memory = Memory::eeprom(4096);
    let mut bus = switched_on(&memory);
    saved(&mut bus, 3);
    restored(&mut bus, 1);
    memory.fail_after(0);
    bus.send(SAVE_ALL).expect("581#8010100100000606");
    let told = bus.node().device().told();
    let told: Vec<Event> = told
        .iter()
        .copied()
        .filter(|event| !matches!(event, Event::State(_)))
        .collect();
    assert_eq!(told, [Event::Saved(Group::APPLICATION), Event::Restored(Group::ALL)]);
}

#[test]
fn a_failing_memory_is_a_hardware_error_and_keeps_what_was_stored() {
    let memory = Memory::flash(256);
    saved(&mut changed(&memory), 1);
    let mut bus = switched_on(&memory);
    set(&mut bus, 0x6000, 0, &[0, 0]);
    memory.fail_after(20);
    bus.send(SAVE_ALL).expect("581#8010100100000606");
    bus.send(LOAD_ALL).expect("581#8011100100000606");
    memory.power_on();
    assert_eq!(values(&mut switched_on(&memory)), CHANGED);
    bus.send(SAVE_ALL).expect("581#60..");
    assert_eq!(values(&mut switched_on(&memory))[2], 0);
}

#[test]
fn a_memory_that_is_too_small_is_a_hardware_error() {
    let room = storage::room(&mut Simulated::new(&objects()).with_memory(&Memory::flash(8)));
    let all_strings_full = |size: usize| {
        let memory = Memory::flash(size);
        let mut bus = changed(&memory);
        set(&mut bus, 0x2009, 0, b"0123456789");
        bus.send("7E5#0401000000000000")
            .send("7E5#1700000000000000")
            .expect("7E4#1700000000000000");
        bus.send(SAVE_ALL);
        bus.take().map(|frame| format!("{frame:?}"))
    };
    assert_eq!(
        all_strings_full(room.next_multiple_of(8)).as_deref(),
        Some("581#6010100100000000")
    );
    assert_eq!(all_strings_full(room - 16).as_deref(), Some("581#8010100100000606"));
}

#[test]
fn a_damaged_image_does_not_count() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    saved(&mut bus, 1);
    set(&mut bus, 0x6000, 0, &[0, 0]);
    saved(&mut bus, 1);
    let length = memory.content(Slot::B).iter().rposition(|byte| *byte != 0xFF).unwrap() + 1;
    for offset in 0..length {
        let damaged = memory.copy();
        damaged.damage(Slot::B, offset);
        assert_eq!(values(&mut switched_on(&damaged)), CHANGED, "{offset}");
        damaged.damage(Slot::A, offset);
        assert_eq!(values(&mut switched_on(&damaged)), DEFAULTS, "{offset}");
    }
}

#[test]
fn cob_ids_follow_the_node_id_until_they_are_saved() {
    let memory = Memory::flash(256);
    let mut bus = switched_on(&memory);
    assert_eq!(number(&mut bus, 0x1014, 0), 0x81);
    bus.node().set_node_id(NodeId::new(2).unwrap());
    assert_eq!(number(&mut bus, 0x1014, 0), 0x82);
    bus.advance(0).expect("702#00");
    bus.send("602#2310100273617665").expect("582#60..");
    bus.node().set_node_id(NodeId::new(3).unwrap());
    assert_eq!(number(&mut bus, 0x1014, 0), 0x82, "frozen");
    assert_eq!(number(&mut switched_on(&memory), 0x1014, 0), 0x82);
    bus.advance(0).expect("703#00");
    bus.send("603#231110016C6F6164").expect("583#60..");
    bus.send("000#8200").expect("703#00");
    assert_eq!(number(&mut bus, 0x1014, 0), 0x83, "free again");
    assert_eq!(number(&mut switched_on(&memory), 0x1014, 0), 0x81);
}

#[test]
fn a_written_cob_id_is_freed_by_a_reset() {
    let mut bus = switched_on(&Memory::flash(256));
    set(&mut bus, 0x1014, 0, &[0, 0, 0, 0x80]);
    set(&mut bus, 0x1014, 0, &[0xF0, 0, 0, 0]);
    bus.node().set_node_id(NodeId::new(2).unwrap());
    assert_eq!(number(&mut bus, 0x1014, 0), 0x82);
}

#[test]
fn a_changed_configuration_is_not_the_verified_one() {
    let memory = Memory::flash(256);
    let mut bus = switched_on(&memory);
    let verified = |bus: &mut Bus<Simulated>| [1, 2].map(|sub| number(bus, 0x1020, sub));
    let verify = |bus: &mut Bus<Simulated>| {
        bus.send("601#2320100178560000")
            .expect("581#60..")
            .send("601#2320100201020304")
            .expect("581#60..");
        assert_eq!(verified(bus), [0x5678, 0x0403_0201]);
    };
    verify(&mut bus);
    saved(&mut bus, 1);
    assert_eq!(verified(&mut bus), [0x5678, 0x0403_0201], "kept by a save");
    assert_eq!(verified(&mut switched_on(&memory)), [0x5678, 0x0403_0201]);
    for change in [
        "601#2B00600001000000",
        "601#2300200001000000",
        "601#2B15100000000000",
        LOAD_ALL,
    ] {
        verify(&mut bus);
        bus.send(change).expect("581#60..");
        assert_eq!(verified(&mut bus), [0, 0], "{change}");
    }
    // Refused, read, process data, nothing stored.
    for other in [
        "601#2F1060000B000000",
        "601#4000600000000000",
        "601#2F00620003000000",
        "601#2F03100000000000",
    ] {
        verify(&mut bus);
        bus.send(other).take();
        assert_eq!(verified(&mut bus), [0x5678, 0x0403_0201], "{other}");
    }
    assert_eq!(
        verified(&mut switched_on(&memory)),
        [0, 0],
        "the restore was of all groups"
    );
}

#[test]
fn a_restore_of_one_group_forgets_what_was_verified() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    set(&mut bus, 0x1020, 1, &[1, 2, 3, 4]);
    saved(&mut bus, 1);
    restored(&mut bus, 4);
    let mut bus = switched_on(&memory);
    assert_eq!(values(&mut bus), [CHANGED[0], DEFAULTS[1], CHANGED[2]]);
    assert_eq!(number(&mut bus, 0x1020, 1), 0);
}

#[test]
fn what_does_not_fit_a_changed_dictionary_is_dropped_and_told() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    set(&mut bus, 0x6010, 0, &[10]);
    saved(&mut bus, 1);
    // 2000h gone, 6000h longer, 6010h with narrower limits, 2009h shorter, 1015h const; 2001h is new.
    let mut newer = objects();
    newer.retain(|object| object.address.index != 0x2000);
    newer.push(Object::number(0x2001, 0, 1, 42));
    for object in &mut newer {
        match object.address.index {
            0x6000 => *object = Object::number(0x6000, 0, 4, 1000),
            0x6010 => object.limits = Some((vec![1], vec![9])),
            0x2009 => object.capacity = 5,
            0x1015 => object.access = Access::READ,
            _ => {}
        }
    }
    let mut bus = Bus::booted(Simulated::new(&newer).with_memory(&memory), 1);
    let told = bus.node().device().told();
    let dropped: Vec<u16> = told
        .iter()
        .filter_map(|event| {
            if let Event::Dropped(address) = event {
                Some(address.index)
            } else {
                None
            }
        })
        .collect();
    let mut sorted = dropped.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, [0x1015, 0x2000, 0x2009, 0x6000, 0x6010]);
    assert_eq!(number(&mut bus, 0x6000, 0), 1000);
    assert_eq!(number(&mut bus, 0x6010, 0), 5);
    assert_eq!(number(&mut bus, 0x2001, 0), 42);
    assert_eq!(bus.node().read(Address::new(0x2009, 0)).unwrap().to_bytes(), b"tag");
    assert_eq!(number(&mut bus, 0x1014, 0), 0x81);
}

#[test]
fn lss_stores_node_id_and_bit_rate() {
    let memory = Memory::flash(256);
    let mut bus = changed(&memory);
    saved(&mut bus, 3);
    bus.send("7E5#0401000000000000")
        .send("7E5#1155000000000000")
        .expect("7E4#1100000000000000");
    bus.send("7E5#1300030000000000").expect("7E4#1300000000000000");
    bus.send("7E5#1700000000000000").expect("7E4#1700000000000000");
    let node = Node::new(Simulated::new(&objects()).with_memory(&memory), NodeId::new(1).unwrap());
    let mut bus = Bus::of(node);
    assert_eq!(bus.node().bit_rate().and_then(BitRate::kbit_per_s), Some(250));
    bus.advance(0).expect("755#00").silence();
    assert_eq!(number(&mut bus, 0x1014, 0), 0xD5, "LSS freezes no COB-ID");
    assert_eq!(values(&mut bus)[2], CHANGED[2], "LSS keeps what else is stored");
    // A restore is not about it, a save neither.
    bus.send("655#231110016C6F6164").expect("5D5#60..");
    bus.send("655#2310100173617665").expect("5D5#60..");
    bus.send("000#8100").expect("755#00");
    let mut bus = Bus::of(Node::unconfigured(Simulated::new(&objects()).with_memory(&memory)));
    bus.advance(0).expect("755#00").silence();
}

#[test]
fn a_node_can_be_stored_without_a_node_id() {
    let memory = Memory::eeprom(256);
    let mut bus = switched_on(&memory);
    bus.send("7E5#0401000000000000")
        .send("7E5#11FF000000000000")
        .expect("7E4#11..");
    bus.send("7E5#1700000000000000").expect("7E4#1700000000000000");
    let mut bus = Bus::new(Simulated::new(&objects()).with_memory(&memory), 1);
    bus.advance(0).silence();
    assert_eq!(bus.node().node_id(), None);
}

#[test]
fn lss_tells_when_the_memory_fails() {
    let memory = Memory::eeprom(256);
    let mut bus = switched_on(&memory);
    memory.fail_after(4);
    bus.send("7E5#0401000000000000")
        .send("7E5#1700000000000000")
        .expect("7E4#1702000000000000");
}

#[test]
fn a_slot_needs_the_words_of_the_image_and_no_more() {
    for length in [1, 2, 4, 8] {
        let object = Object::number(0x2000, 0, length, 0);
        let mut device = Simulated::new(&[object]).with_memory(&Memory::flash(8));
        // The head, what LSS stores, the value, the end, the check value.
        let image = 8 + (5 + 2) + (5 + length) + 5 + 4;
        let whole_words = storage::room(&mut device) / 8 * 8;
        assert_eq!(whole_words, image.next_multiple_of(8), "a value of {length} bytes");
    }
}

#[test]
fn no_storage_can_do_nothing() {
    let mut none = NoStorage;
    assert_eq!(NoStorage::CAPABILITIES, 0);
    assert_eq!(none.read(Slot::A, 0), Err(Failed));
    assert_eq!(none.erase(Slot::A), Err(Failed));
    assert_eq!(none.write(Slot::A, 0, [0; 8]), Err(Failed));
}
