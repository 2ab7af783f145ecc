//! Answers for the objects that are more than stored values.

use lexican_runtime::{
    AbortCode, Event,
    lss::BitRate,
    od::{Reset, VisibleString},
    profile::encoder::Shaft,
    wire::nmt::NmtState,
};

use crate::{
    Label,
    guard::in_preoperational,
    label::Variant,
    measurement::{Measurement, OPERATING_PARAMETERS, check, default_range},
    wdga::{Dictionary, Handlers},
};

/// What stands behind the dictionary: the state of the measurement, and what a client has asked for.
#[derive(Clone, Debug)]
pub struct Application {
    shaft: Shaft,
    label: Label,
    state: NmtState,
    pub(crate) measurement: Measurement,
    pub(crate) wishes: Wishes,
}

/// What is to be done when the node has taken a frame: a handler has neither the node nor its memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Wishes {
    /// 6000h to 6002h were written.
    pub(crate) measures_anew: bool,
    /// 2100h or 2101h was written.
    pub(crate) configures_bus: bool,
    /// 2120h was written.
    pub(crate) saves_customer_data: bool,
    /// The node was reset.
    pub(crate) starts_anew: bool,
}

impl Application {
    pub(crate) fn new(shaft: Shaft, label: Label) -> Self {
        Self {
            shaft,
            label,
            state: NmtState::Initialising,
            measurement: Measurement::new(shaft, &Dictionary::DEFAULTS),
            wishes: Wishes {
                starts_anew: true,
                ..Wishes::default()
            },
        }
    }

    /// Gives `od` what is individual to this encoder, before anything stored is loaded.
    pub(crate) fn label(&self, od: &mut Dictionary) {
        let label = self.label;
        od.identity_serial_number = label.serial_number;
        od.serial_number = [label.serial_number];
        // What is too long for its object is cut off.
        od.manufacturer_hardware_version = VisibleString::new(label.hardware_version.as_bytes());
        od.manufacturer_software_version = VisibleString::new(label.software_version.as_bytes());
        od.module_identification_maximum_position = i32::MAX;
        od.module_identification_minimum_position = 0;
        // No temperature was measured yet.
        (od.temperature_minimum, od.temperature_maximum) = (i16::MAX, i16::MIN);
    }

    /// The node starts, or was reset: all that is not stored is as after power-on.
    pub(crate) fn start(&mut self, od: &mut Dictionary) {
        if od.total_measuring_range == 0 {
            od.total_measuring_range = default_range(self.shaft);
        }
        self.measurement = Measurement::new(self.shaft, od);
    }

    /// Chapters 4.2, 8.3.3, 8.5.1: some parameters change in PRE-OPERATIONAL only.
    pub(crate) fn in_preoperational(&self) -> Result<(), AbortCode> {
        if self.state == NmtState::PreOperational {
            Ok(())
        } else {
            Err(AbortCode::DEVICE_STATE)
        }
    }

    fn variant(&self) -> Variant {
        Variant::of(self.shaft)
    }
}

impl Handlers for Application {
    fn event(&mut self, _: &mut Dictionary, event: Event) {
        match event {
            Event::State(state) => self.state = state,
            Event::Reset(reset) => {
                self.state = NmtState::Initialising;
                self.wishes.starts_anew |= reset == Reset::Node;
            }
            _ => {}
        }
    }

    fn read_device_type(&mut self, _: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(self.variant().device_type())
    }

    fn read_manufacturer_device_name(&mut self, _: &mut Dictionary) -> Result<VisibleString<10>, AbortCode> {
        Ok(VisibleString::new(self.variant().device_name().as_bytes()))
    }

    fn read_number_of_distinguishable_revolutions(&mut self, _: &mut Dictionary) -> Result<u16, AbortCode> {
        Ok(self.variant().revolutions())
    }

    fn write_baud_rate(&mut self, _: &mut Dictionary, value: u8) -> Result<(), AbortCode> {
        self.in_preoperational()?;
        BitRate::from_index(value).ok_or(AbortCode::INVALID_VALUE)?;
        self.wishes.configures_bus = true;
        Ok(())
    }

