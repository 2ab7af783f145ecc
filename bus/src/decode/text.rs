//! A frame as a line for people.
//!
//! ```text
//! 1436509052.249713 can0      585 43 18 10 01 9B 00 00 00    5 SDO    1018sub1 Identity object, Vendor-ID = 155 (9Bh)
//! time              channel   id  data                    node service what it says
//! ```

use std::fmt::Write as _;

use lexican_eds::ir::Value;
use lexican_runtime::{
    NodeId,
    wire::{
        Frame,
        emcy::Emergency,
        nmt::{NmtCommand, NmtState, Recipient},
        sdo::{Request, Response},
    },
};

use super::{
    Access, Direction, Ended, Exchange, Message, Multiplexed, Outcome, Received, Said, emergency::REGISTER, lss,
};
use crate::log::Record;

/// How many bytes of a long value are shown.
const LONGEST: usize = 32;

/// Appends the line, with its end.
pub fn write_text(line: &mut String, record: &Record, channel: &str, message: &Message<'_>) {
    write_frame(line, record, channel);
    let (node, service) = heading(message);
    match node {
        Some(node) => write_padded(line, node.get()),
        None => line.push_str("    "),
    }
    line.push(' ');
    let start = line.len();
    write_service(line, service, message);
    pad(line, start + 7);
    // Writing to memory does not fail.
    let _ = write_body(line, message);
    line.truncate(line.trim_end_matches(' ').len());
    line.push('\n');
}

fn write_frame(line: &mut String, record: &Record, channel: &str) {
    let micros = record.time.as_micros();
    let _ = write!(line, "{:10}.{:06} ", micros / 1_000_000, micros % 1_000_000);
    let start = line.len();
    line.push_str(channel);
    pad(line, start + 5);
    let id = record.frame.id();
    let digits = if id.is_extended() { 8 } else { 3 };
    (digits..9).for_each(|_| line.push(' '));
    push_hex(line, id.number(), digits);
    line.push(' ');
    let start = line.len();
    write_data(line, &record.frame);
    pad(line, start + 24);
}

fn write_data(line: &mut String, frame: &Frame) {
    if frame.is_remote() {
        let _ = write!(line, "remote, {} bytes", frame.length());
        return;
    }
    push_bytes(line, frame.data());
}

/// Blanks until the line, which has only ASCII in its columns, is `width` bytes long.
fn pad(line: &mut String, width: usize) {
    (line.len()..width).for_each(|_| line.push(' '));
}

fn write_padded(line: &mut String, number: u8) {
    let _ = write!(line, "{number:4}");
}

fn push_hex(line: &mut String, number: u32, digits: u32) {
    for place in (0..digits).rev() {
        line.push(
            char::from_digit(number >> (4 * place) & 0xF, 16)
                .unwrap_or('0')
                .to_ascii_uppercase(),
        );
    }
}

fn push_bytes(line: &mut String, bytes: &[u8]) {
    for (place, byte) in bytes.iter().enumerate() {
        if place > 0 {
            line.push(' ');
        }
        push_hex(line, u32::from(*byte), 2);
    }
}

/// Of which node it is, and the service.
pub(super) const fn heading(message: &Message<'_>) -> (Option<NodeId>, &'static str) {
    match message {
        Message::Nmt(_) => (None, "NMT"),
        Message::Sync(_) => (None, "SYNC"),
        Message::Time(_) => (None, "TIME"),
        Message::Emergency { node_id, .. } => (Some(*node_id), "EMCY"),
        Message::BootUp(node_id) => (Some(*node_id), "BOOT"),
        Message::Heartbeat { node_id, .. } => (Some(*node_id), "HB"),
        Message::Guarding(node_id) => (Some(*node_id), "GUARD"),
        Message::Sdo(exchange) => (Some(exchange.node_id), "SDO"),
        Message::Pdo(pdo) => (Some(pdo.node_id), direction_name(pdo.direction)),
        Message::Multiplexed(pdo) => (Some(pdo.node_id), direction_name(pdo.direction)),
        Message::LssRequest(_) | Message::LssResponse(_) => (None, "LSS"),
        Message::Malformed(service) => (None, service),
        Message::Unknown => (None, "?"),
    }
}

pub(super) const fn direction_name(direction: Direction) -> &'static str {
    match direction {
        Direction::Receive => "RPDO",
        Direction::Transmit => "TPDO",
    }
}

fn write_service(line: &mut String, service: &str, message: &Message<'_>) {
    line.push_str(service);
    let _ = match message {
        Message::Pdo(Received { number, .. }) | Message::Multiplexed(Multiplexed { number, .. }) => {
            write!(line, "{number}")
        }
        Message::Sdo(Exchange { server, .. }) if *server > 0 => write!(line, "{}", server + 1),
        _ => Ok(()),
    };
}

