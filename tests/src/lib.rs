//! Shared set-up of the tests.

pub mod sample;
