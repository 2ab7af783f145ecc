//! Compiles a CANopen EDS or DCF file into a typed Rust object dictionary, from `build.rs`.
//!
//! ```no_run
//! fn main() -> Result<(), lexican_codegen::Error> {
//!     lexican_codegen::Builder::new("wdga.eds")
//!         .handle([0x6003, 0x6004]) // objects that the application answers for
//!         .generate()?              // pure: reads the file, gives the source
//!         .write_to_out_dir()       // the only writing; tells Cargo what it depends on
//! }
//! ```
//!
//! Where the application answers for nothing, [`compile`]`("wdga.eds")` is the same in one word. The file is checked
//! first: what a rule denies stops the build, with the diagnostics that `lexican check` shows.
//!
//! # What is generated
//!
//! `OUT_DIR/wdga.rs` is one item, for `include!(concat!(env!("OUT_DIR"), "/wdga.rs"));`. It needs `lexican-runtime` and
//! nothing else, is `no_std`, and compiles on Rust 1.77 without a warning, also under `clippy::pedantic`.
//!
//! ```text
//! pub mod wdga {
//!     pub struct Dictionary { pub position_value: u32, … }
//!     impl Dictionary { pub const DEVICE_TYPE: u32 = 0x0002_0196; … pub const fn new(node_id: NodeId) -> Self; }
//!     pub trait Handlers { fn read_position_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode>; … }
//!     pub struct Device<H> { pub od: Dictionary, pub handlers: H }
//!     impl<H: Handlers> lexican_runtime::Device for Device<H> { … }
//! }
//! ```
//!
//! ## Values
//!
//! A value is a public field of `Dictionary`. The documentation of each says what the file says of it.
//!
//! | in the file | field |
//! |---|---|
//! | BOOLEAN | `Boolean` |
//! | INTEGER8, 16, 32, 64; UNSIGNED likewise | `i8` to `i64`, `u8` to `u64` |
//! | INTEGER24; 40, 48, 56; UNSIGNED likewise | the next wider integer; on the bus it has its own length |
//! | REAL32, REAL64 | `f32`, `f64` |
//! | VISIBLE_STRING | `VisibleString<N>`: up to `N` bytes |
//! | OCTET_STRING, UNICODE_STRING, DOMAIN | `OctetString<N>` |
//! | TIME_OF_DAY, TIME_DIFFERENCE | `TimeOfDay` |
//! | an ARRAY without gaps, of one type and access | `[T; N]`, the first element is sub-index 1; a PDO mapping likewise |
//! | any other object with sub-indices | a field a sub-index, named after both |
//!
//! A string has room for its default value, or for 32 bytes when the file gives none; [`Builder::capacity`] changes that.
//!
//! **What never changes is no field** but a constant of `Dictionary`, in flash: values that the file calls const, the
//! counts in sub-index 0, and device type, names, versions and identity (1000h, 1008h to 100Ah, 1018h:01 to :03) when they
//! are read-only. It is a field all the same when the file does not give the value, when it depends on the node-ID, when
//! it is the serial number (1018h:04), or when a handler answers for it.
//!
//! Values that the file gives as a formula of `$NODEID` are resolved by `Dictionary::new`, and by the runtime whenever the
//! node's number changes. A DCF's ParameterValue stands in place of the default.
//!
//! LowLimit and HighLimit bind whoever writes over the bus (abort codes 0609 0031h and 0609 0032h), not the application.
//! Limits of which the low one is above the high one bind nobody.
//!
//! ## Names
//!
//! `Producer heartbeat time` is `producer_heartbeat_time`; a sub-index has the name of its object before its own. Other
//! scripts are transliterated; a keyword has an underscore behind it, `type_`; a name that starts with a digit, or is none,
//! `object` before it, `object_2000`. A name that several objects have has the index behind it, on all of them, as has one
//! of more than 60 letters. So an object that is added to the file renames no other, unless it has the same name: then the
//! compiler says so, instead of the name meaning another object from now on.
//!
//! ## Handlers
//!
//! The objects that were named to [`Builder::handle`] have a method each in the trait `Handlers`, without a default: what is
//! not implemented does not compile.
//!
//! | method | is called | `Ok` means |
//! |---|---|---|
//! | `read_<name>(&mut self, od)` | when a client reads | the value is stored in `od` and sent |
//! | `write_<name>(&mut self, od, value)` | when a client writes, after access, length and limits | the value is stored in `od` |
//!
//! A DOMAIN that is handled, and a string that was named to [`Builder::stream`], go in parts instead:
//! `read_<name>(&mut self, od, offset, buffer)` and `write_<name>(&mut self, od, part)`.
//!
//! An `Err(AbortCode)` is the client's answer, and nothing is stored. Methods of an array have the sub-index as well.
//! `od` is the whole dictionary, so a handler may change other objects too. With no handler at all the trait is empty and
//! `()` implements it: `Device::new(())`.
//!
//! # Features
//!
//! * `templates`: handler stubs, documentation in Markdown, templates of the user's own. A build script needs none of them
//!   and is spared compiling a template engine.

mod builder;
mod check;
mod emit;
mod error;
mod generated;
mod name;
mod plan;
mod selector;
#[cfg(feature = "templates")]
mod view;

pub use builder::Builder;
pub use error::Error;
pub use generated::Generated;
pub use lexican_eds::{diagnostic::Level, rules::Levels};
#[cfg(feature = "templates")]
pub use lexican_templates::Template;
pub use selector::Selector;

/// Compiles the EDS or DCF file at `path` into `<name>.rs` in Cargo's OUT_DIR: what nine build scripts of ten need.
///
/// ```no_run
/// fn main() -> Result<(), lexican_codegen::Error> {
///     lexican_codegen::compile("wdga.eds")
/// }
/// ```
///
/// # Errors
/// As [`Builder::generate`] and [`Generated::write_to_out_dir`].
pub fn compile(path: impl Into<std::path::PathBuf>) -> Result<(), Error> {
    Builder::new(path).generate()?.write_to_out_dir()
}
