//! Reading a value: exists? access? handler? copy.

use super::{Access, Device, Entry, NumberSet, Value};
use crate::{AbortCode, Address};

/// What is at `address`, as a client reads it.
///
/// A sub-index FFh (an object's structure, CiA 301, 7.4.3) is an ordinary sub-index here: where the dictionary has no entry for
/// it, it does not exist.
///
/// # Errors
/// * [`AbortCode::NO_SUCH_OBJECT`], [`AbortCode::NO_SUCH_SUB_INDEX`]
/// * [`AbortCode::WRITE_ONLY`]
/// * [`AbortCode::NO_DATA`] for an element beyond those that there are ([`Access::COUNTED`])
/// * what [`Device::before_read`] refuses with
/// * [`AbortCode::UNSUPPORTED_ACCESS`] for a value in parts, which an SDO client alone can read
pub fn read<D: Device>(device: &mut D, address: Address) -> Result<Value<'_>, AbortCode> {
    let entry = readable(device, address)?;
    refuse_parts(entry)?;
    load(device, entry)
}

/// The entry at `address`, once a client may read it and the application has brought it up to date.
///
/// # Errors
/// As [`read`].
pub fn readable<D: Device>(device: &mut D, address: Address) -> Result<Entry, AbortCode> {
    let Some(entry) = device.table().find(address) else {
        return Err(absent(device, address));
    };
    if !entry.access.has(Access::READ) {
        return Err(AbortCode::WRITE_ONLY);
    }
    if entry.access.has_any(Access::READ_HANDLER.with(Access::COUNTED)) {
        prepare(device, entry)?;
    }
    Ok(entry)
}

/// Brings the value of `entry` up to date, if there is one.
#[inline(never)]
fn prepare<D: Device>(device: &mut D, entry: Entry) -> Result<(), AbortCode> {
    if entry.access.has(Access::READ_HANDLER) {
        device.before_read(entry.address())?;
    }
    let count = Address::new(entry.index, 0);
    if entry.access.has(Access::COUNTED) && u32::from(entry.sub) > parameter(device, count) {
        return Err(AbortCode::NO_DATA);
    }
    Ok(())
}

/// The value of `entry`, without asking anyone.
///
/// # Errors
/// [`AbortCode::INTERNAL_INCOMPATIBILITY`] for an entry that is not of this device's table.
pub fn load<D: Device>(device: &D, entry: Entry) -> Result<Value<'_>, AbortCode> {
    value(device, entry).ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)
}

/// The number at `address`, for a service that needs its own parameter: neither access nor handlers count. `None` when
/// there is none.
pub fn number<D: Device>(device: &D, address: Address) -> Option<u64> {
    match value(device, device.table().find(address)?)? {
        Value::Number { bits, .. } => Some(bits),
        Value::Bytes(_) => None,
    }
}

/// [`number`] of a parameter of at most 32 bits; 0 for a device without it.
#[inline(never)]
pub fn parameter<D: Device>(device: &D, address: Address) -> u32 {
    configured(device, address).unwrap_or(0)
}

/// The same; `None` for a device without it.
#[inline(never)] // One copy for all parameters: they are looked at seldom.
pub fn configured<D: Device>(device: &D, address: Address) -> Option<u32> {
    number(device, address).and_then(|bits| u32::try_from(bits).ok())
}

/// Refuses a value that does not stand in the dictionary.
pub(super) const fn refuse_parts(entry: Entry) -> Result<(), AbortCode> {
    if entry.access.has(Access::PARTS) {
        return Err(AbortCode::UNSUPPORTED_ACCESS);
    }
    Ok(())
}

/// Why there is no entry at `address`.
#[cold]
#[inline(never)]
pub(super) fn absent<D: Device>(device: &D, address: Address) -> AbortCode {
    if device.table().has_object(address.index) {
        AbortCode::NO_SUCH_SUB_INDEX
    } else {
        AbortCode::NO_SUCH_OBJECT
    }
}

fn value<D: Device>(device: &D, entry: Entry) -> Option<Value<'_>> {
    let table = device.table();
    let (slot, detail) = table.locate(entry)?;
    let constant = entry.access.has(Access::CONSTANT);
    let bytes = if constant { table.constants } else { device.values() };
    let bytes = bytes.get(slot..)?;
    if entry.data_type.length() == 0 {
        return string(bytes, detail, constant).map(Value::Bytes);
    }
    let bits = bits::<D>(bytes, entry.data_type.width(), constant)?;
    Some(Value::Number {
        bits,
        data_type: entry.data_type,
    })
}

/// The string at the start of `bytes`: a constant has the length `detail`, another one says its own.
fn string(bytes: &[u8], detail: usize, constant: bool) -> Option<&[u8]> {
    if constant {
        return bytes.get(..detail);
    }
    let (length, bytes) = bytes.split_first_chunk::<2>()?;
    bytes.get(..usize::from(u16::from_le_bytes(*length)).min(detail))
}

/// The number of `width` bytes at the start of `bytes`: a constant is little-endian, another one as the target has it.
pub(super) fn bits<D: Device>(bytes: &[u8], width: usize, constant: bool) -> Option<u64> {
    let swap = cfg!(target_endian = "big") && !constant;
    match width {
        1 => bytes.first().map(|byte| u64::from(*byte)),
        2 => {
            let bits = u16::from_le_bytes(*bytes.first_chunk()?);
            Some(u64::from(if swap { bits.swap_bytes() } else { bits }))
        }
        4 => {
            let bits = u32::from_le_bytes(*bytes.first_chunk()?);
            Some(u64::from(if swap { bits.swap_bytes() } else { bits }))
        }
        _ if !D::NUMBERS.has(NumberSet::LONG) => None,
        6 => {
            // TIME_OF_DAY stands as on the bus, on every target.
            let [b0, b1, b2, b3, b4, b5] = *bytes.first_chunk()?;
            Some(u64::from_le_bytes([b0, b1, b2, b3, b4, b5, 0, 0]))
        }
        _ => {
            let bits = u64::from_le_bytes(*bytes.first_chunk()?);
            Some(if swap { bits.swap_bytes() } else { bits })
        }
    }
}