    fn write_node_id(&mut self, _: &mut Dictionary, _: u8) -> Result<(), AbortCode> {
        self.in_preoperational()?;
        self.wishes.configures_bus = true;
        Ok(())
    }

    fn write_customer_eeprom_area(&mut self, _: &mut Dictionary, _: u8, _: u32) -> Result<(), AbortCode> {
        self.wishes.saves_customer_data = true;
        Ok(())
    }

    fn write_warning_history_highest_sub_index_supported(
        &mut self,
        od: &mut Dictionary,
        value: u8,
    ) -> Result<(), AbortCode> {
        if value != 0 {
            return Err(AbortCode::INVALID_VALUE);
        }
        od.warning_history = [0; 5];
        Ok(())
    }

    fn write_operating_parameters(&mut self, _: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        if value & !OPERATING_PARAMETERS != 0 {
            return Err(AbortCode::INVALID_VALUE);
        }
        self.wishes.measures_anew = true;
        Ok(())
    }

    fn write_measuring_units_per_revolution(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        let is_possible = check(self.shaft, value, od.total_measuring_range).is_ok();
        if value > self.shaft.resolution() || !is_possible {
            return Err(AbortCode::VALUE_TOO_HIGH);
        }
        self.wishes.measures_anew = true;
        Ok(())
    }

    fn write_total_measuring_range(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        check(self.shaft, od.measuring_units_per_revolution, value)?;
        self.wishes.measures_anew = true;
        Ok(())
    }

    fn write_preset_value(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        self.measurement.preset(od, value)
    }

    fn write_high_precision_preset_value(&mut self, od: &mut Dictionary, value: u64) -> Result<(), AbortCode> {
        self.measurement.preset_precise(od, value)
    }

    // Chapter 8.5.1: the PDOs' parameters.
    in_preoperational! {
        write_tpdo_1_communication_cob_id: u32;
        write_tpdo_1_communication_transmission_type: u8;
        write_tpdo_1_communication_event_timer: u16;
        write_tpdo_1_mapping_number_of_mapped_objects: u8;
        write_tpdo_1_mapping: [u32];
        write_tpdo_2_communication_cob_id: u32;
        write_tpdo_2_communication_transmission_type: u8;
        write_tpdo_2_communication_event_timer: u16;
        write_tpdo_2_mapping_number_of_mapped_objects: u8;
        write_tpdo_2_mapping: [u32];
        write_tpdo_3_communication_cob_id: u32;
        write_tpdo_3_communication_transmission_type: u8;
        write_tpdo_3_communication_event_timer: u16;
        write_tpdo_3_mapping_number_of_mapped_objects: u8;
        write_tpdo_3_mapping: [u32];
        write_tpdo_4_communication_cob_id: u32;
        write_tpdo_4_communication_transmission_type: u8;
        write_tpdo_4_communication_event_timer: u16;
        write_tpdo_4_mapping_number_of_mapped_objects: u8;
        write_tpdo_4_mapping: [u32];
    }

    // Chapter 8.11: the cams.
    in_preoperational! {
        write_cam_enable_register: [u8];
        write_cam_polarity_register: [u8];
        write_cam_1_low_limit: [i32];
        write_cam_1_high_limit: [i32];
        write_cam_1_hysteresis: [u32];
        write_cam_2_low_limit: [i32];
        write_cam_2_high_limit: [i32];
        write_cam_2_hysteresis: [u32];
        write_cam_3_low_limit: [i32];
        write_cam_3_high_limit: [i32];
        write_cam_3_hysteresis: [u32];
        write_cam_4_low_limit: [i32];
        write_cam_4_high_limit: [i32];
        write_cam_4_hysteresis: [u32];
        write_cam_5_low_limit: [i32];
        write_cam_5_high_limit: [i32];
        write_cam_5_hysteresis: [u32];
        write_cam_6_low_limit: [i32];
        write_cam_6_high_limit: [i32];
        write_cam_6_hysteresis: [u32];
        write_cam_7_low_limit: [i32];
        write_cam_7_high_limit: [i32];
        write_cam_7_hysteresis: [u32];
        write_cam_8_low_limit: [i32];
        write_cam_8_high_limit: [i32];
        write_cam_8_hysteresis: [u32];
    }
}
