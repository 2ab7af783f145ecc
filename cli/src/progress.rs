//! A progress bar for those who wait: on a terminal, and only when it takes long.

use std::{
    io::{IsTerminal as _, stderr},
    time::{Duration, Instant},
};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Who waits less than this sees no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// How far a run over many files, or many values of a device, has come.
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

    /// Over `steps` of reading node `node_id`.
    pub(crate) fn reading(node_id: u8, steps: usize, wanted: bool) -> Self {
        let progress = Self::new(steps, wanted);
        progress.bar.set_style(reading_style());
        progress.bar.set_message(node_id.to_string());
        progress
    }

    /// One more file is done.
    pub(crate) fn advance(&mut self) {
        self.appear();
        self.bar.inc(1);
    }

    /// So many steps are done.
    pub(crate) fn reach(&mut self, done: usize) {
        self.appear();
        self.bar.set_position(done as u64);
    }

    fn appear(&mut self) {
        if self.wanted && self.started.elapsed() > PATIENCE {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
            self.wanted = false;
        }
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

/// `node 5 ████░░░░ 120/363, 800/s, 2s left`
fn reading_style() -> ProgressStyle {
    let template = "node {msg} {bar:30} {pos}/{len}, {per_sec:.0}, {eta} left";
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
