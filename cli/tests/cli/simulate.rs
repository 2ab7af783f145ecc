//! `lexican simulate`: devices on a bus, judged from the other end of it.

use std::{
    env, fs,
    io::{BufRead as _, BufReader, Write as _},
    path::{Path, PathBuf},
    process::{Child, ChildStderr, ChildStdin, Command, Stdio},
    time::Duration,
};

use lexican_bus::transport::{Transport, open};
use lexican_runtime::wire::{CanId, Frame};

use crate::lexican::Lexican;

/// Long enough for any machine; a test that works does not wait for it.
const LONG: Duration = Duration::from_secs(20);

/// A simulation that serves on a port of its own; it ends with this.
struct Simulation {
    child: Child,
    stdin: Option<ChildStdin>,
    stderr: BufReader<ChildStderr>,
    /// What it said on stderr before it served.
    said: String,
    address: String,
}

impl Simulation {
    fn of(lexican: &Lexican, arguments: &[&str]) -> Self {
        let fixed = ["simulate", "--bus", "slcan+tcp-listen://127.0.0.1:0"];
        let mut command = lexican.command(&[&fixed[..], arguments].concat());
        let piped = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = piped.spawn().unwrap();
        let mut stderr = BufReader::new(child.stderr.take().unwrap());
        let mut said = String::new();
        while !said.contains("slcan+tcp://") {
            assert!(stderr.read_line(&mut said).unwrap() > 0, "it does not serve: {said}");
        }
        let (_, address) = said.trim_end().rsplit_once("slcan+tcp://").unwrap();
        Self {
            stdin: child.stdin.take(),
            address: address.to_owned(),
            child,
            stderr,
            said,
        }
    }

    fn join(&self) -> Box<dyn Transport> {
        open(&format!("slcan+tcp://{}", self.address)).unwrap()
    }

    fn tell(&mut self, line: &str) {
        writeln!(self.stdin.as_mut().unwrap(), "{line}").unwrap();
    }

    /// The exit code, once the script has ended, and what it said on stderr since it serves.
    fn end(mut self) -> (Option<i32>, String) {
        drop(self.stdin.take());
        let mut said = String::new();
        while self.stderr.read_line(&mut said).unwrap() > 0 {}
        (self.child.wait().unwrap().code(), said)
    }
}

