//! The runtime's table. It is laid out as the table that it is, a row a line, which no formatter would do: hence
//! `#[rustfmt::skip]`, and text instead of syntax nodes.

use std::fmt::Write as _;

use lexican_eds::ir::AccessType;

use crate::{
    name::field_ident,
    plan::{Extra, Kind, Place, Plan, Row, Slot},
};

/// The constants that stand at the end of the module, indented as its items are.
pub(super) fn text(plan: &Plan<'_>) -> String {
    let parts = [
        table(plan),
        access(plan),
        rows(plan),
        seeds(plan),
        extras(plan),
        constants(plan),
    ];
    parts.join("\n")
}

fn table(plan: &Plan<'_>) -> String {
    format!(
        "    const TABLE: Table<'static> = Table {{
        entries: &place::<{}>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    }};
",
        plan.seeds.places
    )
}

/// The names of the access rights that occur.
fn access(plan: &Plan<'_>) -> String {
    let names = [
        ("RO", "Access::READ"),
        ("WO", "Access::WRITE"),
        ("RW", "Access::READ.with(Access::WRITE)"),
        ("CONST", "Access::READ.with(Access::CONSTANT)"),
    ];
    let used = names
        .iter()
        .filter(|(name, _)| plan.rows.iter().any(|row| access_name(row) == *name));
    used.fold(String::new(), |text, (name, value)| {
        text + "    const " + name + ": Access = " + value + ";\n"
    })
}

fn access_name(row: &Row<'_>) -> &'static str {
    match row.entry.access {
        _ if row.constant => "CONST",
        AccessType::Const | AccessType::Ro => "RO",
        AccessType::Wo => "WO",
        AccessType::Rw | AccessType::Rwr | AccessType::Rww => "RW",
    }
}

fn rows(plan: &Plan<'_>) -> String {
    let runs: Vec<&[Row<'_>]> = plan.rows.chunk_by(continues).collect();
    array("ROWS", "Row", runs.len(), runs.iter().map(|run| row(plan, run)))
}

/// Whether `next` is the element after `row` in an array, and like it.
fn continues(row: &Row<'_>, next: &Row<'_>) -> bool {
    let (a, b) = (row.entry, next.entry);
    let follows = a.address.index == b.address.index && a.address.sub.checked_add(1) == Some(b.address.sub);
    let alike = a.data_type == b.data_type && access_name(row) == access_name(next) && row.flags().eq(next.flags());
    follows && alike && slot_follows(row, next)
}

fn slot_follows(row: &Row<'_>, next: &Row<'_>) -> bool {
    let width = Kind::new(row.entry.data_type, 0).size();
    match (row.slot, next.slot) {
        (Slot::Extra(a), Slot::Extra(b)) => a + 1 == b,
        (Slot::Place(Place::Constant(a)), Slot::Place(Place::Constant(b))) => a + width == b,
        (Slot::Place(Place::Field(item, a)), Slot::Place(Place::Field(other, b))) => item == other && a + width == b,
        _ => false,
    }
}

fn row(plan: &Plan<'_>, run: &[Row<'_>]) -> String {
    let [first, rest @ ..] = run else { return String::new() };
    let address = first.entry.address;
    let constructor = match rest.last() {
        None => format!("value(0x{:04X}, 0x{:02X}", address.index, address.sub),
        Some(last) => format!(
            "elements(0x{:04X}, 0x{:02X}, 0x{:02X}",
            address.index, address.sub, last.entry.address.sub
        ),
    };
    let flags: String = first
        .flags()
        .fold(String::new(), |flags, flag| flags + ".with(Access::" + flag + ")");
    let slot = match first.slot {
        Slot::Place(place) => offset(plan, place),
        Slot::Extra(number) => number.to_string(),
    };
    let data_type = first.entry.data_type.name();
    format!(
        "Row::{constructor}, DataType::{data_type}, {}{flags}, {slot}),",
        access_name(first)
    )
}

/// `offset_of!(Dictionary, speed_value) + 2`, or the offset of a constant.
fn offset(plan: &Plan<'_>, place: Place) -> String {
    match place {
        Place::Constant(offset) => offset.to_string(),
        Place::Field(item, within) => {
            let name = plan
                .items
                .get(item)
                .map(|item| field_ident(&item.name))
                .unwrap_or_default();
            let within = if within == 0 {
                String::new()
            } else {
                format!(" + {within}")
            };
            format!("offset_of!(Dictionary, {name}){within}")
        }
    }
}

fn seeds(plan: &Plan<'_>) -> String {
    let lines = plan
        .seeds
        .seeds
        .chunks(16)
        .map(|line| joined(line.iter().map(ToString::to_string)));
    array("SEEDS", "u16", plan.seeds.seeds.len(), lines)
}

fn extras(plan: &Plan<'_>) -> String {
    let rows = plan.extras.iter().map(|extra| extra_row(plan, extra));
    array("EXTRAS", "Extra", plan.extras.len(), rows)
}

fn extra_row(plan: &Plan<'_>, extra: &Extra) -> String {
    let Extra { address, place, detail } = *extra;
    format!("Extra::new({}, {detail}), // {address}", offset(plan, place))
}

fn constants(plan: &Plan<'_>) -> String {
    let pieces = plan.pool.pieces.iter().flat_map(|(bytes, label)| piece(bytes, label));
    array("CONSTANTS", "u8", plan.pool.len(), pieces)
}

/// The bytes of a constant in lines of 16, the first with the object that needed it first.
fn piece(bytes: &[u8], label: &str) -> Vec<String> {
    let lines = bytes
        .chunks(16)
        .map(|line| joined(line.iter().map(|byte| format!("0x{byte:02X}"))));
    let mut lines: Vec<String> = lines.collect();
    if let Some(first) = lines.first_mut() {
        first.push_str(" // ");
        first.push_str(label);
    }
    lines
}

fn joined(values: impl Iterator<Item = String>) -> String {
    let values: Vec<String> = values.map(|value| value + ",").collect();
    values.join(" ")
}

/// A constant array, a row a line.
fn array(name: &str, rust_type: &str, length: usize, rows: impl Iterator<Item = String>) -> String {
    if length == 0 {
        return format!("    const {name}: [{rust_type}; 0] = [];\n");
    }
    let mut text = format!("    #[rustfmt::skip]\n    const {name}: [{rust_type}; {length}] = [\n");
    for row in rows {
        let _ = writeln!(text, "        {row}");
    }
    text.push_str("    ];\n");
    text
}
