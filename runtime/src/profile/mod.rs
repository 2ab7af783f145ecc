//! Device profiles: what the objects 6000h to 9FFFh mean, as pure functions that an application calls.

pub mod encoder;
