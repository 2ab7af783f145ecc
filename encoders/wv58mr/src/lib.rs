#![doc = include_str!("../README.md")]
//!
//! # The parts
//!
//! * [`wv58mr`]: the object dictionary, generated from `wv58mr.eds` of lexican-eds.
//! * [`Variant`], [`Model`], [`Channel`], [`Identity`]: what differs from one encoder to the other.
//! * [`Application`]: what stands behind the dictionary; what is measured, what may be written, what a write brings about.
//! * [`Encoder`]: a node with its application, [`Memory`], LEDs and emergencies.
//! * [`Housing`]: both encoders.
//!
//! Chapters named here are those of the manual 099/22.

#![no_std]

mod application;
mod baud_rate;
mod bus_error;
mod encoder;
mod housing;
mod led;
mod memory;
mod speed;
mod variant;

include!(concat!(env!("OUT_DIR"), "/wv58mr.rs"));

pub use application::Application;
pub use bus_error::{BusError, BusErrors};
pub use encoder::Encoder;
pub use housing::Housing;
pub use led::{ErrorCounters, Leds};
pub use memory::Memory;
pub use variant::{Channel, Identity, Model, RESOLUTION, Variant};

/// A sensor that none of the encoders has: its shaft has not 16,384 steps a revolution, and 1, 16, 256 or 4096 revolutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongSensor;

impl core::fmt::Display for WrongSensor {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the sensor has not 16,384 steps a revolution, or not 1, 16, 256 or 4096 revolutions")
    }
}

impl core::error::Error for WrongSensor {}
