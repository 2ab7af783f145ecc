//! The Wachendorff WDGA absolute encoder with CANopen: its dictionary and its behaviour, over any [`Sensor`] and any
//! [`Storage`](lexican_runtime::storage::Storage). On a microcontroller it is the encoder's firmware, on a host a virtual encoder.
//!
//! ```
//! use lexican_runtime::{profile::encoder::{Reading, Sensor, Shaft}, storage::NoStorage, wire::CanId, Frame, Instant};
//! use lexican_wdga::{shaft, BitRate, Encoder, Label, Variant};
//!
//! struct Still;
//!
//! impl Sensor for Still {
//!     fn shaft(&self) -> Shaft {
//!         shaft(Variant::Multiturn)
//!     }
//!     fn reading(&mut self) -> Reading {
//!         Reading { turn: 0, angle: 100 }
//!     }
//!     fn temperature(&mut self) -> Option<i16> {
//!         Some(20)
//!     }
//! }
//!
//! let now = Instant::from_millis(1);
//! let mut encoder = Encoder::new(Still, NoStorage, Label::default());
//! assert_eq!(encoder.bit_rate(), BitRate::AUTOMATIC);
//! encoder.detected(BitRate::KBIT_250);
//! while let Some(frame) = encoder.poll(now) {
//!     // to the bus: the boot-up message of node 127
//!     # assert_eq!(frame.data(), [0]);
//! }
//! // when one has come from the bus
//! # let frame = Frame::byte(CanId::NMT, 0x01);
//! encoder.receive(now, &frame);
//! // nothing to do before that
//! let due = encoder.poll_at();
//! # assert!(due.is_some());
//! ```
//!
//! | module | does |
//! |---|---|
//! | `encoder` | ties sensor, node and time together |
//! | `application` | answers for the objects that are more than stored values |
//! | `measurement` | from the sensor's reading to the objects of CiA 406 |
//! | `motion` | speed, acceleration and jerk over the integration time |
//! | `places` | cams and the work area |
//! | `health` | temperature, alarms, warnings, emergency messages, histories |
//! | `guard` | what may be written in PRE-OPERATIONAL only |
//! | `memory` | which objects are stored together, and which outlive a restore |
//!
//! With the feature `host` there is a binary `wdga`, a virtual encoder on a bus of this host: its shaft turns by a script, faults
//! come when they are told to, and a file is its EEPROM.
//!
//! ```text
//! wdga --bus slcan+tcp-listen://127.0.0.1:29321 --motion sine:3:10 --fault position@20..25 --eeprom wdga.eeprom
//! ```
//!
//! `docs/encoders.md` of the repository goes through the manual, statement by statement.

#![no_std]

mod application;
mod encoder;
mod guard;
mod health;
mod label;
mod measurement;
mod memory;
mod motion;
mod places;

pub use application::Application;
pub use encoder::Encoder;
pub use label::{Label, Variant, shaft};
pub use lexican_runtime::{lss::BitRate, profile::encoder::Sensor};
pub use memory::Memory;

include!(concat!(env!("OUT_DIR"), "/wdga.rs"));
