//! A file as the encoder's EEPROM.

use std::{
    fs,
    io::{self, ErrorKind},
    path::PathBuf,
};

use lexican_runtime::storage::{Failed, Slot, Storage};

/// Bytes of a slot; all that a WDGA stores needs about two thirds of it.
const SIZE: usize = 4096;

/// Two slots, one behind the other in a file. The file is replaced as a whole: there is the old one, or the new one.
#[derive(Debug)]
pub(crate) struct Eeprom {
    file: Option<PathBuf>,
    bytes: Vec<u8>,
}

impl Eeprom {
    /// What is in `file`; an erased memory when it is not there yet, or there is none.
    ///
    /// # Errors
    /// When the file cannot be read, or has not the size of an EEPROM.
    pub(crate) fn open(file: Option<PathBuf>) -> io::Result<Self> {
        let Some(path) = &file else {
            return Ok(Self::erased(file));
        };
        let name = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        match fs::read(path) {
            Ok(bytes) if bytes.len() == 2 * SIZE => Ok(Self { file, bytes }),
            Ok(bytes) => Err(io::Error::new(
                ErrorKind::InvalidData,
                name(&format!("{} bytes are no EEPROM, which has {}", bytes.len(), 2 * SIZE)),
            )),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(Self::erased(file)),
            Err(error) => Err(io::Error::new(error.kind(), name(&error))),
        }
    }

    fn erased(file: Option<PathBuf>) -> Self {
        Self {
            file,
            bytes: vec![0xFF; 2 * SIZE],
        }
    }

    fn slot(&mut self, slot: Slot) -> &mut [u8] {
        let (a, b) = self.bytes.split_at_mut(SIZE);
        match slot {
            Slot::A => a,
            Slot::B => b,
        }
    }
}

impl Storage for Eeprom {
    fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed> {
        let bytes = self.slot(slot).get(offset..).ok_or(Failed)?;
        bytes.first_chunk().copied().ok_or(Failed)
    }

    fn erase(&mut self, slot: Slot) -> Result<(), Failed> {
        self.slot(slot).fill(0xFF);
        Ok(())
    }

    fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed> {
        let bytes = self.slot(slot).get_mut(offset..).ok_or(Failed)?;
        *bytes.first_chunk_mut().ok_or(Failed)? = word;
        Ok(())
    }

    fn finish(&mut self, _: Slot) -> Result<(), Failed> {
        let Some(file) = &self.file else { return Ok(()) };
        let new = file.with_extension("new");
        fs::write(&new, &self.bytes).map_err(|_| Failed)?;
        fs::rename(&new, file).map_err(|_| Failed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_there_when_the_file_is_opened_again() {
        let file = std::env::temp_dir().join(format!("wdga-{}.eeprom", std::process::id()));
        let mut eeprom = Eeprom::open(Some(file.clone())).expect("a new one");
        eeprom.erase(Slot::B).expect("a slot");
        eeprom.write(Slot::B, 8, *b"position").expect("a word");
        eeprom.finish(Slot::B).expect("a file");
        let mut again = Eeprom::open(Some(file.clone())).expect("the file");
        assert_eq!(again.read(Slot::B, 8), Ok(*b"position"));
        assert_eq!(again.read(Slot::A, 8), Ok([0xFF; 8]));
        assert_eq!(again.read(Slot::A, SIZE), Err(Failed));

        fs::write(&file, b"short").expect("a file");
        let error = Eeprom::open(Some(file.clone())).expect_err("no EEPROM").to_string();
        assert!(error.ends_with("5 bytes are no EEPROM, which has 8192"), "{error}");
        fs::remove_file(file).expect("the file");
    }
}
