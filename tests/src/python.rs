//! python-canopen, the second opinion of some tests.

use std::{
    env,
    io::{BufRead, BufReader, Write},
    path::Path,
    process::{Command, Stdio},
};

use lexican_runtime::Device;

use crate::{bus::Bus, corpus::notice};

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

/// Puts the script of that name in `tests/oracle` on `bus`, as `line_network.py` says: its standard output is what it sends,
/// its standard input what the node does. Gives the number of frames that it has sent.
///
/// # Panics
/// When the script does not end well.
pub fn talk<D: Device>(
    bus: &mut Bus<D>,
    python: &str,
    script: &str,
    arguments: impl IntoIterator<Item = String>,
) -> usize {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracle").join(script);
    let mut python = Command::new(python);
    python.arg(script).args(arguments);
    let pipes = python.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut master = pipes.expect("Python runs");
    let (stdin, stdout) = (master.stdin.take(), master.stdout.take());
    let (mut stdin, stdout) = stdin.zip(stdout).expect("both are piped");
    let mut frames = 0;
    for frame in BufReader::new(stdout).lines() {
        bus.send(&frame.expect("a line of text"));
        let answers = std::iter::from_fn(|| bus.take()).map(|answer| format!("{answer:?}\n"));
        let answers: String = answers.chain([".\n".to_owned()]).collect();
        stdin.write_all(answers.as_bytes()).expect("the script listens");
        frames += 1;
    }
    assert!(
        master.wait().expect("the script ends").success(),
        "after {frames} frames"
    );
    frames
}
