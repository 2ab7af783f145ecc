//! The shared vectors: dialogues recorded from other stacks' tests, or written by hand from CiA 301.
//!
//! Where a vector depends on what the recorded test did beside the bus, [`application`] does the same.
//!
//! A vector that needs a service of a later issue is skipped by name, and counted.

#![expect(clippy::unwrap_used, reason = "a vector that lacks something is a broken test")]

#[path = "vectors/application.rs"]
mod application;

use std::{collections::BTreeMap, fs, path::PathBuf};

use lexican_runtime::{
    Address,
    od::{Access, DataType},
};
use lexican_tests::{
    bus::Bus,
    line,
    memory::Memory,
    simulated::{Object, Simulated},
};
use serde_json::Value;

fn shared(file: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../shared/vectors")
        .join(file)
}

#[test]
#[expect(clippy::print_stdout, reason = "what was left out is to be seen")]
fn every_vector_is_held_whose_services_are_there() {
    let Ok(text) = fs::read_to_string(shared("vectors.json")) else {
        println!("no shared vectors here: nothing was held");
        return;
    };
    let all: Value = serde_json::from_str(&text).unwrap();
    let mut later: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    let mut held = 0;
    for vector in all["vectors"].as_array().unwrap() {
        if let Some(reason) = reason_for_later(vector) {
            later.entry(reason).or_default().push(name(vector));
        } else {
            hold(vector);
            held += 1;
        }
    }
    for (reason, names) in &later {
        println!("later, {reason}: {} vectors: {}", names.len(), names.join(", "));
    }
    println!("held: {held}");
    assert_eq!(held, 266, "fewer vectors are held than were");
}

fn name(vector: &Value) -> &str {
    vector["name"].as_str().unwrap()
}

/// The service that a vector waits for.
fn reason_for_later(vector: &Value) -> Option<&str> {
    let service = vector["service"].as_str().unwrap();
    if !matches!(service, "SDO" | "NMT" | "EMCY" | "SYNC" | "PDO" | "LSS") {
        return Some(service);
    }
    match name(vector) {
        "TS_Nmt_NoSdoInInit" => Some("a node that stays in INITIALISING"),
        "TS_ExpWr_DataNullPtr" => Some("an object without data"),
        // It expects an abort in answer to the client's abort, which CiA 301 gives no answer.
        "TS_SegWr_RestartTransfer" => Some("never: its abort is answered"),
        // The value that it refuses watches the node that the same sub-index watches already.
        "TS_HBCons_DynSdoError" => Some("never: it refuses to watch the same node anew"),
        // A byte fewer than they announce is to be enough.
        "TS_BlkWr_889ByteDomain" | "TS_BlkWr_890ByteDomain" => Some("never: it ends a byte too early"),
        // They map 24 bits of an UNSIGNED32; a mapping has the length of its object (CiA 301, 7.5.2.36).
        "TS_TPdo_24Bit" | "TS_RPdo_24Bit" => Some("never: it maps a part of an object"),
        // Its type is 1, but it is sent after an event, without SYNC.
        "TS_TPdo_Async" => Some("never: a synchronous PDO is sent without SYNC"),
        _ => None,
    }
}

fn hold(vector: &Value) {
    let node_id = u8::try_from(vector["node_id"].as_u64().unwrap()).unwrap();
    let device = device(vector).with_memory(&Memory::eeprom(4096));
    let mut bus = Bus::booted(device, node_id);
    application::prepare(&mut bus, vector);
    for (number, exchange) in vector["exchanges"].as_array().unwrap().iter().enumerate() {
        if let Some(request) = text(&exchange["request"]) {
            bus.send(&request);
        }
        let remaining = vector["exchanges"].as_array().unwrap().len() - 1 - number;
        application::act(&mut bus, name(vector), number, remaining);
        let last = exchange == vector["exchanges"].as_array().unwrap().last().unwrap();
        let expected: Vec<String> = exchange["responses"]
            .as_array()
            .unwrap()
            .iter()
            .filter_map(text)
            .collect();
        let got = responses(&mut bus, &expected);
        let right = got == expected || last && accepted(vector).contains(&got);
        assert!(
            right,
            "{}: {} gave {got:?}, expected {expected:?}",
            name(vector),
            exchange["request"]
        );
    }
}

