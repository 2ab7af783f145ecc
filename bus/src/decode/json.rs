//! A frame as a line for programs; `docs/decode-format.md` promises this form.

use data_encoding::HEXUPPER;
use lexican_eds::ir::Value as Plain;
use lexican_runtime::{
    Address,
    wire::{CanId, nmt::Recipient},
};
use serde_json::{Map, Value, json};

use super::{
    Access, Exchange, Message, Multiplexed, Outcome, Received, lss,
    text::{command_name, direction_name, heading, state_name},
};
use crate::log::Record;

/// Appends the line, with its end.
pub fn write_json(line: &mut String, record: &Record, channel: &str, message: &Message<'_>) {
    let mut members = frame_members(record, channel);
    let (node_id, service) = heading(message);
    if let Some(node_id) = node_id {
        members.insert("node".into(), node_id.get().into());
    }
    members.insert("service".into(), service_name(message, service).into());
    members.extend(body(message));
    line.push_str(&Value::Object(members).to_string());
    line.push('\n');
}

fn service_name(message: &Message<'_>, service: &'static str) -> &'static str {
    match message {
        Message::BootUp(_) => "boot-up",
        Message::Heartbeat { .. } => "heartbeat",
        Message::Guarding(_) => "guarding",
        Message::Unknown => "unknown",
        _ => service,
    }
}

fn frame_members(record: &Record, channel: &str) -> Map<String, Value> {
    let frame = &record.frame;
    let mut members = Map::new();
    members.insert("time_us".into(), record.time.as_micros().into());
    members.insert("channel".into(), channel.into());
    members.insert("id".into(), identifier(frame.id()).into());
    if frame.is_remote() {
        members.insert("remote".into(), frame.length().into());
    } else {
        members.insert("data".into(), bytes(frame.data()).into());
    }
    members
}

fn identifier(id: CanId) -> String {
    let width = if id.is_extended() { 8 } else { 3 };
    format!("{:0width$X}", id.number())
}

fn bytes(bytes: &[u8]) -> String {
    HEXUPPER.encode(bytes)
}

/// What the message says beside its service and node.
fn body(message: &Message<'_>) -> Map<String, Value> {
    let value = match message {
        Message::Nmt(request) => {
            let node = match request.recipient {
                Recipient::All => 0,
                Recipient::One(node_id) => node_id.get(),
            };
            json!({"command": command_name(request.command), "to": node})
        }
        Message::Sync(counter) => json!({"counter": counter}),
        Message::Time(time) => json!({"days": time.days(), "milliseconds": time.milliseconds()}),
        Message::Emergency { emergency, meaning, .. } => json!({
            "code": format!("{:04X}", emergency.code),
            "meaning": meaning,
            "register": emergency.register,
            "manufacturer": bytes(&emergency.manufacturer),
        }),
        Message::Heartbeat { state, toggle, .. } => json!({"state": state_name(*state), "toggle": toggle}),
        Message::Sdo(exchange) => return sdo(exchange),
        Message::Pdo(pdo) => pdo_members(pdo),
        Message::Multiplexed(pdo) => multiplexed(pdo),
        Message::LssRequest(request) => text(|line| lss::write_request(line, *request)),
        Message::LssResponse(response) => text(|line| lss::write_response(line, *response)),
        Message::Malformed(_) => json!({"malformed": true}),
        Message::BootUp(_) | Message::Guarding(_) | Message::Unknown => json!({}),
    };
    into_members(value)
}

fn into_members(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(members) => members,
        _ => Map::new(),
    }
}

fn text(write: impl FnOnce(&mut String) -> std::fmt::Result) -> Value {
    let mut text = String::new();
    // Writing to memory does not fail.
    let _ = write(&mut text);
    json!({ "text": text })
}

fn sdo(exchange: &Exchange<'_>) -> Map<String, Value> {
    let mut members = Map::new();
    members.insert("server".into(), (u16::from(exchange.server) + 1).into());
    members.insert(
        "from".into(),
        if exchange.is_request { "client" } else { "server" }.into(),
    );
    if let Some(address) = exchange.step.address {
        let object = exchange.object;
        members.extend(object_members(
            address,
            object.map(|object| (&*object.name, object.data_type.name())),
        ));
    }
    if let Some(ended) = exchange.step.ended {
        let access = match ended.access {
            Access::Read => "read",
            Access::Write => "written",
        };
        members.insert("ended".into(), access.into());
        match ended.outcome {
            Outcome::Abort(code) => members.insert("abort".into(), format!("0x{:08X}", code.0).into()),
            Outcome::Unanswered | Outcome::Incomplete => members.insert("incomplete".into(), true.into()),
            Outcome::Value { .. } => members.insert("raw".into(), bytes(exchange.value).into()),
        };
    }
    if let Some(value) = exchange.transferred() {
        members.insert("value".into(), plain(&value));
    }
    members
}

fn object_members(address: Address, object: Option<(&str, &str)>) -> Map<String, Value> {
    let mut members = Map::new();
    members.insert("object".into(), address.to_string().into());
    if let Some((name, data_type)) = object {
        members.insert("name".into(), name.into());
        members.insert("type".into(), data_type.into());
    }
    members
}

fn pdo_members(pdo: &Received<'_>) -> Value {
    let values = pdo.values().map(|(field, value)| {
        let data_type = field.data_type.map(|data_type| (field.name, data_type.name()));
        let mut members = object_members(field.address, data_type);
        members.insert("value".into(), plain(&value));
        Value::Object(members)
    });
    let values: Vec<Value> = values.collect();
    json!({"number": pdo.number, "direction": direction_name(pdo.direction), "values": values, "mapped_bytes": pdo.mapped_length()})
}

fn multiplexed(pdo: &Multiplexed<'_>) -> Value {
    let object = pdo.object.map(|object| (&*object.name, object.data_type.name()));
    let mut members = object_members(pdo.address, object);
    members.insert("value".into(), plain(&pdo.value()));
    json!({"number": pdo.number, "direction": direction_name(pdo.direction), "receiver": pdo.receiver, "values": [members]})
}

/// Numbers as numbers, texts as text, bytes in hexadecimal; a real that is no number is null.
fn plain(value: &Plain) -> Value {
    match value {
        Plain::Boolean(value) => json!(value),
        Plain::Integer(value) => json!(value),
        Plain::Unsigned(value) | Plain::NodeIdPlus(value) => json!(value),
        Plain::Real32(value) => json!(value),
        Plain::Real64(value) => json!(value),
        Plain::Text(text) => json!(text),
        Plain::Bytes(data) => json!(bytes(data)),
        Plain::Time { days, milliseconds } => json!({"days": days, "milliseconds": milliseconds}),
    }
}
