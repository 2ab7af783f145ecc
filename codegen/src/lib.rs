//! Code generation.

mod builder;
mod check;
mod emit;
mod error;
mod generated;
mod name;
mod plan;
mod selector;

pub use builder::Builder;
pub use error::Error;
pub use generated::Generated;
pub use lexican_eds::diagnostic::Level;
pub use selector::Selector;

/// Compiles the EDS or DCF file at `path` into `<name>.rs` in Cargo's OUT_DIR: what nine build scripts of ten need.
///
/// # Errors
/// As [`Builder::generate`] and [`Generated::write_to_out_dir`].
pub fn compile(path: impl Into<std::path::PathBuf>) -> Result<(), Error> {
    Builder::new(path).generate()?.write_to_out_dir()
}
