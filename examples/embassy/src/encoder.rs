//! The application: what stands behind the dictionary.

use lexican_runtime::AbortCode;

use crate::wdga::{Dictionary, Handlers};

/// Answers for the preset, which this encoder does not take while it is hot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Encoder;

impl Handlers for Encoder {
    fn read_preset_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(od.preset_value)
    }

    fn write_preset_value(&mut self, od: &mut Dictionary, _value: u32) -> Result<(), AbortCode> {
        if od.temperature_current > od.temperature_upper_limit {
            return Err(AbortCode::DEVICE_STATE);
        }
        Ok(())
    }
}
