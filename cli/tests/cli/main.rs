//! The `lexican` command as a user meets it: the real binary, its output, its exit codes.

#![expect(clippy::unwrap_used, reason = "a test that cannot be set up has failed")]

mod check;
mod ci;
mod config;
mod decode;
mod device;
mod diff;
mod dump;
mod explain;
mod fix;
mod format;
mod formats;
mod generate;
mod help;
mod html;
mod lexican;
mod new;
mod sarif_fixes;
mod shell;
mod simulate;
mod validate;
