//! CANopen EDS and DCF files (CiA 306-1): read, understood, judged, written back.
//!
//! bytes → source → document → model → [`ir::Dictionary`]
//!
//! Each stage has one verb and never fails: what it cannot make sense of becomes a problem with a position,
//! and the rules turn problems into diagnostics.

pub mod document;
mod ini;
pub mod ir;
pub mod literal;
pub mod source;
pub mod span;
