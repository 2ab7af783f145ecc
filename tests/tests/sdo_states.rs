//! Every state of an SDO server × every request: the table in the documentation of `lexican_runtime::sdo`, walked.

use lexican_tests::{
    bus::Bus,
    sample::{Quiet, device::Device, quiet},
};

/// The states, by the requests that lead into them, and the object that the transfer is about as it stands in an abort.
const STATES: [(&str, &str, &[&str]); 8] = [
    ("idle", "000000", &[]),
    ("download", "092000", &["210920000A000000", "0030313233343536"]),
    ("upload", "081000", &["4008100000000000", "6000000000000000"]),
    ("blocks in", "092000", &["C60920000A000000", "0130313233343536"]),
    (
        "blocks are in",
        "092000",
        &["C60920000A000000", "0130313233343536", "8237383900000000"],
    ),
    ("blocks out, start", "081000", &["A40810007F000000"]),
    ("blocks out", "081000", &["A40810007F000000", "A300000000000000"]),
    (
        "blocks are out",
        "081000",
        &["A40810007F000000", "A300000000000000", "A2027F0000000000"],
    ),
];

/// What the server answers to a request in each of the states. `-` is silence, `?` the abort 05040001h, which ends the
/// transfer, `=` as in the state before.
#[rustfmt::skip]
const TABLE: [(&str, [&str; 8]); 16] = [
    //                    idle   download     upload       blocks in    are in   start  out   are out
    ("4000200000000000", ["4F", "=",          "=",          "-",        "4F",    "=",   "=",  "="]),
    ("2F00200007000000", ["60", "=",          "=",          "-",        "60",    "=",   "=",  "="]),
    ("2109200003000000", ["60", "=",          "=",          "-",        "60",    "=",   "=",  "="]),
    ("A40810007F000000", ["C6", "=",          "=",          "A2017F",   "C6",    "=",   "=",  "="]),
    ("C609200003000000", ["A4", "=",          "=",          "A2017F",   "A4",    "=",   "=",  "="]),
    ("1937383900000000", ["?",  "30",         "?",          "-",        "?",     "?",   "?",  "?"]),
    ("0037383900000000", ["?",  "8009200000000305", "?", "8009200003000405", "?", "?",  "?",  "?"]),
    ("7000000000000000", ["?",  "?",          "11",         "-",        "?",     "?",   "?",  "?"]),
    ("6000000000000000", ["?",  "?",    "8008100000000305", "-",        "?",     "?",   "?",  "?"]),
    ("8009200000000008", ["-",  "-",          "-",          "-",        "-",     "-",   "-",  "-"]),
    ("A300000000000000", ["?",  "?",          "?",          "A2017F",   "?",     "01",  "?",  "?"]),
    ("A2027F0000000000", ["?",  "?",          "?",          "A2017F",   "?",     "?",   "C11F67", "?"]),
    ("A2037F0000000000", ["?",  "?",          "?",          "A2017F",   "?",     "?",   "8008100003000405", "?"]),
    ("A100000000000000", ["?",  "?",          "?",          "A2017F",   "?",     "?",   "?",  "-"]),
    ("D1589C0000000000", ["?",  "?",          "?",          "A2017F",   "A1",    "?",   "?",  "?"]),
    ("E008200000000000", ["?",  "?",          "?",          "A2017F",   "?",     "?",   "?",  "?"]),
];

fn bus_in(state: usize) -> Bus<Device<Quiet>> {
    let mut bus = Bus::booted(quiet(), 1);
    for request in STATES[state].2 {
        bus.send(&format!("601#{request}"));
        while bus.take().is_some() {}
    }
    bus
}

#[test]
fn every_request_in_every_state_is_answered_as_the_table_says() {
    for (request, answers) in TABLE {
        let mut before = "";
        for (state, answer) in answers.into_iter().enumerate() {
            let answer = if answer == "=" { before } else { answer };
            before = answer;
            let mut bus = bus_in(state);
            bus.send(&format!("601#{request}"));
            match answer {
                "-" => drop(bus.silence()),
                "?" => refused(&mut bus, request, STATES[state].1),
                answer => drop(bus.expect(&format!("581#{answer}.."))),
            }
        }
    }
}

/// The abort 05040001h with the multiplexer of an unknown command, else of the transfer; no transfer is open after it.
fn refused(bus: &mut Bus<Device<Quiet>>, request: &str, address: &str) {
    let address = if request.starts_with('E') {
        &request[2..8]
    } else {
        address
    };
    bus.expect(&format!("581#80{address}01000405"))
        .send("601#6000000000000000")
        .expect("581#8000000001000405");
}

#[test]
fn a_short_request_is_ignored_in_every_state_and_the_transfer_goes_on() {
    for state in 0..STATES.len() {
        let mut bus = bus_in(state);
        bus.send("601#800920")
            .silence()
            .send("601#01")
            .silence()
            .send("601#")
            .silence();
        let goes_on = match state {
            1 => ("1937383900000000", "30"),
            2 => ("7000000000000000", "11"),
            3 => ("8237383900000000", "A2027F"),
            4 => ("D1589C0000000000", "A1"),
            5 => ("A300000000000000", "01"),
            6 => ("A2027F0000000000", "C1"),
            _ => ("4000200000000000", "4F"),
        };
        bus.send(&format!("601#{}", goes_on.0))
            .expect(&format!("581#{}..", goes_on.1));
    }
}

#[test]
fn every_transfer_that_is_left_open_times_out_once_and_changes_nothing() {
    for (state, (_, address, _)) in STATES.into_iter().enumerate().skip(1) {
        bus_in(state)
            .advance(999)
            .silence()
            .advance(1)
            .expect(&format!("581#80{address}00000405"))
            .advance(10_000)
            .silence()
            .send("601#4009200000000000")
            .expect("581#4709200074616700");
    }
}

#[test]
fn nothing_is_answered_in_stopped_and_the_transfer_is_over_afterwards() {
    for state in 0..STATES.len() {
        let mut bus = bus_in(state);
        bus.send("000#0201");
        for (request, _) in TABLE {
            bus.send(&format!("601#{request}")).silence();
        }
        bus.send("000#8001")
            .send("601#6000000000000000")
            .expect("581#8000000001000405");
    }
}
