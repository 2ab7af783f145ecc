//! The application: what stands behind the dictionary.

use lexican_runtime::AbortCode;

use crate::wdga::{Dictionary, Handlers};

/// An encoder whose shaft does not turn: it stands where the preset says.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Encoder;

impl Handlers for Encoder {
    fn read_preset_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(od.preset_value)
    }

    fn write_preset_value(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        od.position_value = value;
        Ok(())
    }
}
