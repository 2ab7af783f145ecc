//! What `--diff` shows: the differences of many files, one after the other, and how many there are.

use crate::{
    Verdict,
    failure::{self, Failure},
    output::{Stdout, unwritten},
    patch::Reader,
};
use std::io::Write as _;

/// What would change in one file.
pub(super) struct Difference {
    /// A unified diff; empty when nothing would.
    pub(super) text: Vec<u8>,
    /// What a change is, for the summary: how many findings are mended.
    pub(super) findings: usize,
}

/// Prints differences to standard output.
pub(super) struct Differences {
    reader: Reader,
    out: Stdout,
    files: usize,
    findings: usize,
    failed: bool,
}

impl Differences {
    pub(super) fn new() -> Self {
        let reader = Reader::of_stdout();
        Self {
            reader,
            out: match reader {
                Reader::Person => Stdout::styled(),
                Reader::Program => Stdout::plain(),
            },
            files: 0,
            findings: 0,
            failed: false,
        }
    }

    /// Who reads them.
    pub(super) const fn reader(&self) -> Reader {
        self.reader
    }

    pub(super) fn fail(&mut self, failure: &Failure) {
        self.failed = true;
        failure.print();
    }

    pub(super) fn add(&mut self, difference: Result<Difference, Failure>) -> Result<(), Failure> {
        match difference {
            Ok(difference) => {
                self.files += usize::from(!difference.text.is_empty());
                self.findings += difference.findings;
                self.out.write_all(&difference.text).map_err(|error| unwritten(&error))
            }
            Err(failure) => {
                self.fail(&failure);
                Ok(())
            }
        }
    }

    /// Says on stderr what was shown, unless `quiet`. Ends with 1 when a file would change.
    pub(super) fn finish(self, quiet: bool, summary: impl Fn(usize, usize) -> String) -> Result<Verdict, Failure> {
        self.out.finish()?;
        if !quiet && self.files > 0 {
            failure::note(&summary(self.files, self.findings));
        }
        Ok(match (self.failed, self.files) {
            (true, _) => Verdict::Incomplete,
            (false, 0) => Verdict::Clean,
            (false, _) => Verdict::Findings,
        })
    }
}