fn write_body(line: &mut String, message: &Message<'_>) -> std::fmt::Result {
    match message {
        Message::Nmt(request) => {
            line.push_str(command_name(request.command));
            match request.recipient {
                Recipient::All => line.write_str(" all nodes"),
                Recipient::One(node_id) => write!(line, " node {}", node_id.get()),
            }
        }
        Message::Sync(None) | Message::Unknown => Ok(()),
        Message::Sync(Some(counter)) => write!(line, "counter {counter}"),
        Message::Time(time) => write!(line, "{} days and {} ms since 1984", time.days(), time.milliseconds()),
        Message::Emergency { emergency, meaning, .. } => write_emergency(line, *emergency, meaning),
        Message::BootUp(_) => line.write_str("boot-up"),
        Message::Heartbeat { state, toggle, .. } => {
            line.push_str(state_name(*state));
            line.write_str(if *toggle { ", toggled" } else { "" })
        }
        Message::Guarding(_) => line.write_str("which state?"),
        Message::Sdo(exchange) => write_sdo(line, exchange),
        Message::Pdo(pdo) => write_pdo(line, pdo),
        Message::Multiplexed(pdo) => write_multiplexed(line, pdo),
        Message::LssRequest(request) => lss::write_request(line, *request),
        Message::LssResponse(response) => lss::write_response(line, *response),
        Message::Malformed(_) => line.write_str("not as the standard has it"),
    }
}

pub(super) const fn command_name(command: NmtCommand) -> &'static str {
    match command {
        NmtCommand::Start => "start",
        NmtCommand::Stop => "stop",
        NmtCommand::EnterPreOperational => "enter pre-operational",
        NmtCommand::ResetNode => "reset node",
        NmtCommand::ResetCommunication => "reset communication",
    }
}

pub(super) const fn state_name(state: NmtState) -> &'static str {
    match state {
        NmtState::Initialising => "initialising",
        NmtState::Stopped => "stopped",
        NmtState::Operational => "operational",
        NmtState::PreOperational => "pre-operational",
    }
}

fn write_emergency(line: &mut String, emergency: Emergency, meaning: &str) -> std::fmt::Result {
    write!(
        line,
        "{:04X}h {meaning}; register {:02X}h",
        emergency.code, emergency.register
    )?;
    for (bit, name) in REGISTER.iter().enumerate() {
        if emergency.register >> bit & 1 != 0 {
            write!(line, " {name}")?;
        }
    }
    if emergency.manufacturer != [0; 5] {
        line.push_str("; manufacturer ");
        push_bytes(line, &emergency.manufacturer);
    }
    Ok(())
}

/// `6004h Position value`, `1018sub1 Identity object, Vendor-ID`.
fn write_object(line: &mut String, exchange: &Exchange<'_>) -> std::fmt::Result {
    let Some(address) = exchange.step.address else {
        return line.write_str("a value whose beginning was not heard");
    };
    match exchange.object {
        Some(object) if object.is_alone => write!(line, "{:04X}h {}", address.index, object.name),
        Some(object) => write!(line, "{address} {}", object.name),
        None => write!(line, "{address}"),
    }
}

fn write_sdo(line: &mut String, exchange: &Exchange<'_>) -> std::fmt::Result {
    if let Some(left) = exchange.step.before {
        line.push_str("no answer for ");
        write!(line, "{}", left.address)?;
        line.push_str("; ");
    }
    match exchange.step.said {
        Said::Request(request) => write_request(line, exchange, request),
        Said::Response(response) => write_response(line, exchange, response),
        Said::Segment(segment) => {
            write_object(line, exchange)?;
            write!(line, ", segment {} of a block", segment.sequence)?;
            line.write_str(if segment.last { ", the last" } else { "" })
        }
    }
}

fn write_request(line: &mut String, exchange: &Exchange<'_>, request: Request) -> std::fmt::Result {
    match request {
        Request::UploadInitiate { .. } => line.push_str("read "),
        Request::BlockUploadInitiate { .. } => line.push_str("read in blocks "),
        Request::DownloadExpedited { value, .. } => {
            line.push_str("write ");
            write_object(line, exchange)?;
            line.push_str(" = ");
            return write_value(line, &exchange.value_as(value.length.is_some()));
        }
        Request::DownloadInitiate { size, .. } => return write_announced(line, "write ", exchange, size),
        Request::BlockDownloadInitiate { size, .. } => {
            return write_announced(line, "write in blocks ", exchange, size);
        }
        Request::DownloadSegment(segment) => {
            write_object(line, exchange)?;
            write!(line, ", {} bytes more", segment.length)?;
            return line.write_str(if segment.last { ", the last" } else { "" });
        }
        Request::UploadSegment { .. } => line.push_str("go on with "),
        Request::BlockUploadStart => line.push_str("begin with "),
        Request::BlockUploadAcknowledge { sequence, .. } => write!(line, "taken {sequence} segments of ")?,
        Request::BlockUploadEnd => line.push_str("taken the value"),
        Request::BlockDownloadEnd { .. } => line.push_str("that was all of "),
        Request::Abort { code, .. } => return write_abort(line, exchange, code.0),
        Request::Unknown { .. } => return line.write_str("unknown command"),
    }
    if exchange.step.address.is_some() {
        write_object(line, exchange)?;
    }
    Ok(())
}

