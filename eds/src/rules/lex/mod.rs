//! The comments by which a file speaks to Lexican.

mod bad_allowance;
mod idle_allowance;

pub(super) use bad_allowance::BadAllowance;
pub(super) use idle_allowance::IdleAllowance;
