//! python-canopen, the second opinion of some tests.

use std::{env, process::Command};

use crate::corpus::notice;

/// The Python that CI names, or the machine's, if it has canopen 2.4.1; `None`, with a notice, when not.
#[must_use]
pub fn with_canopen() -> Option<String> {
    let named = env::var("LEXICAN_PYTHON").ok();
    let python = named.unwrap_or_else(|| "python3".to_owned());
    let check = "import canopen, sys; sys.exit(canopen.__version__ != '2.4.1')";
    let output = Command::new(&python).args(["-c", check]).output();
    if output.is_ok_and(|output| output.status.success()) {
        return Some(python);
    }
    notice("skipped: no Python with canopen 2.4.1 (set LEXICAN_PYTHON to one that has it)");
    None
}
