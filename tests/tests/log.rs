//! Logs of a bus: those that python-can writes, and samples of what the other tools write.

use std::{
    fs,
    io::{BufReader, ErrorKind, Read, repeat},
    path::Path,
    process::Command,
};

use lexican_bus::{
    decode::{Decoder, Description, Survey, write_json, write_text},
    log::{Damage, Format, Reader, Record, Summary, Writer},
};
use lexican_eds::{
    dump::{Answer, Dump},
    ir::Address,
};
use lexican_runtime::{Instant, NodeId};
use lexican_tests::python;

/// The frames of a log as `µs channel id#data`, and what became of its lines.
fn read(log: &[u8]) -> (Vec<String>, Summary) {
    let mut reader = Reader::new(log);
    let mut frames = Vec::new();
    while let Some(record) = reader.next_record().expect("memory can be read") {
        frames.push(shown(&reader, &record));
    }
    (frames, reader.summary().clone())
}

fn shown<R: std::io::BufRead>(reader: &Reader<R>, record: &Record) -> String {
    let (time, channel) = (record.time.as_micros(), reader.channel_name(record.channel));
    format!("{time} {channel} {:?}", record.frame)
}

#[track_caller]
fn assert_read(log: &str, expected: &[&str]) {
    let (frames, summary) = read(log.as_bytes());
    assert_eq!(frames, expected, "{summary:?}");
    assert_eq!(summary.damages, []);
}

