//! LSS in words (CiA 305).

use std::fmt::{Result, Write as _};

use lexican_runtime::wire::lss::{Bound, FastScan, Part, Request, Response};

/// What the master asks for.
pub(super) fn write_request(line: &mut String, request: Request) -> Result {
    match request {
        Request::SwitchGlobal(0) => line.write_str("all slaves to waiting state"),
        Request::SwitchGlobal(1) => line.write_str("all slaves to configuration state"),
        Request::SwitchGlobal(mode) => write!(line, "all slaves to state {mode}"),
        Request::SwitchSelective(part, number) => write!(line, "select {} {number:08X}h", name(part)),
        Request::ConfigureNodeId(node_id) => write!(line, "configure node-ID {node_id}"),
        Request::ConfigureBitTiming { table, index } => {
            write!(line, "configure bit timing {index} of table {table}")
        }
        Request::ActivateBitTiming(delay) => write!(line, "activate bit timing after {delay} ms"),
        Request::Store => line.write_str("store configuration"),
        Request::Identify(bound, number) => {
            write!(line, "identify {}{} {number:08X}h", name(bound.part()), relation(bound))
        }
        Request::IdentifyNonConfigured => line.write_str("identify slaves without node-ID"),
        Request::FastScan(FastScan {
            bit_check: FastScan::START,
            ..
        }) => line.write_str("fastscan, any slave?"),
        Request::FastScan(scan) => {
            let part = name(Part::from_number(scan.sub));
            write!(
                line,
                "fastscan {part} {:08X}h from bit {}",
                scan.id_number, scan.bit_check
            )
        }
        Request::Inquire(part) => write!(line, "inquire {}", name(part)),
        Request::InquireNodeId => line.write_str("inquire node-ID"),
    }
}

/// What a slave answers.
pub(super) fn write_response(line: &mut String, response: Response) -> Result {
    match response {
        Response::Selected => line.write_str("selected"),
        Response::NodeIdConfigured(code) => write_code(line, "node-ID configured", code),
        Response::BitTimingConfigured(code) => write_code(line, "bit timing configured", code),
        Response::Stored(code) => write_code(line, "configuration stored", code),
        Response::Identified => line.write_str("identified"),
        Response::NonConfigured => line.write_str("a slave without node-ID"),
        Response::Identity(part, number) => write!(line, "{} is {number:08X}h", name(part)),
        Response::NodeId(255) => line.write_str("node-ID is not configured"),
        Response::NodeId(node_id) => write!(line, "node-ID is {node_id}"),
    }
}

fn write_code(line: &mut String, what: &str, code: u8) -> Result {
    match code {
        0 => line.write_str(what),
        code => write!(line, "not {what}, error {code}"),
    }
}

const fn name(part: Part) -> &'static str {
    match part {
        Part::VendorId => "vendor-ID",
        Part::ProductCode => "product code",
        Part::RevisionNumber => "revision number",
        Part::SerialNumber => "serial number",
    }
}

const fn relation(bound: Bound) -> &'static str {
    match bound {
        Bound::VendorId | Bound::ProductCode => "",
        Bound::RevisionLow | Bound::SerialLow => " from",
        Bound::RevisionHigh | Bound::SerialHigh => " up to",
    }
}
