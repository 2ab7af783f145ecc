//! What generated code does, of every kind of object: `tests/fixtures/codegen/every_kind.eds`, compiled as
//! `tests/generated/every_kind.snap.rs`.

use lexican_runtime::{
    AbortCode, Address, Device as _, NodeId,
    od::{self, Part, TimeOfDay, VisibleString},
    sdo::crc,
};
use lexican_tests::{
    bus::Bus,
    client::{Manner, download, upload},
    generated::every_kind::{Device, Dictionary, Handlers},
};

/// Notes what it is asked, refuses `Command` 3.
#[derive(Default)]
struct App {
    log: Vec<String>,
    program: Vec<u8>,
}

/// Bytes of the report, many times what the dictionary has room for.
const REPORT: usize = 5000;

/// The report's byte `at`: nobody holds it in memory.
fn letter(at: usize) -> u8 {
    b"0123456789 "[at * 7 % 11]
}

impl Handlers for App {
    fn read_switch(&mut self, od: &mut Dictionary) -> Result<bool, AbortCode> {
        Ok(!od.switch.get())
    }

    fn read_note(&mut self, _: &mut Dictionary) -> Result<VisibleString<3>, AbortCode> {
        Ok(VisibleString::new(b"now"))
    }

    fn read_program(&mut self, _: &mut Dictionary, offset: usize, buffer: &mut [u8]) -> Result<usize, AbortCode> {
        if self.program.is_empty() {
            return Err(AbortCode::NO_DATA);
        }
        self.log.push(format!("program from {offset}"));
        Ok(od::copy_part(&self.program, offset, buffer))
    }

    fn read_clock(&mut self, _: &mut Dictionary) -> Result<TimeOfDay, AbortCode> {
        Ok(TimeOfDay::new(1, 2))
    }

    fn read_motto(&mut self, _: &mut Dictionary) -> Result<VisibleString<23>, AbortCode> {
        Ok(VisibleString::new(b"answered"))
    }

    fn read_switches(&mut self, _: &mut Dictionary, sub: u8) -> Result<bool, AbortCode> {
        Ok(sub == 1)
    }

    fn read_position_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(od.position_value + 1)
    }

    fn read_speed_value(&mut self, _: &mut Dictionary, sub: u8) -> Result<i16, AbortCode> {
        Ok(-i16::from(sub))
    }

    fn write_store_parameters(&mut self, _: &mut Dictionary, sub: u8, value: u32) -> Result<(), AbortCode> {
        self.log.push(format!("store {sub} {value:08X}"));
        Ok(())
    }

    fn write_limited_list(&mut self, _: &mut Dictionary, sub: u8, value: i16) -> Result<(), AbortCode> {
        self.log.push(format!("list {sub} {value}"));
        Ok(())
    }

    fn write_switch(&mut self, _: &mut Dictionary, value: bool) -> Result<(), AbortCode> {
        self.log.push(format!("switch {value}"));
        Ok(())
    }

    fn write_command(&mut self, od: &mut Dictionary, value: u8) -> Result<(), AbortCode> {
        self.log.push(format!("command {value} after {}", od.command));
        if value == 3 {
            Err(AbortCode::DEVICE_STATE)
        } else {
            Ok(())
        }
    }

    fn write_note(&mut self, _: &mut Dictionary, value: &[u8]) -> Result<(), AbortCode> {
        self.log.push(format!("note {value:02X?}"));
        Ok(())
    }

    fn write_program(&mut self, _: &mut Dictionary, part: Part<'_>) -> Result<(), AbortCode> {
        if part.is_first() {
            self.program.clear();
        }
        assert_eq!(part.offset, self.program.len(), "the parts come in order");
        self.program.extend(part.bytes);
        let end = if part.is_last { ", the last" } else { "" };
        self.log
            .push(format!("program {}+{}{end}", part.offset, part.bytes.len()));
        Ok(())
    }

    fn read_report(&mut self, _: &mut Dictionary, offset: usize, buffer: &mut [u8]) -> Result<usize, AbortCode> {
        for (place, at) in buffer.iter_mut().zip(offset..REPORT) {
            *place = letter(at);
        }
        Ok(REPORT)
    }

    fn write_report(&mut self, _: &mut Dictionary, part: Part<'_>) -> Result<(), AbortCode> {
        let known = (part.offset..).zip(part.bytes).all(|(at, &byte)| byte == letter(at));
        if known { Ok(()) } else { Err(AbortCode::DEVICE_STATE) }
    }

    fn write_clock(&mut self, _: &mut Dictionary, value: TimeOfDay) -> Result<(), AbortCode> {
        self.log.push(format!("clock {value:?}"));
        Ok(())
    }

    fn write_switches(&mut self, _: &mut Dictionary, sub: u8, value: bool) -> Result<(), AbortCode> {
        self.log.push(format!("switches {sub} {value}"));
        Ok(())
    }

    fn write_preset_value(&mut self, _: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        self.log.push(format!("preset {value}"));
        Ok(())
    }
}

