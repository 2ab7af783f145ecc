//! What is wrong with the encoder: temperature, alarms, warnings, their emergency messages and their histories.

use lexican_runtime::{
    AbortCode, Emergency, Instant,
    profile::encoder::{Faults, Sensor},
    storage::{Group, Storage},
};

use crate::{encoder::Slave, memory::HISTORY, wdga::Dictionary};

/// How often the temperature is read, in ms (chapter 7.13).
const MINUTE: u32 = 60_000;
/// The class of errors that 1029h:02 is about (chapter 7.9).
const ENCODER_ERROR: u8 = 2;

/// 4200h: temperature out of tolerance (table 7.7).
const TEMPERATURE: u16 = 0x4200;
/// 5000h: hardware failure, of the EEPROM.
const HARDWARE: u16 = 0x5000;
/// Table 7.9, 5000h, info field 2: a value could not be written.
const WRITE_FAILED: u8 = 0x08;
/// Bit 3 of 1001h (chapter 7.13).
const REGISTER_TEMPERATURE: u8 = 0x08;

/// Bit 0 of 6503h.
const POSITION_ERROR: u16 = 0x0001;
/// Bits of 6505h (table 7.12).
const FREQUENCY: u16 = 0x0001;
const TOO_WARM: u16 = 0x1000;
const TOO_COLD: u16 = 0x2000;
const UNREADABLE: u16 = 0x4000;
/// Those of the temperature.
const THERMAL: u16 = TOO_WARM | TOO_COLD | UNREADABLE;

/// 1002h (table 7.10): what it says of the sensor's single turn, of its revolutions, and of the EEPROM.
const STATUS_SINGLE_TURN: u32 = 0x0000_0101;
const STATUS_REVOLUTIONS: u32 = 0x0000_0002;
const STATUS_EEPROM: u32 = 0x0000_0004;

/// What was found when the encoder was looked at last.
#[derive(Clone, Debug, Default)]
pub(crate) struct Health {
    temperature_due: Instant,
    is_temperature_unread: bool,
    has_eeprom_failed: bool,
    /// 1003h, as far as it is in 2502h.
    errors: [u32; 5],
    error_count: u8,
}

impl Health {
    /// Looks at the sensor, shows what is wrong, and tells it.
    pub(crate) fn look<S: Sensor, M: Storage>(&mut self, node: &mut Slave<M>, sensor: &mut S, now: Instant) {
        let faults = sensor.faults();
        let device = node.application_mut();
        let is_too_fast = device.handlers.measurement.is_too_fast();
        let od = &mut device.od;
        if now >= self.temperature_due {
            self.temperature_due = now.plus_millis(MINUTE);
            self.is_temperature_unread = !read_temperature(od, sensor);
        }
        let thermal = thermal(od, self.is_temperature_unread || faults.has(Faults::TEMPERATURE));
        let warnings = thermal | if is_too_fast { FREQUENCY } else { 0 };
        let alarms = alarms(faults);
        od.manufacturer_status_register = self.status(faults);
        let before = (od.alarms, od.warnings);
        (od.alarms, od.warnings) = (alarms, warnings);
        let is_new = note(od, before);
        tell_temperature(node, before.1 & THERMAL, thermal);
        if alarms & !before.0 != 0 {
            node.react_to_error(ENCODER_ERROR);
        }
        let has_failed = self.note_errors(&mut node.application_mut().od);
        if is_new || has_failed {
            self.save(node, HISTORY);
        }
    }

    /// Stores what is stored at once. A memory that fails is an error of its own, 5000h, until it does not.
    pub(crate) fn save<M: Storage>(&mut self, node: &mut Slave<M>, group: Group) {
        let saved = node.save(group);
        self.stored(node, saved);
    }

    /// The memory has done what it was to, or has not.
    pub(crate) fn stored<M: Storage>(&mut self, node: &mut Slave<M>, result: Result<(), AbortCode>) {
        // An encoder without a memory has none that fails.
        self.has_eeprom_failed = result == Err(AbortCode::HARDWARE_ERROR);
        if self.has_eeprom_failed {
            node.raise_emergency(Emergency::new(HARDWARE, 0).with([0, WRITE_FAILED, 0, 0, 0]));
        } else {
            node.clear_emergency(HARDWARE);
        }
    }