#[test]
fn what_python_can_writes_is_read_frame_by_frame() {
    let Some(python) = python::with_canopen() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("logs");
    fs::create_dir_all(&folder).expect("a folder for tests");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracle/write_logs.py");
    let output = Command::new(python)
        .arg(script)
        .arg(&folder)
        .output()
        .expect("python runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let written = String::from_utf8(output.stdout).expect("text");
    let written: Vec<&str> = written.lines().collect();
    assert_eq!(written.len(), 1005);
    // ASC counts from the first message, and has numbers for the buses; the others keep the whole time.
    for (file, format, start) in [
        ("log.log", Format::Candump, 0),
        ("log.asc", Format::Asc, 1_700_000_000_000_000),
        ("log.csv", Format::Csv, 0),
    ] {
        let text = fs::read(folder.join(file)).expect("what python has written");
        let mut reader = Reader::new(&text[..]);
        let mut frames = Vec::new();
        while let Some(Record { time, frame, .. }) = reader.next_record().expect("memory can be read") {
            frames.push(format!("{} {frame:?}", time.as_micros() + start));
        }
        assert_eq!(reader.format(), Some(format));
        assert_eq!(reader.summary().damages, [], "{file}");
        assert_eq!(frames, written, "{file}");
    }
}

#[test]
fn what_candump_shows_on_a_terminal_is_read_with_and_without_times() {
    assert_read(
        "  can0  601   [8]  40 00 10 00 00 00 00 00
  vcan1  18FEDF00   [0] 
  can0  704   [1]  remote request
  can0  704   [2]  11 22   '.\"'
  can0  TX - -  080   [0]
  can0  RX B E  123  [12]  00 00 00 00 00 00 00 00 00 00 00 00
  can0  20000004   [8]  00 04 00 00 00 00 00 60   ERRORFRAME
 (1436509052.249713)  can0  185   [3]  2A 36 6C
 (2015-07-10 06:17:32.249714)  can0  185   [1]  FF
 (000.001200)  can0  185   [1]  00
",
        &[
            "0 can0 601#4000100000000000",
            "0 vcan1 18FEDF00#",
            "0 can0 704#R1",
            "0 can0 704#1122",
            "0 can0 080#",
            "1436509052249713 can0 185#2A366C",
            "1436509052249714 can0 185#FF",
            "1200 can0 185#00",
        ],
    );
}

#[test]
fn what_candump_logs_is_read_whatever_its_options() {
    assert_read(
        "(1436509052.249713) can0 601#4000100000000000\r
(1436509052.249714) any 00000601#40 R
(1436509052.249715) can0 704#R
(1436509052.249716) can0 704#R8_A T
(1436509052.249717) can0 181#1122334455667788_F
(1436509052.249718) can0 123##51122
(1436509052.249719) can0 20000004#0001000000000000
\x1b[31m(1436509052.249720)\x1b[0m can0 \x1b[1m080#\x1b[0m",
        &[
            "1436509052249713 can0 601#4000100000000000",
            "1436509052249714 any 00000601#40",
            "1436509052249715 can0 704#R0",
            "1436509052249716 can0 704#R8",
            "1436509052249717 can0 181#1122334455667788",
            "1436509052249720 can0 080#",
        ],
    );
}

#[test]
fn vectors_logs_are_read_with_hexadecimal_and_decimal_numbers_and_both_ways_of_time() {
    assert_read(
        "date Mit Jul 10 08:17:32.249 am 2015
base hex  timestamps absolute
internal events logged
// version 9.0.0
Begin Triggerblock Mit Jul 10 08:17:32.249 am 2015
   0.000000 Start of measurement
   0.012345 1  601             Rx   d 8 40 00 10 00 00 00 00 00  Length = 228000 BitCount = 118 ID = 1537
   0.013000 2  18FEDF00x       Tx   r 2
   0.013001 2  704             Rx   r
   0.013002 1  080             TxRq d 0
   0.013500 1  ErrorFrame      ECC: 10100010
   0.014000 CANFD   1 Rx        181  Name_1  0 0 8  8 01 02 03 04 05 06 07 08 130000 130 1000 0 0 0 0 0
   0.014500 CANFD   1 Rx        182          0 0 2  2 01 02 130000 130 0 0 0 0 0 0
   0.014600 CANFD   1 Rx        183          0 0 1  0 130000 130 10 0 0 0 0 0
   0.015000 1  Statistic: D 2 R 0 XD 0 XR 0 E 0 O 0 B 0.46%
   0.015100 CAN 1 Status:chip status error active
   0.015200 SV: 2 0 1 ::Var = 5
End TriggerBlock
",
        &[
            "12345 1 601#4000100000000000",
            "13000 2 18FEDF00#R2",
            "13001 2 704#R0",
            "13002 1 080#",
            "14500 1 182#0102",
            "14600 1 183#R1",
        ],
    );
    assert_read(
        "date Fri Jul 10 08:17:32 am 2015
base dec timestamps relative
   0.500000 1  1537            Rx   d 2 64 255
   0.250000 1  419356416x      Rx   d 1 7
",
        &["500000 1 601#40FF", "750000 1 18FEDF00#07"],
    );
}

#[test]
fn a_part_of_a_log_without_its_header_is_told_by_its_lines() {
    assert_read("   0.012345 1  601  Rx   d 1 40\n", &["12345 1 601#40"]);
    assert_read("1.5,0x601,0,0,0,1,QA==\n", &["1500000 can0 601#40"]);
}

#[test]
fn damaged_lines_are_counted_with_their_numbers_and_the_others_kept() {
    let (frames, summary) = read(
        b"0 bottles of beer
(1.000000) can0 601#40
(1.0x0000) can0 601#40
(1.000000) can0 601#4
(1.000000) can0 601#112233445566778899
(1.000000) can0 801#40
(1.000000) can0
can0  601   [8]  40 00 10
can0  601   [2]  40 00 10

(1.000000) can0 602#41
(2.000000) can0 60",
    );
    assert_eq!(frames, ["1000000 can0 601#40", "1000000 can0 602#41"]);
    let lines: Vec<u64> = summary.damages.iter().map(|damage| damage.line).collect();
    assert_eq!(lines, [1, 3, 4, 5, 6, 7, 8, 9, 12]);
    let fourth = Damage {
        line: 4,
        reason: "the data are not up to eight bytes",
    };
    assert_eq!(summary.damages[2], fourth);
    assert_eq!((summary.lines, summary.frames, summary.damaged), (12, 2, 9));
}

#[test]
fn a_million_damaged_lines_are_counted_and_the_first_remembered() {
    let mut log = b"(1.000000) can0 601#40\n".to_vec();
    log.extend(b"\xFF\n".repeat(1_000_000));
    let (frames, summary) = read(&log);
    assert_eq!((frames.len(), summary.damaged), (1, 1_000_000));
    assert_eq!(summary.damages.len(), 20);
}

#[test]
fn a_line_without_end_does_not_fill_the_memory() {
    let endless = repeat(b'x').take(1 << 24);
    let log = b"(1.000000) can0 601#40\n"
        .chain(endless)
        .chain(&b"\n(2.000000) can0 601#41\n"[..]);
    let mut reader = Reader::new(BufReader::new(log));
    let frames: Vec<Record> = reader
        .by_ref()
        .map(|record| record.expect("memory can be read"))
        .collect();
    assert_eq!(frames.len(), 2);
    assert_eq!((reader.summary().lines, reader.summary().damaged), (3, 1));
}

#[test]
fn what_is_no_log_is_refused_and_nothing_is_an_empty_log() {
    for text in [&b"[FileInfo]\nFileName=a.eds\n"[..], b"\x7FELF\0\0", b"{\"format\": 1}"] {
        let error = Reader::new(text).next_record().expect_err("no log");
        assert_eq!(error.kind(), ErrorKind::InvalidData);
    }
    let endless = Reader::new(BufReader::new(repeat(b'\n').chain(repeat(b'x')).take(1 << 20)));
    assert_eq!(endless.count(), 0);
    let endless = b"x\n".repeat(20_000);
    let mut reader = Reader::new(&endless[..]);
    reader.next_record().expect_err("no log");
    assert_eq!(reader.summary().lines, 10_000);
}

#[test]
fn what_is_written_is_read_again() {
    let log = "(1436509052.249713) can0 601#4000100000000000\n(1436509052.249714) can0 18FEDF00#R2\n";
    let mut writer = Writer::new(Vec::new(), "can0");
    for record in Reader::new(log.as_bytes()) {
        let record = record.expect("memory can be read");
        writer.write(record.time, &record.frame).expect("memory takes it");
    }
    assert_eq!(String::from_utf8(writer.into_inner()).unwrap(), log);
    let mut writer = Writer::new(Vec::new(), "my bus#1");
    let frame = Reader::new(log.as_bytes()).next().unwrap().unwrap().frame;
    writer.write(Instant::from_millis(5), &frame).expect("memory takes it");
    let text = String::from_utf8(writer.into_inner()).unwrap();
    assert_eq!(text, "(0000000000.005000) my_bus_1 601#4000100000000000\n");
}

/// What is overheard of node 5 of `eds` in `log`.
fn overheard(eds: &[u8], log: &[u8]) -> Survey {
    let description = Description::new(&lexican_eds::read("node.eds", eds.to_vec()).dictionary);
    let (mut decoder, mut survey) = (Decoder::new(Some(&description)), Survey::default());
    for record in Reader::new(log) {
        let record = record.expect("memory can be read");
        survey.hear(record.time, &decoder.decode(&record.frame));
    }
    survey
}

const NODE: NodeId = match NodeId::new(5) {
    Some(node_id) => node_id,
    None => unreachable!(),
};

/// python-canopen's master reads python-canopen's device while python-can records the bus: nothing of ours has a part in it.
#[test]
fn a_recorded_dump_of_python_canopen_has_the_values_that_python_canopen_read() {
    let Some(python) = python::with_canopen() else { return };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let page = include_str!("../../docs/dump-format.md");
    let (_, script) = page.split_once("```python\n").expect("a script");
    let path = scratch.join("record.py");
    fs::write(&path, script.split_once("```").expect("its end").0).expect("a folder for tests");
    for form in ["log", "asc", "csv"] {
        let (eds, out) = (root.join("../eds/devices/wdga.eds"), scratch.join("recorded.json"));
        let log = scratch.join(format!("recorded.{form}"));
        let output = Command::new(&python)
            .arg(root.join("oracle/dump_local_node.py"))
            .args([&path, &eds, &out, &log])
            .output()
            .expect("python runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let expected = Dump::from_json(&fs::read(&out).expect("the dump")).expect("a dump");
        let survey = overheard(&fs::read(&eds).expect("our file"), &fs::read(&log).expect("the log"));
        let heard = survey.node(NODE).expect("the node was read");
        assert!(heard.dump.objects.len() > 100);
        assert_eq!(heard.dump.objects, expected.objects, "{form}");
        assert_eq!(heard.incomplete, 0);
    }
}

/// Telegrams of CiA 301, 7.2.4.3, written by hand.
#[test]
fn a_log_with_holes_gives_the_values_that_are_whole() {
    let eds = include_bytes!("../../eds/devices/wdga.eds");
    let survey = overheard(
        eds,
        b"(1.0) c 585#431810010900000
(1.0) c 585#4318100109000000
(1.0) c 605#4018100200000000
(1.1) c 585#4318100202000000
(1.2) c 605#4008100000000000
(1.3) c 585#410810000A000000
(1.4) c 605#6000000000000000
(1.5) c 605#7000000000000000
(1.6) c 585#1943444500000000
(1.7) c 605#4018100300000000
(1.8) c 605#4034120000000000
(1.9) c 585#8034120000000206
(2.0) c 605#A008100010000000
(2.1) c 585#C20810000A000000
(2.2) c 605#A300000000000000
(2.3) c 585#0157444741204142
(2.4) c 585#8243444500000000
(2.5) c 605#A202100000000000
(2.6) c 585#D100000000000000
(2.7) c 605#A100000000000000
(2.8) c 605#4000100000000000
(3.0) c 705#00
(3.1) c 705#7F
(3.2) c 085#3081110000000000
(3.3) c 185#0102
",
    );
    let heard = survey.node(NODE).expect("the node was read");
    let answer = |index, sub| heard.dump.answer(Address::new(index, sub)).cloned();
    // Nobody is heard asking for 1018sub1; the first reading of 1008h lacks its first segment; 1000h is never answered.
    assert_eq!(answer(0x1018, 1), None);
    assert_eq!(answer(0x1018, 2), Some(Answer::Value(vec![2, 0, 0, 0])));
    assert_eq!(answer(0x1018, 3), Some(Answer::Timeout));
    assert_eq!(answer(0x1234, 0).map(|answer| answer.is_absence()), Some(true));
    assert_eq!(answer(0x1008, 0), Some(Answer::Value(b"WDGA ABCDE".to_vec())));
    assert_eq!(answer(0x1000, 0), None);
    assert_eq!(
        (heard.incomplete, heard.boot_ups, heard.heartbeats, heard.emergencies),
        (1, 1, 1, 1)
    );
    assert_eq!(heard.first_emergencies[0].2, "life guarding or heartbeat");
    let wrong = heard
        .wrong_pdos
        .values()
        .next()
        .expect("a PDO of two bytes where four are mapped");
    assert_eq!((wrong.frames, wrong.length, wrong.mapped), (1, 2, 4));
}

/// Frames of one node's identifiers with any commands, and a few bytes of text as any log may have them.
#[test]
fn whatever_is_on_the_bus_every_frame_is_a_line() {
    let eds = include_bytes!("../../eds/devices/wdga.eds");
    let description = Description::new(&lexican_eds::read("wdga.eds", eds.to_vec()).dictionary);
    let (mut decoder, mut survey) = (Decoder::new(Some(&description)), Survey::default());
    let mut state = 6u64;
    let mut chance = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        state >> 33
    };
    let ids = [
        0x000, 0x080, 0x085, 0x100, 0x185, 0x205, 0x585, 0x605, 0x705, 0x7E4, 0x7E5,
    ];
    let objects = ["1A0000", "1A0001", "180001", "100800", "101001"];
    for _ in 0..50_000 {
        let id = ids[usize::try_from(chance()).unwrap() % ids.len()];
        let object = objects[usize::try_from(chance()).unwrap() % objects.len()];
        let (high, low) = (&object[..2], &object[2..]);
        let (command, data, length) = (
            chance() & 0xFF,
            chance() & 0xFFFF_FFFF,
            usize::try_from(chance() % 40).unwrap(),
        );
        let bytes = format!("{command:02X}{}{high}{}{data:08X}", &low[..2], &low[2..]);
        let log = format!("(1.000000) can0 {id:03X}#{}\n", &bytes[..(length * 2).min(16)]);
        let record = Reader::new(log.as_bytes())
            .next()
            .expect("a frame")
            .expect("memory can be read");
        let message = decoder.decode(&record.frame);
        survey.hear(record.time, &message);
        let mut lines = String::new();
        write_text(&mut lines, &record, "can0", &message);
        write_json(&mut lines, &record, "can0", &message);
        assert_eq!(lines.lines().count(), 2, "{lines}");
    }
    assert!(survey.node(NODE).is_some_and(|node| node.emergencies > 0));
}