fn device() -> Device<App> {
    Device::new(App::default())
}

fn read(device: &mut Device<App>, index: u16, sub: u8) -> Result<Vec<u8>, AbortCode> {
    bytes(od::read(device, Address::new(index, sub))?)
}

/// A value as it goes on the bus.
#[expect(clippy::unnecessary_wraps, reason = "ends a chain of results")]
fn bytes(value: od::Value<'_>) -> Result<Vec<u8>, AbortCode> {
    Ok(match value {
        od::Value::Number { bits, data_type } => bits.to_le_bytes()[..data_type.length()].to_vec(),
        od::Value::Bytes(bytes) => bytes.to_vec(),
    })
}

fn write(device: &mut Device<App>, index: u16, sub: u8, data: &[u8]) -> Result<(), AbortCode> {
    od::write(device, &mut (), Address::new(index, sub), data)
}

#[test]
fn constants_are_read_and_take_no_ram() {
    let mut device = device();
    assert_eq!(read(&mut device, 0x1008, 0).unwrap(), b"Every kind");
    assert_eq!(read(&mut device, 0x2104, 0).unwrap(), [0x00, 0x00, 0x80], "INTEGER24");
    assert_eq!(read(&mut device, 0x2305, 2).unwrap(), b"two");
    assert_eq!(write(&mut device, 0x2104, 0, &[0; 3]), Err(AbortCode::READ_ONLY));
    assert_eq!(Dictionary::CONSTANT_LIST, [-1, 2]);
    assert_eq!(Dictionary::CONSTANT_UNICODE_STRING, "Größe");
}

#[test]
fn a_field_is_what_a_client_reads_and_writes() {
    let mut device = device();
    device.od.value_integer40 = -2;
    assert_eq!(read(&mut device, 0x2005, 0).unwrap(), [0xFE, 0xFF, 0xFF, 0xFF, 0xFF]);
    write(&mut device, 0x2005, 0, &[0x01, 0, 0, 0, 0x80]).unwrap();
    assert_eq!(device.od.value_integer40, -0x7F_FFFF_FFFF);
    write(&mut device, 0x2011, 0, &1.5_f32.to_le_bytes()).unwrap();
    assert_eq!(device.od.value_real32.to_bits(), 1.5_f32.to_bits());
    write(&mut device, 0x2301, 0xFE, &[9]).unwrap();
    assert_eq!(device.od.long_list[0xFD], 9);
}

#[test]
fn a_string_is_as_long_as_it_is_written_up_to_its_capacity() {
    let mut device = device();
    write(&mut device, 0x2013, 0, b"a longer text").unwrap();
    assert_eq!(device.od.value_visible_string.as_str(), Some("a longer text"));
    assert_eq!(write(&mut device, 0x2013, 0, &[b'x'; 21]), Err(AbortCode::TOO_LONG));
    assert_eq!(read(&mut device, 0x2013, 0).unwrap(), b"a longer text");
    write(&mut device, 0x2303, 1, b"first").unwrap();
    assert_eq!(device.od.list_of_texts[0].as_str(), Some("first"));
    assert_eq!(device.od.list_of_texts[1].as_str(), Some("second"));
}