    fn status(&self, faults: Faults) -> u32 {
        let bits = [
            (faults.has(Faults::SINGLE_TURN), STATUS_SINGLE_TURN),
            (faults.has(Faults::REVOLUTIONS), STATUS_REVOLUTIONS),
            (self.has_eeprom_failed, STATUS_EEPROM),
        ];
        let set = bits.into_iter().filter(|(is_set, _)| *is_set);
        set.fold(0, |status, (_, bits)| status | bits)
    }

    /// Takes what is new in 1003h into 2502h; says whether there was anything.
    fn note_errors(&mut self, od: &mut Dictionary) -> bool {
        let errors = od.predefined_error_field;
        let count = od.predefined_error_field_number_of_errors;
        if (count, errors) == (self.error_count, self.errors) {
            return false;
        }
        let before = self.errors.get(..self.error_count.into()).unwrap_or(&self.errors);
        let now = errors.get(..count.into()).unwrap_or(&errors);
        // The newest comes first: behind those that are new stand the newest of before.
        let is_known = |new: &usize| now.get(*new..).is_some_and(|rest| before.starts_with(rest));
        let new = (0..now.len()).find(is_known).unwrap_or(now.len());
        for error in errors.iter().take(new).rev() {
            push(&mut od.error_history, *error);
        }
        (self.error_count, self.errors) = (count, errors);
        new != 0
    }
}

/// 2500h:01, :04 and :05; `false` when it cannot be read.
fn read_temperature<S: Sensor>(od: &mut Dictionary, sensor: &mut S) -> bool {
    let Some(temperature) = sensor.temperature() else {
        return false;
    };
    // Nothing measured yet: both extremes are the first value.
    let is_first = od.temperature_maximum < od.temperature_minimum;
    od.temperature_current = temperature;
    od.temperature_maximum = if is_first {
        temperature
    } else {
        od.temperature_maximum.max(temperature)
    };
    od.temperature_minimum = if is_first {
        temperature
    } else {
        od.temperature_minimum.min(temperature)
    };
    true
}

/// The warnings of the temperature.
const fn thermal(od: &Dictionary, is_unreadable: bool) -> u16 {
    if is_unreadable {
        UNREADABLE
    } else if od.temperature_current > od.temperature_upper_limit {
        TOO_WARM
    } else if od.temperature_current < od.temperature_lower_limit {
        TOO_COLD
    } else {
        0
    }
}

fn alarms(faults: Faults) -> u16 {
    let position = Faults::POSITION.with(Faults::SINGLE_TURN).with(Faults::REVOLUTIONS);
    if faults.has(position) { POSITION_ERROR } else { 0 }
}

/// Takes alarms and warnings that were not there `before` into 2503h and 2504h; says whether there are any.
fn note(od: &mut Dictionary, before: (u16, u16)) -> bool {
    let alarms = od.alarms & !before.0;
    let warnings = od.warnings & !before.1;
    if alarms != 0 {
        push(&mut od.alarm_history, alarms);
    }
    if warnings != 0 {
        push(&mut od.warning_history, warnings);
        let count = &mut od.warning_history_highest_sub_index_supported;
        *count = count.saturating_add(1).min(5);
    }
    alarms | warnings != 0
}

/// One message when a limit is crossed, and one when all is well again (chapter 7.13).
fn tell_temperature<M: Storage>(node: &mut Slave<M>, before: u16, now: u16) {
    if now != before {
        node.clear_emergency(TEMPERATURE);
    }
    // A reset forgets the message, not the cause.
    if now != 0 && !node.is_error_standing(TEMPERATURE) {
        let emergency = Emergency::new(TEMPERATURE, REGISTER_TEMPERATURE);
        node.raise_emergency(emergency.with([cause(now), 0, 0, 0, 0]));
    }
}

/// Table 7.9, 4200h, info field 1.
const fn cause(thermal: u16) -> u8 {
    match thermal {
        TOO_WARM => 0x10,
        TOO_COLD => 0x20,
        _ => 0x40,
    }
}

/// The newest first, the oldest is forgotten.
fn push<T: Copy>(history: &mut [T; 5], value: T) {
    let [a, b, c, d, _] = *history;
    *history = [value, a, b, c, d];
}
