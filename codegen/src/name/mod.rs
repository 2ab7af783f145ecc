//! Names of generated items, made of the names in the EDS.
//!
//! A name is made of its own object alone, so that an object which is added later does not rename the others. Only
//! where several objects have the same name do they all get their address as a suffix, also the first of them: a name
//! never moves from one object to another without the compiler saying so.

mod ident;
mod unique;

pub(crate) use ident::{field_ident, letter_first, snake};
pub(crate) use unique::{Named, unique_names};