#[test]
fn the_limits_of_each_element_are_its_own() {
    let mut device = device();
    assert_eq!(write(&mut device, 0x2300, 2, &20_i16.to_le_bytes()), Ok(()));
    assert_eq!(
        write(&mut device, 0x2300, 2, &21_i16.to_le_bytes()),
        Err(AbortCode::VALUE_TOO_HIGH)
    );
    assert_eq!(write(&mut device, 0x2300, 3, &21_i16.to_le_bytes()), Ok(()));
    assert_eq!(
        write(&mut device, 0x2300, 1, &(-11_i16).to_le_bytes()),
        Err(AbortCode::VALUE_TOO_LOW)
    );
    assert_eq!(device.od.limited_list, [1, 20, 21]);
    assert_eq!(device.handlers.log, ["list 3 21"], "sub-index 2 is not handled");
}

#[test]
fn formulas_follow_the_node_id() {
    let od = Dictionary::new(NodeId::new(0x21).unwrap());
    assert_eq!(od.cob_id_emcy, 0xA1);
    assert_eq!(od.formula_unsigned8, 0x21);
    assert_eq!(od.formula_integer16, 0x31);
    assert_eq!(od.formula_unsigned64, 0x1_0000_0021);
    assert_eq!(od.formula_list, [0x221, 5]);
    Bus::booted(device(), 0x21)
        .send("621#4014100000000000")
        .expect("5A1#43141000A1000000")
        .send("621#4002240000000000")
        .expect("5A1#4B02240031000000");
}

#[test]
fn the_application_gives_what_is_read() {
    let mut device = device();
    assert_eq!(read(&mut device, 0x2600, 0).unwrap(), [1]);
    assert_eq!(read(&mut device, 0x2602, 0).unwrap(), b"now");
    assert_eq!(device.od.note.as_str(), Some("now"), "what is sent is stored too");
    assert_eq!(read(&mut device, 0x2603, 0), Err(AbortCode::UNSUPPORTED_ACCESS));
    assert_eq!(read(&mut device, 0x2604, 0).unwrap(), [2, 0, 0, 0, 1, 0]);
    assert_eq!(
        read(&mut device, 0x2605, 0).unwrap(),
        b"answered",
        "a constant that is answered for"
    );
    assert_eq!(read(&mut device, 0x2606, 1).unwrap(), [1]);
    assert_eq!(read(&mut device, 0x2606, 2).unwrap(), [0]);
    assert_eq!(read(&mut device, 0x6004, 0).unwrap(), [1, 0, 0, 0]);
    assert_eq!(read(&mut device, 0x6004, 0).unwrap(), [2, 0, 0, 0]);
    assert_eq!(read(&mut device, 0x6030, 3).unwrap(), [0xFD, 0xFF]);
    assert_eq!(device.od.speed_value, [0, 0, -3]);
}

#[test]
fn the_application_is_asked_before_a_value_is_stored() {
    let mut device = device();
    write(&mut device, 0x1010, 1, b"save").unwrap();
    write(&mut device, 0x2600, 0, &[1]).unwrap();
    write(&mut device, 0x2601, 0, &[2]).unwrap();
    assert_eq!(write(&mut device, 0x2601, 0, &[3]), Err(AbortCode::DEVICE_STATE));
    assert_eq!(write(&mut device, 0x2601, 0, &[4]), Err(AbortCode::VALUE_TOO_HIGH));
    write(&mut device, 0x2602, 0, b"x").unwrap();
    write(&mut device, 0x2604, 0, &[3, 0, 0, 0, 4, 0]).unwrap();
    write(&mut device, 0x2606, 2, &[0]).unwrap();
    write(&mut device, 0x6003, 0, &[5, 0, 0, 0]).unwrap();
    let log = [
        "store 1 65766173",
        "switch true",
        "command 2 after 0",
        "command 3 after 2",
        "note [78]",
        "clock 4 d 3 ms",
        "switches 2 false",
        "preset 5",
    ];
    assert_eq!(device.handlers.log, log);
    assert_eq!(device.od.command, 2, "what was refused is not stored");
    assert!(device.od.switch.get());
}

#[test]
fn two_devices_know_nothing_of_each_other() {
    let (mut a, b) = (device(), device());
    write(&mut a, 0x6003, 0, &[5, 0, 0, 0]).unwrap();
    assert_eq!((a.od.preset_value, b.od.preset_value), (5, 0));
    assert_eq!(a.buffer().len(), 100, "room for the longest string");
}

