//! Writing a value: exists? access? length? limits? service? handler? store. The first that says no names the abort code.

use super::{limits, read, Access, Device, Entry, NumberSet, ServiceSet, Services, Value};
use crate::{AbortCode, Address};

/// Writes `data`, as it came from the bus, to `address`, as a client does.
///
/// # Errors
/// In this order, and then nothing is stored:
/// * [`AbortCode::NO_SUCH_OBJECT`], [`AbortCode::NO_SUCH_SUB_INDEX`]
/// * [`AbortCode::READ_ONLY`]
/// * [`AbortCode::TOO_LONG`], [`AbortCode::TOO_SHORT`]
/// * [`AbortCode::INVALID_VALUE`] for a BOOLEAN above 1 or a REAL that is no number
/// * [`AbortCode::VALUE_TOO_HIGH`], [`AbortCode::VALUE_TOO_LOW`]
/// * what a service refuses with ([`Services::before_write`])
/// * what the application refuses with ([`Device::before_write`])
/// * [`AbortCode::UNSUPPORTED_ACCESS`] for a value in parts, which an SDO client alone can write
pub fn write<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    address: Address,
    data: &[u8],
) -> Result<(), AbortCode> {
    let entry = writable(device, address)?;
    read::refuse_parts(entry)?;
    store(device, services, entry, data)
}

/// The entry at `address`, once a client may write it.
///
/// # Errors
/// * [`AbortCode::NO_SUCH_OBJECT`], [`AbortCode::NO_SUCH_SUB_INDEX`]
/// * [`AbortCode::READ_ONLY`]
pub fn writable<D: Device>(device: &D, address: Address) -> Result<Entry, AbortCode> {
    let Some(entry) = device.table().find(address) else {
        return Err(read::absent(device, address));
    };
    if !entry.access.has(Access::WRITE) {
        return Err(AbortCode::READ_ONLY);
    }
    Ok(entry)
}

/// How many bytes `entry` takes at most. A number takes no fewer either.
pub fn capacity<D: Device>(device: &D, entry: Entry) -> usize {
    match entry.data_type.length() {
        0 => device.table().locate(entry).map_or(0, |(_, capacity)| capacity),
        length => length,
    }
}

/// Refuses a value of `length` bytes that `entry` cannot take.
///
/// # Errors
/// [`AbortCode::TOO_LONG`], [`AbortCode::TOO_SHORT`]
pub fn check_length<D: Device>(device: &D, entry: Entry, length: usize) -> Result<(), AbortCode> {
    if length > capacity(device, entry) {
        return Err(AbortCode::TOO_LONG);
    }
    if length < entry.data_type.length() {
        return Err(AbortCode::TOO_SHORT);
    }
    Ok(())
}

/// Writes `data` to `entry`, which [`writable`] gave.
///
/// # Errors
/// As [`write()`], from the length on.
pub fn store<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    entry: Entry,
    data: &[u8],
) -> Result<(), AbortCode> {
    check_length(device, entry, data.len())?;
    if entry.data_type.length() == 0 {
        return store_string(device, services, entry, data);
    }
    store_number(device, services, entry, number(data))
}

/// Stores `data` at `address` as the application does: only its length is checked, nobody is asked.
///
/// # Errors
/// * [`AbortCode::NO_SUCH_OBJECT`], [`AbortCode::NO_SUCH_SUB_INDEX`]
/// * [`AbortCode::READ_ONLY`] for a constant
/// * [`AbortCode::TOO_LONG`], [`AbortCode::TOO_SHORT`]
pub fn set<D: Device>(device: &mut D, address: Address, data: &[u8]) -> Result<(), AbortCode> {
    let Some(entry) = device.table().find(address) else {
        return Err(read::absent(device, address));
    };
    if entry.access.has(Access::CONSTANT) {
        return Err(AbortCode::READ_ONLY);
    }
    check_length(device, entry, data.len())?;
    let stored = match entry.data_type.length() {
        0 => put_string(device, entry, data),
        _ => put(device, entry, limits::stored::<D>(entry.data_type, number(data))),
    };
    stored.ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)
}