/// What the node has sent; if that is too little, what it sends within 1.5 s. A heartbeat that the vector does not
/// speak of may come at any time.
fn responses(bus: &mut Bus<Simulated>, expected: &[String]) -> Vec<String> {
    let spoken_of = |frame: &String| !frame.starts_with('7') || expected.contains(frame);
    let mut got = Vec::new();
    for _ in 0..1500 {
        let sent = std::iter::from_fn(|| bus.take()).map(|frame| format!("{frame:?}"));
        got.extend(sent.filter(spoken_of));
        if got.len() < expected.len() {
            bus.advance(1);
        }
    }
    got
}

/// Other answers that are right for the last exchange.
fn accepted(vector: &Value) -> Vec<Vec<String>> {
    let pair = |frame: &Value| vec![format!("{}#{}", frame[0].as_str().unwrap(), frame[1].as_str().unwrap())];
    vector["accept"]
        .as_array()
        .map_or_else(Vec::new, |accept| accept.iter().map(pair).collect())
}

fn text(frame: &Value) -> Option<String> {
    let data = if frame["rtr"] == true {
        "R1"
    } else {
        frame["data"].as_str()?
    };
    Some(format!("{}#{data}", frame["id"].as_str()?))
}

/// The device that the vector is about: of an EDS, or of the objects that it lists.
fn device(vector: &Value) -> Simulated {
    if let Some(eds) = vector["eds"].as_str() {
        return Simulated::of(&lexican_eds::read(eds, fs::read(shared(eds)).unwrap()).dictionary);
    }
    let node_id = vector["node_id"].as_u64().unwrap();
    let counts = vector["domain_content"].is_string();
    let objects = vector["od"].as_object().unwrap().iter();
    let objects: Vec<Object> = objects
        .map(|(address, facts)| object(address, facts, node_id, counts))
        .collect();
    Simulated::new(&objects)
}

/// `counts`: the test puts 00 01 02 … into every domain, but the alphabet into one of 26 bytes.
fn object(address: &str, facts: &Value, node_id: u64, counts: bool) -> Object {
    let (index, sub) = address.split_once(':').unwrap();
    let (data_type, length) = match facts["type"].as_str().unwrap() {
        // Recorded with four bytes, though written with one.
        _ if address == "1003:00" => (DataType::UNSIGNED8, 1),
        "U8" => (DataType::UNSIGNED8, 1),
        "U16" => (DataType::UNSIGNED16, 2),
        "U32" => (DataType::UNSIGNED32, 4),
        "STRING" => (DataType::VISIBLE_STRING, 0),
        other => (
            if other == "DOMAIN" {
                DataType::DOMAIN
            } else {
                panic!("{other}")
            },
            0,
        ),
    };
    let default = match &facts["value"] {
        Value::String(text) if data_type == DataType::VISIBLE_STRING => text.clone().into_bytes(),
        Value::String(hex) if counts && hex.len() == 2 * 26 => (b'a'..=b'z').collect(),
        Value::String(hex) if counts => (0..=u8::MAX).cycle().take(hex.len() / 2).collect(),
        Value::String(hex) => line::bytes(hex),
        number => {
            let number = number.as_u64().unwrap_or(0) + if facts["nodeid"] == true { node_id } else { 0 };
            number.to_le_bytes()[..length].to_vec()
        }
    };
    let access = match facts["access"].as_str().unwrap() {
        "ro" => Access::READ,
        "wo" => Access::WRITE,
        _ => Access::READ.with(Access::WRITE),
    };
    // Only what may be in a TPDO is recorded.
    let mappable = if facts["pdo"] == true {
        Access::TPDO
    } else {
        Access::RPDO
    };
    let access = access.with(mappable);
    Object {
        address: Address::new(
            u16::from_str_radix(index, 16).unwrap(),
            u8::from_str_radix(sub, 16).unwrap(),
        ),
        data_type,
        access,
        capacity: default.len(),
        default,
        limits: None,
    }
}