fn write_response(line: &mut String, exchange: &Exchange<'_>, response: Response) -> std::fmt::Result {
    if let Response::Abort { code, .. } = response {
        return write_abort(line, exchange, code.0);
    }
    if let Response::Unknown { .. } = response {
        return line.write_str("unknown command");
    }
    if let (Response::BlockDownloadAcknowledge { sequence, .. }, None) = (response, exchange.step.ended) {
        write!(line, "taken {sequence} segments of ")?;
    }
    write_object(line, exchange)?;
    match (exchange.step.ended, response) {
        (Some(ended), _) => write_end(line, exchange, ended),
        (None, Response::UploadExpedited { .. }) => line.write_str(", an answer that was not asked for"),
        (None, Response::UploadInitiate { size, .. } | Response::BlockUploadInitiate { size, .. }) => {
            write_size(line, size)
        }
        (None, Response::UploadSegment(segment)) => write!(line, ", {} bytes more", segment.length),
        (None, Response::DownloadInitiate { .. } | Response::BlockDownloadInitiate { .. }) => line.write_str(", go on"),
        (None, Response::DownloadSegment { .. }) => line.write_str(", taken"),
        (None, _) => Ok(()),
    }
}

fn write_end(line: &mut String, exchange: &Exchange<'_>, ended: Ended) -> std::fmt::Result {
    match (ended.access, ended.outcome) {
        (Access::Read, Outcome::Value { sized }) => {
            line.push_str(" = ");
            write_value(line, &exchange.value_as(sized))
        }
        (Access::Write, Outcome::Value { sized }) => {
            line.push_str(" written: ");
            write_value(line, &exchange.value_as(sized))
        }
        _ => line.write_str(", which was not heard as a whole"),
    }
}

fn write_announced(line: &mut String, verb: &str, exchange: &Exchange<'_>, size: Option<u32>) -> std::fmt::Result {
    line.push_str(verb);
    write_object(line, exchange)?;
    write_size(line, size)
}

fn write_size(line: &mut String, size: Option<u32>) -> std::fmt::Result {
    match size {
        Some(size) => write!(line, ", {size} bytes follow"),
        None => line.write_str(", segments follow"),
    }
}

fn write_abort(line: &mut String, exchange: &Exchange<'_>, code: u32) -> std::fmt::Result {
    line.push_str("abort ");
    write_object(line, exchange)?;
    write!(line, ": {}", lexican_eds::dump::AbortCode(code))
}

fn write_pdo(line: &mut String, pdo: &Received<'_>) -> std::fmt::Result {
    if pdo.is_request {
        return line.write_str("asked for");
    }
    let mut separator = "";
    for (field, value) in pdo.values() {
        line.push_str(separator);
        separator = ", ";
        match field.name {
            "" => write!(line, "{}", field.address)?,
            name => line.push_str(name),
        }
        line.push_str(" = ");
        write_number(line, &value)?;
    }
    match (pdo.mapped_length(), pdo.length) {
        (mapped, length) if length < mapped => write!(line, "; {length} bytes, and {mapped} are mapped"),
        (mapped, length) if length > mapped => write!(line, "{separator}{} bytes that are not mapped", length - mapped),
        _ => Ok(()),
    }
}

fn write_multiplexed(line: &mut String, pdo: &Multiplexed<'_>) -> std::fmt::Result {
    match pdo.receiver {
        None => {}
        Some(0) => line.push_str("to all: "),
        Some(receiver) => write!(line, "to node {receiver}: ")?,
    }
    write!(line, "{}", pdo.address)?;
    if let Some(object) = pdo.object {
        write!(line, " {}", object.name)?;
    }
    line.push_str(" = ");
    write_number(line, &pdo.value())
}

/// A value, unsigned numbers in hexadecimal too.
fn write_value(line: &mut String, value: &Value) -> std::fmt::Result {
    write_number(line, value)?;
    match value {
        Value::Unsigned(number) if *number > 9 => write!(line, " ({number:X}h)"),
        _ => Ok(()),
    }
}

fn write_number(line: &mut String, value: &Value) -> std::fmt::Result {
    match value {
        Value::Boolean(value) => write!(line, "{value}"),
        Value::Integer(value) => write!(line, "{value}"),
        Value::Unsigned(value) | Value::NodeIdPlus(value) => write!(line, "{value}"),
        Value::Real32(value) => write!(line, "{value:?}"),
        Value::Real64(value) => write!(line, "{value:?}"),
        Value::Text(text) => write!(line, "{text:?}"),
        Value::Time { days, milliseconds } => write!(line, "{days} d {milliseconds} ms"),
        Value::Bytes(bytes) => {
            push_bytes(line, bytes.get(..LONGEST).unwrap_or(bytes));
            match bytes.len() {
                0 => line.write_str("no bytes"),
                length if length > LONGEST => write!(line, " … ({length} bytes)"),
                _ => Ok(()),
            }
        }
    }
}
