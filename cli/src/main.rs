//! The `lexican` command.

fn main() {}
