//! What stands behind the dictionary: the sensor, what is computed from it, and what a write brings about.

mod checks;
mod measure;

pub(crate) use measure::Causes;

use lexican_runtime::{
    AbortCode, Event, Instant, NmtState, NodeId,
    od::VisibleString,
    profile::encoder::{Position, Sensor},
    storage::Group,
};

use crate::{
    WrongSensor,
    bus_error::BusErrors,
    speed::Speed,
    variant::{Identity, Variant},
    wv58mr::{Dictionary, Handlers},
};

/// An encoder's application.
#[derive(Debug)]
pub struct Application<S> {
    sensor: S,
    variant: Variant,
    identity: Identity,
    state: NmtState,
    position: Position,
    /// What calibration adds to the measured value.
    zero: i64,
    speed: Speed,
    pub(crate) bus_errors: BusErrors,
    pub(crate) orders: Orders,
}

/// What the node is to do that a write or an event has asked for.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Orders {
    /// 1800h:05 is to have this value, that of 6200h.
    pub(crate) event_timer: Option<u16>,
    /// 5F0Ah:01.
    pub(crate) node_id: Option<NodeId>,
    /// 5F0Ah:02.
    pub(crate) bit_rate: Option<u8>,
    /// Parameters with 5F0Ah among them were saved.
    pub(crate) saves: bool,
    /// Parameters with 5F0Ah among them are to be as delivered.
    pub(crate) restores: bool,
    /// The node was reset.
    pub(crate) was_reset: bool,
}

impl<S: Sensor> Application<S> {
    /// The application of an encoder with this sensor.
    pub(crate) fn new(sensor: S, identity: Identity) -> Result<Self, WrongSensor> {
        let shaft = sensor.shaft();
        let variant = Variant::of(shaft).ok_or(WrongSensor)?;
        let position = measure::position(variant, &Dictionary::DEFAULTS).map_err(|_| WrongSensor)?;
        Ok(Self {
            sensor,
            variant,
            identity,
            state: NmtState::Initialising,
            position,
            zero: 0,
            speed: Speed::new(),
            bus_errors: BusErrors::default(),
            orders: Orders::default(),
        })
    }

    /// Gives the dictionary what differs from one encoder to the other, and takes what is stored.
    pub(crate) fn start(&mut self, od: &mut Dictionary) {
        od.device_type = self.variant.device_type();
        od.manufacturer_device_name = VisibleString::new(self.identity.model.name().as_bytes());
        od.identity_serial_number = self.identity.serial_number();
        od.encoder_serial_number = self.identity.encoder_serial_number();
        od.number_of_distinguishable_revolutions = self.variant.revolutions();
        self.zero = i64::from(od.offset_value) - i64::from(od.application_offset);
        link_cycle_timer(od);
        self.scale(od);
    }

    /// Which encoder it is.
    pub(crate) const fn variant(&self) -> Variant {
        self.variant
    }

    /// What the device was given when it was made.
    pub(crate) const fn identity(&self) -> Identity {
        self.identity
    }

    /// The sensor.
    pub(crate) fn sensor_mut(&mut self) -> &mut S {
        &mut self.sensor
    }
}

/// 6200h and 1800h:05 are one value in two places, which may have been stored apart: then the timer that runs counts.
fn link_cycle_timer(od: &mut Dictionary) {
    if od.tpdo_1_communication_event_timer == 0 {
        od.tpdo_1_communication_event_timer = od.cycle_timer;
    }
    od.cycle_timer = od.tpdo_1_communication_event_timer;
}

/// Whether 5F0Ah is in a group.
fn has_node_id(group: Group) -> bool {
    group.includes(Group::MANUFACTURER)
}

impl<S: Sensor> Handlers for Application<S> {
    fn event(&mut self, od: &mut Dictionary, event: Event) {
        match event {
            Event::State(state) => self.state = state,
            Event::Reset(_) => {
                self.state = NmtState::Initialising;
                self.orders.was_reset = true;
                self.start(od);
            }
            Event::Saved(group) => self.orders.saves |= has_node_id(group),
            Event::Restored(group) => self.orders.restores |= has_node_id(group),
            _ => {}
        }
    }