impl Drop for Simulation {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The files of the encoders, in a directory of their own.
fn encoders() -> Lexican {
    let device = |name: &str| fs::read(root().join("eds/devices").join(name)).unwrap();
    Lexican::with(&[("wdga.eds", &device("wdga.eds")), ("wv58mr.eds", &device("wv58mr.eds"))])
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

fn frame(id: u32, data: &[u8]) -> Frame {
    Frame::new(CanId::standard(id).unwrap(), data).unwrap()
}

/// Waits for a frame with this identifier.
#[track_caller]
fn expect(bus: &mut dyn Transport, id: u32) -> Vec<u8> {
    loop {
        let received = bus.receive(LONG).unwrap().expect("an answer");
        if received.id().number() == id {
            return received.data().to_vec();
        }
    }
}

/// Reads an object of up to four bytes.
#[track_caller]
fn read(bus: &mut dyn Transport, node: u8, index: u16, sub: u8) -> u32 {
    let [low, high] = index.to_le_bytes();
    bus.send(&frame(0x600 + u32::from(node), &[0x40, low, high, sub, 0, 0, 0, 0]))
        .unwrap();
    let answer = expect(bus, 0x580 + u32::from(node));
    assert_eq!(answer[1..4], [low, high, sub], "{answer:02X?}");
    u32::from_le_bytes(answer[4..].try_into().unwrap())
}

#[test]
fn a_device_is_served_where_stderr_says() {
    let lexican = encoders();
    let mut simulation = Simulation::of(&lexican, &["wdga.eds", "--node", "5", "--script", "-"]);
    assert!(
        simulation.said.starts_with("note: node 5 is wdga.eds, "),
        "{}",
        simulation.said
    );
    let mut bus = simulation.join();
    assert_eq!(read(&mut bus, 5, 0x1800, 1), 0x4000_0185);
    simulation.tell("quit");
    assert_eq!(simulation.end(), (Some(0), String::new()));
}

#[test]
fn values_are_set_at_the_start_and_by_a_script_and_the_pdo_tells_of_them() {
    let lexican = encoders();
    let arguments = ["wdga.eds", "--node", "5", "--set", "6004:0=0x12345", "--script", "-"];
    let mut simulation = Simulation::of(&lexican, &arguments);
    let mut bus = simulation.join();
    assert_eq!(read(&mut bus, 5, 0x6004, 0), 0x12345);
    bus.send(&frame(0, &[1, 5])).unwrap();
    // What came before the answer has been heeded.
    read(&mut bus, 5, 0x1000, 0);
    simulation.tell("# a comment\n5/6004:0 = 99");
    assert_eq!(expect(&mut bus, 0x185), [99, 0, 0, 0]);
    simulation.tell("6004:0 = far");
    simulation.tell("9/6004:0 = 1");
    simulation.tell("nonsense");
    let (code, said) = simulation.end();
    assert_eq!(code, Some(0));
    insta::assert_snapshot!(said, @r"
    note: <stdin>:3: `far` is no value of UNSIGNED32, the data type of 6004h:00
    note: <stdin>:4: no node 9 has the object 6004h:00
    note: <stdin>:5: `nonsense` is no command; there are `6004:0 = 1234`, `5/6004:0 = 1234`, `wait 500` and `quit`
    ");
}

#[test]
fn several_files_and_many_nodes_share_the_bus() {
    let lexican = encoders();
    let two = Simulation::of(&lexican, &["wdga.eds", "wv58mr.eds", "--node", "3,9"]);
    let mut bus = two.join();
    for node in [3, 9] {
        assert_eq!(read(&mut bus, node, 0x1018, 0), 4);
    }
    let many = Simulation::of(&lexican, &["wdga.eds", "--node", "1..127"]);
    assert!(
        many.said.starts_with("note: nodes 1 to 127 are wdga.eds, "),
        "{}",
        many.said
    );
    let mut bus = many.join();
    for node in 1..=127 {
        assert_eq!(read(&mut bus, node, 0x1800, 1), 0x4000_0180 + u32::from(node));
    }
}

#[test]
fn what_is_recorded_is_a_candump_log() {
    let lexican = encoders();
    let simulation = Simulation::of(&lexican, &["wdga.eds", "--record", "bus.log", "--script", "-"]);
    let mut bus = simulation.join();
    read(&mut bus, 1, 0x1000, 0);
    assert_eq!(simulation.end().0, Some(0));
    let log = fs::read_to_string(lexican.path().join("bus.log")).unwrap();
    let frames: Vec<&str> = log.lines().map(|line| line.rsplit_once(' ').unwrap().1).collect();
    assert_eq!(frames, ["701#00", "601#4000100000000000", "581#4300100096010200"]);
    let (time, rest) = log[1..].split_once(") can0 ").unwrap();
    assert!(rest.starts_with("701#00\n"), "{log}");
    assert!(time.parse::<f64>().unwrap() > 1e9, "{log}");
}

#[test]
fn what_cannot_be_served_is_told_in_a_line() {
    let lexican = encoders();
    fs::write(lexican.path().join("script"), "wait 5\n9999:0 = 1\n").unwrap();
    let listen = "slcan+tcp-listen://127.0.0.1:0";
    let mut told = String::new();
    for arguments in [
        &["wdga.eds", "--bus", "usb:1"][..],
        &["wdga.eds", "--bus", "slcan+tcp://127.0.0.1:1"],
        &["absent.eds", "--bus", listen],
        &["wdga.eds", "wv58mr.eds", "--bus", listen, "--node", "1..3"],
        &["wdga.eds", "--bus", listen, "--set", "1000=far"],
        &["wdga.eds", "--bus", listen, "--set", "9999=1"],
        &["wdga.eds", "--bus", listen, "--script", "script"],
    ] {
        told += lexican.run(&[&["simulate"], arguments].concat()).failed();
    }
    insta::assert_snapshot!(told, @r"
    error: usb:1: cannot open: there is no kind of bus `usb`; the forms are slcan:/dev/ttyACM0[@500k], slcan+tcp://host:port[@500k], slcan+tcp-listen://host:port, socketcan:can0, virtual:name
    error: slcan+tcp://127.0.0.1:1: cannot open: Connection refused (os error 111)
    error: cannot read absent.eds: there is no such file or directory
    error: 2 files and 3 node-IDs; give each file one, or one file any number
    error: --set 1000=far: `far` is no value of UNSIGNED32, the data type of 1000h:00
    error: --set 9999=1: no node has the object 9999h:00
    error: script:2: no node has the object 9999h:00
    ");
}

#[test]
fn a_bus_that_vanishes_ends_the_simulation() {
    let lexican = encoders();
    let bus = open("slcan+tcp-listen://127.0.0.1:0").unwrap();
    let url = format!("slcan+tcp://{}", bus.address().unwrap());
    let mut command = lexican.command(&["simulate", "wdga.eds", "--bus", &url]);
    let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
    let mut stderr = BufReader::new(child.stderr.take().unwrap());
    let mut said = String::new();
    while !said.contains("serving on") {
        assert!(stderr.read_line(&mut said).unwrap() > 0, "{said}");
    }
    drop(bus);
    assert_eq!(child.wait().unwrap().code(), Some(2));
    stderr.read_line(&mut said).unwrap();
    assert!(
        said.lines()
            .last()
            .unwrap()
            .starts_with(&format!("error: {url}: cannot ")),
        "{said}"
    );
}

/// The Python that CI names, or the machine's, if it has what is needed.
fn python() -> Option<String> {
    let python = env::var("LEXICAN_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let check = Command::new(&python).args(["-c", "import canopen, serial"]).output();
    if check.is_ok_and(|output| output.status.success()) {
        return Some(python);
    }
    let _ = writeln!(
        std::io::stderr(),
        "skipped: no Python with canopen and pyserial (set LEXICAN_PYTHON to one that has them)"
    );
    None
}

/// What python-canopen says of these files, each served as a device.
fn judged_by_python(python: &str, files: &[&str]) -> String {
    let lexican = Lexican::with(&[]);
    let paths: Vec<String> = files
        .iter()
        .map(|file| root().join(file).display().to_string())
        .collect();
    let paths: Vec<&str> = paths.iter().map(String::as_str).collect();
    let simulation = Simulation::of(&lexican, &paths);
    let mut command = Command::new(python);
    command.arg(root().join("tests/oracle/simulated_device.py"));
    command.arg(format!("socket://{}", simulation.address));
    for (number, path) in (1..).zip(paths) {
        command.args([number.to_string(), path.to_owned()]);
    }
    let output = command.output().unwrap();
    String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap()
}

#[test]
fn python_canopen_reads_writes_and_maps_both_encoders_over_tcp() {
    let Some(python) = python() else { return };
    let judged = judged_by_python(&python, &["eds/devices/wdga.eds", "eds/devices/wv58mr.eds"]);
    assert_eq!(judged, "330 values read, 2 written, 5 PDOs received\n");
}

/// The full circle: what a file is made into, read back over a bus, is what the file says.
#[test]
fn the_devices_of_all_our_files_are_read_and_hold_against_them() {
    let directory = root().join("eds/devices");
    let names = fs::read_dir(&directory)
        .unwrap()
        .map(|entry| entry.unwrap().file_name());
    let names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
    let contents: Vec<Vec<u8>> = names
        .iter()
        .map(|name| fs::read(directory.join(name)).unwrap())
        .collect();
    let files: Vec<(&str, &[u8])> = names
        .iter()
        .map(String::as_str)
        .zip(contents.iter().map(Vec::as_slice))
        .collect();
    let lexican = Lexican::with(&files);
    let nodes = format!("1..{}", names.len());
    let mut arguments: Vec<&str> = names.iter().map(String::as_str).collect();
    arguments.extend(["--node", &nodes]);
    let simulation = Simulation::of(&lexican, &arguments);
    let bus = format!("slcan+tcp://{}", simulation.address);
    for (name, node) in names.iter().zip(1..) {
        let judged = lexican.run(&["validate", name, "--bus", &bus, "--node", &node.to_string()]);
        assert!(
            judged.printed(0).contains("1 device checked: no findings"),
            "{name}: {}",
            judged.printed(0)
        );
    }
}