#[test]
fn a_tpdo_asks_the_application_for_its_values() {
    let mut bus = Bus::booted(device(), 1);
    bus.send("000#0101");
    bus.node().device_mut().od.position_value = 0x1122_3343;
    assert!(bus.node().trigger_tpdo(1));
    bus.advance(0).expect("181#44332211FFFF").silence();
}

/// Writes 250 bytes to the DOMAIN in segments of seven, reads them back, and gives what the application saw of it.
#[test]
fn a_domain_of_any_length_goes_through_the_application_in_parts() {
    let address = Address::new(0x2603, 0);
    let value: Vec<u8> = (0..250).collect();
    let segmented = Manner::Segmented {
        step: 7,
        announced: true,
    };
    let mut bus = Bus::booted(device(), 1);
    assert_eq!(upload(&mut bus, address), Err(AbortCode::NO_DATA));
    assert_eq!(download(&mut bus, address, &value, segmented), Ok(()));
    let log = [
        "program 0+0",
        "program 0+98",
        "program 98+98",
        "program 196+54, the last",
    ];
    assert_eq!(bus.node().device().handlers.log, log);
    bus.node().device_mut().handlers.log.clear();
    assert_eq!(upload(&mut bus, address), Ok(value));
    assert_eq!(
        bus.node().device().handlers.log,
        ["program from 0", "program from 98", "program from 196"]
    );
    let short = download(&mut bus, address, b"xyz", Manner::Expedited);
    assert_eq!((short, upload(&mut bus, address)), (Ok(()), Ok(b"xyz".to_vec())));
}

#[test]
fn a_string_of_any_length_is_made_while_it_is_read_and_judged_while_it_is_written() {
    let address = Address::new(0x2607, 0);
    let report: Vec<u8> = (0..REPORT).map(letter).collect();
    let mut bus = Bus::booted(device(), 1);
    assert_eq!(upload(&mut bus, address), Ok(report.clone()));
    let blocks = Manner::Block {
        announced: true,
        lost: 5,
    };
    assert_eq!(download(&mut bus, address, &report, blocks), Ok(()));
    let mut other = report;
    other[4321] ^= 1;
    assert_eq!(
        download(&mut bus, address, &other, blocks),
        Err(AbortCode::DEVICE_STATE)
    );
}

#[test]
fn a_domain_goes_in_blocks_of_a_part_each_and_its_last_part_waits_for_the_crc() {
    let mut bus = Bus::booted(device(), 1);
    bus.send("601#C403260000000000").expect("581#A40326000E000000"); // 14 segments fit into the buffer
    bus.node().device_mut().handlers.log.clear();
    let segment = |sequence: u8| format!("601#{sequence:02X}41424344454647");
    for sequence in 1..=13 {
        bus.send(&segment(sequence)).silence();
    }
    bus.send(&segment(14)).expect("581#A20E0E0000000000");
    assert_eq!(bus.node().device().handlers.log, ["program 0+98"]);
    bus.send(&segment(0x81)).expect("581#A2010E0000000000");
    let sum = crc(0, &b"ABCDEFG".repeat(15)[..101]);
    bus.send(&format!("601#D1{:04X}0000000000", (sum ^ 1).swap_bytes()));
    bus.take();
    assert_eq!(bus.node().device().handlers.log, ["program 0+98"], "never complete");
}

#[test]
fn what_a_client_missed_of_a_domain_is_asked_for_again() {
    let mut bus = Bus::booted(device(), 1);
    bus.node().device_mut().handlers.program = (0..=200).collect();
    let sum = crc(0, &(0..=200).collect::<Vec<u8>>());
    bus.send("601#A40326007F000000")
        .expect("581#C6032600C9000000")
        .send("601#A300000000000000");
    let sent = std::iter::from_fn(|| bus.take()).count();
    assert_eq!(sent, 29);
    // All but the first are lost.
    bus.send("601#A2017F0000000000");
    let again: Vec<u8> = std::iter::from_fn(|| bus.take())
        .flat_map(|frame| frame.data()[1..].to_vec())
        .collect();
    assert_eq!(again[..194], (7..=200).collect::<Vec<u8>>());
    bus.send("601#A21C7F0000000000")
        .expect(&format!("581#C9{:04X}0000000000", sum.swap_bytes()));
}
