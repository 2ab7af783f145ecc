//! A progress bar for those who wait: on a terminal, and only when it takes long.

use std::{
    io::{IsTerminal as _, stderr},
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Who waits less than this sees no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// How far a run over many files has come.
pub(crate) struct Progress {
    bar: ProgressBar,
    started: Instant,
    wanted: bool,
}

impl Progress {
    /// Over `files` files. Nothing is drawn unless `wanted`, nor when stderr is no terminal.
    pub(crate) fn new(files: usize, wanted: bool) -> Self {
        let bar = ProgressBar::with_draw_target(Some(files as u64), ProgressDrawTarget::hidden());
        Self {
            bar: bar.with_style(style()),
            started: Instant::now(),
            wanted: wanted && stderr().is_terminal(),
        }
    }

    /// One more file is done.
    pub(crate) fn advance(&mut self) {
        if self.wanted && self.started.elapsed() > PATIENCE {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
            self.wanted = false;
        }
        self.bar.inc(1);
    }

    /// Takes the bar away while `print` writes to the same terminal.
    pub(crate) fn aside<T>(&self, print: impl FnOnce() -> T) -> T {
        self.bar.suspend(print)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// `checking ████░░░░ 120/363`
fn style() -> ProgressStyle {
    let template = "checking {bar:30} {pos}/{len}";
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
