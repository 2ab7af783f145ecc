//! The application: what stands behind the dictionary.

use lexican_runtime::{AbortCode, Event, NmtState};

use crate::wdga::{Dictionary, Handlers};

/// Measuring units from one end to the other.
const RANGE: u32 = 1 << 29;

/// An encoder whose shaft turns by itself, and warms up as it does.
#[derive(Clone, Debug)]
pub(crate) struct Encoder {
    /// Of the shaft, in measuring units.
    shaft: u32,
    /// What the preset adds to it.
    offset: u32,
    is_turning: bool,
}

impl Encoder {
    pub(crate) fn new() -> Self {
        Self {
            shaft: 0,
            offset: 0,
            is_turning: false,
        }
    }

    /// What the motor does in 10 ms.
    pub(crate) fn turn(&mut self) {
        if self.is_turning {
            self.shaft += 100;
        }
    }

    pub(crate) fn position(&self) -> u32 {
        self.shaft.wrapping_add(self.offset)
    }

    /// In degrees Celsius.
    pub(crate) fn temperature(&self) -> i16 {
        if (300..600).contains(&self.shaft) { 120 } else { 20 }
    }
}

impl Handlers for Encoder {
    /// The motor turns while the node is OPERATIONAL.
    fn event(&mut self, _od: &mut Dictionary, event: Event) {
        if let Event::State(state) = event {
            self.is_turning = state == NmtState::Operational;
        }
    }

    fn read_preset_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(od.preset_value)
    }

    /// From now on the position counts from `value`, which is stored when this gives `Ok`.
    fn write_preset_value(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        if value >= RANGE {
            return Err(AbortCode::VALUE_TOO_HIGH);
        }
        self.offset = value.wrapping_sub(self.shaft);
        od.position_value = value;
        Ok(())
    }
}