    fn read_device_type(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode> {
        Ok(od.device_type)
    }

    fn read_manufacturer_device_name(&mut self, od: &mut Dictionary) -> Result<VisibleString<6>, AbortCode> {
        Ok(od.manufacturer_device_name)
    }

    fn write_cob_id_sync_message(&mut self, _: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        self.check_state()?;
        checks::sync(value)
    }

    fn write_cob_id_emergency_message(&mut self, _: &mut Dictionary, _: u32) -> Result<(), AbortCode> {
        self.check_state()
    }

    fn write_producer_heartbeat_time(&mut self, _: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        checks::heartbeat(value)
    }

    fn write_tpdo_1_communication_cob_id(&mut self, _: &mut Dictionary, _: u32) -> Result<(), AbortCode> {
        self.check_state()
    }

    fn write_tpdo_1_communication_transmission_type(&mut self, _: &mut Dictionary, value: u8) -> Result<(), AbortCode> {
        checks::asynchronous(value)
    }

    fn write_tpdo_1_communication_event_timer(&mut self, od: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        od.cycle_timer = value;
        Ok(())
    }

    fn write_tpdo_2_communication_cob_id(&mut self, _: &mut Dictionary, _: u32) -> Result<(), AbortCode> {
        self.check_state()
    }

    fn write_tpdo_2_communication_transmission_type(&mut self, _: &mut Dictionary, value: u8) -> Result<(), AbortCode> {
        checks::synchronous(value)
    }

    fn write_application_offset(&mut self, od: &mut Dictionary, value: i32) -> Result<(), AbortCode> {
        checks::application_offset(self.variant, value)?;
        self.shift(od, value);
        Ok(())
    }

    fn write_calibrate_encoder_value(&mut self, od: &mut Dictionary, value: u8) -> Result<(), AbortCode> {
        checks::only(value, 1)?;
        self.calibrate(od)
    }

    fn write_node_id_and_baud_rate(&mut self, _: &mut Dictionary, sub: u8, value: u8) -> Result<(), AbortCode> {
        match sub {
            1 => self.orders.node_id = NodeId::new(value),
            _ => self.orders.bit_rate = Some(value),
        }
        Ok(())
    }

    fn write_operating_parameters(&mut self, od: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        checks::operating_parameters(value)?;
        od.operating_parameters = value;
        self.scale(od);
        Ok(())
    }

    fn write_measuring_units_per_revolution(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        od.measuring_units_per_revolution = value;
        self.scale(od);
        Ok(())
    }

    fn write_total_measuring_range(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        checks::only(value, od.total_measuring_range)
    }

    fn write_preset_value(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        checks::position(od, value)
    }

    fn write_speed_parameters_speed_source_selector(&mut self, _: &mut Dictionary, value: u8) -> Result<(), AbortCode> {
        checks::only(value, 2)
    }

    fn write_speed_parameters_speed_multiplier(&mut self, _: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        checks::only(value, 1)
    }

    fn write_speed_parameters_speed_divisor(&mut self, _: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        checks::only(value, 1)
    }

    fn write_cycle_timer(&mut self, _: &mut Dictionary, value: u16) -> Result<(), AbortCode> {
        self.orders.event_timer = Some(value);
        Ok(())
    }

    fn write_work_area_low_limit(&mut self, od: &mut Dictionary, _: u8, value: i32) -> Result<(), AbortCode> {
        checks::limit(od, value)
    }

    fn write_work_area_high_limit(&mut self, od: &mut Dictionary, _: u8, value: i32) -> Result<(), AbortCode> {
        checks::limit(od, value)
    }
}

impl<S: Sensor> Application<S> {
    /// Takes what was noted since the last call.
    pub(crate) fn take_orders(&mut self) -> Orders {
        core::mem::take(&mut self.orders)
    }

    /// Brings what is measured up to date; says what is wrong.
    pub(crate) fn sample(&mut self, od: &mut Dictionary, now: Instant) -> Causes {
        self.measure(od, now)
    }

    fn check_state(&self) -> Result<(), AbortCode> {
        checks::state(self.state)
    }
}