/// As [`set`], but a number is to be within its limits.
///
/// # Errors
/// As [`set`], and as [`write()`] for a number beyond its limits.
pub(crate) fn set_within_limits<D: Device>(device: &mut D, address: Address, data: &[u8]) -> Result<(), AbortCode> {
    if let Some(entry) = device
        .table()
        .find(address)
        .filter(|entry| entry.data_type.length() != 0)
    {
        check_length(device, entry, data.len())?;
        limits::check(device, entry, limits::stored::<D>(entry.data_type, number(data)))?;
    }
    set(device, address, data)
}

/// Writes a number of the right length to `entry`; bits of `bits` beyond that length mean nothing.
pub(crate) fn store_number<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    entry: Entry,
    bits: u64,
) -> Result<(), AbortCode> {
    let bits = limits::stored::<D>(entry.data_type, bits);
    limits::check(device, entry, bits)?;
    let value = Value::Number {
        bits,
        data_type: entry.data_type,
    };
    ask(device, services, entry, value)?;
    put(device, entry, bits).ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
    tell(device, services, entry);
    Ok(())
}

fn store_string<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    entry: Entry,
    data: &[u8],
) -> Result<(), AbortCode> {
    ask(device, services, entry, Value::Bytes(data))?;
    put_string(device, entry, data).ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
    tell(device, services, entry);
    Ok(())
}

/// Up to eight bytes as they came from the bus.
fn number(data: &[u8]) -> u64 {
    let mut bytes = [0; 8];
    for (byte, from) in bytes.iter_mut().zip(data) {
        *byte = *from;
    }
    u64::from_le_bytes(bytes)
}

/// Whether `entry` is an object of the communication services, 1000h to 1FFFh.
fn is_communication(entry: Entry) -> bool {
    entry.index & 0xF000 == 0x1000
}

/// Asks all that may refuse the value.
fn ask<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    entry: Entry,
    value: Value<'_>,
) -> Result<(), AbortCode> {
    if is_communication(entry) {
        services.before_write(device, entry.address(), value)?;
    }
    if entry.access.has(Access::WRITE_HANDLER) {
        device.before_write(entry.address(), value)?;
    }
    Ok(())
}

/// Tells the services that the value is stored.
fn tell<D: Device>(device: &mut D, services: &mut impl Services, entry: Entry) {
    if is_communication(entry) || D::SERVICES.has(ServiceSet::VERIFY_CONFIGURATION) {
        services.after_write(device, entry.address());
    }
}

/// Stores a number in the target's byte order.
pub(super) fn put<D: Device>(device: &mut D, entry: Entry, bits: u64) -> Option<()> {
    let (slot, _) = device.table().locate(entry)?;
    let place = device.values_mut().get_mut(slot..)?;
    let [b0, b1, b2, b3, b4, b5, ..] = bits.to_le_bytes();
    match entry.data_type.width() {
        1 => *place.first_mut()? = b0,
        2 => *place.first_chunk_mut()? = u16::from_le_bytes([b0, b1]).to_ne_bytes(),
        4 => *place.first_chunk_mut()? = u32::from_le_bytes([b0, b1, b2, b3]).to_ne_bytes(),
        _ if !D::NUMBERS.has(NumberSet::LONG) => return None,
        6 => *place.first_chunk_mut()? = [b0, b1, b2, b3, b4, b5],
        _ => *place.first_chunk_mut()? = bits.to_ne_bytes(),
    }
    Some(())
}

/// Stores a string: its length in two bytes, little-endian, then its bytes.
fn put_string<D: Device>(device: &mut D, entry: Entry, data: &[u8]) -> Option<()> {
    let (slot, _) = device.table().locate(entry)?;
    let (length, bytes) = device.values_mut().get_mut(slot..)?.split_first_chunk_mut::<2>()?;
    *length = u16::try_from(data.len()).ok()?.to_le_bytes();
    bytes.get_mut(..data.len())?.copy_from_slice(data);
    Some(())
}
