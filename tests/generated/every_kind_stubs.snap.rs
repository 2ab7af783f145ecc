// The application behind `every_kind`. `lexican generate --stubs` wrote it as a start; it is yours now.

use lexican_runtime::{AbortCode, od::{Part, TimeOfDay, VisibleString}};

use crate::every_kind::{Dictionary, Handlers};

/// What answers for the objects that are not just stored.
#[derive(Clone, Debug, Default)]
pub(crate) struct App;

impl Handlers for App {
    /// 2600h `Switch`
    fn read_switch(&mut self, od: &mut Dictionary) -> Result<bool, AbortCode> {
        Ok(od.switch.get())
    }

    /// 2602h `Note`
    fn read_note(&mut self, od: &mut Dictionary) -> Result<VisibleString<3>, AbortCode> {
        Ok(od.note)
    }

    /// 2604h `Clock`
    fn read_clock(&mut self, od: &mut Dictionary) -> Result<TimeOfDay, AbortCode> {
        Ok(od.clock)
    }

    /// 2605h `Motto`
    fn read_motto(&mut self, od: &mut Dictionary) -> Result<VisibleString<23>, AbortCode> {
        Ok(od.motto)
    }

    /// 2606h `Switches`
    fn read_switches(&mut self, od: &mut Dictionary, sub: u8) -> Result<bool, AbortCode> {
        od.switches
            .get(usize::from(sub).wrapping_sub(1))
            .map(|value| value.get())
            .ok_or(AbortCode::NO_SUCH_SUB_INDEX)
    }

    /// 6004h `Position value`
    fn read_position_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(od.position_value)
    }

    /// 6030h `Speed value`
    fn read_speed_value(&mut self, od: &mut Dictionary, sub: u8) -> Result<i16, AbortCode> {
        od.speed_value
            .get(usize::from(sub).wrapping_sub(1))
            .copied()
            .ok_or(AbortCode::NO_SUCH_SUB_INDEX)
    }

    /// 1010h `Store parameters`
    fn write_store_parameters(
        &mut self,
        _od: &mut Dictionary,
        _sub: u8,
        _value: u32,
    ) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2300h `Limited list`
    fn write_limited_list(
        &mut self,
        _od: &mut Dictionary,
        _sub: u8,
        _value: i16,
    ) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2600h `Switch`
    fn write_switch(&mut self, _od: &mut Dictionary, _value: bool) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2601h `Command`
    fn write_command(&mut self, _od: &mut Dictionary, _value: u8) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2602h `Note`
    fn write_note(&mut self, _od: &mut Dictionary, _value: &[u8]) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2604h `Clock`
    fn write_clock(&mut self, _od: &mut Dictionary, _value: TimeOfDay) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2606h `Switches`
    fn write_switches(
        &mut self,
        _od: &mut Dictionary,
        _sub: u8,
        _value: bool,
    ) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 6003h `Preset value`
    fn write_preset_value(&mut self, _od: &mut Dictionary, _value: u32) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2603h `Program`
    fn read_program(
        &mut self,
        _od: &mut Dictionary,
        _offset: usize,
        _buffer: &mut [u8],
    ) -> Result<usize, AbortCode> {
        Err(AbortCode::NO_DATA)
    }

    /// 2607h `Report`
    fn read_report(
        &mut self,
        _od: &mut Dictionary,
        _offset: usize,
        _buffer: &mut [u8],
    ) -> Result<usize, AbortCode> {
        Err(AbortCode::NO_DATA)
    }

    /// 2603h `Program`
    fn write_program(&mut self, _od: &mut Dictionary, _part: Part<'_>) -> Result<(), AbortCode> {
        Ok(())
    }

    /// 2607h `Report`
    fn write_report(&mut self, _od: &mut Dictionary, _part: Part<'_>) -> Result<(), AbortCode> {
        Ok(())
    }
}
