//! The firmware of `examples/firmware` on an emulated microcontroller, spoken to over its serial line in slcan.
//!
//! Every wait has a limit; none is for a time that must pass.

use std::{
    env, fmt,
    io::{ErrorKind, Read as _, Write as _},
    os::unix::net::UnixStream,
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    thread::sleep,
    time::{Duration, Instant},
};

use lexican_runtime::{
    Frame,
    wire::slcan::{self, Answer, Line, Lines},
};

use crate::{corpus::notice, line};

/// As long as anything may take, on a machine that has other work to do.
const PATIENCE: Duration = Duration::from_secs(20);
/// Between two attempts.
const PAUSE: Duration = Duration::from_millis(50);
/// The microcontroller's RAM: where it is, and how long.
const RAM: (u32, usize) = (0x2000_0000, 0x1_0000);

/// A running emulator; it ends with this.
pub struct Emulator {
    process: Child,
    serial: UnixStream,
    monitor: UnixStream,
    lines: Lines,
    folder: PathBuf,
    /// The dialogue so far, shown when it goes wrong.
    log: Vec<String>,
}

impl Emulator {
    /// The image that the environment names, from power-on; `None`, with a notice, when it names none.
    ///
    /// # Panics
    /// When the emulator does not start.
    #[must_use]
    pub fn start(name: &str) -> Option<Self> {
        let Some(image) = env::var_os("LEXICAN_FIRMWARE") else {
            notice("skipped: no LEXICAN_FIRMWARE; `examples/firmware/run` builds it and comes back here");
            return None;
        };
        let folder = env::temp_dir().join(format!("lexican-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder for the sockets");
        let socket = |name: &str| format!("unix:{},server=on,wait=off", folder.join(name).display());
        let process = Command::new("qemu-system-arm")
            .args(["-machine", "lm3s6965evb", "-cpu", "cortex-m4", "-display", "none", "-S"])
            .args(["-serial", &socket("serial"), "-monitor", &socket("monitor"), "-kernel"])
            .arg(image)
            .stdin(Stdio::null())
            .spawn()
            .expect("qemu-system-arm starts; Debian's package of this name has it");
        let serial = connect(&folder.join("serial"));
        let monitor = connect(&folder.join("monitor"));
        let mut emulator = Self {
            process,
            serial,
            monitor,
            lines: Lines::new(),
            folder,
            log: Vec::new(),
        };
        emulator.until_prompt();
        emulator.monitor("cont");
        emulator.wake();
        Some(emulator)
    }

    /// The same with the adapter on the bus, and the node booted.
    ///
    /// # Panics
    /// When it does not boot.
    #[must_use]
    pub fn booted(name: &str) -> Option<Self> {
        let mut emulator = Self::start(name)?;
        emulator.command("O", "\r").expect("77F#00");
        Some(emulator)
    }

    /// Gives the adapter a command, and awaits its answer: `"\r"`, `"\x07"` or a line.
    ///
    /// # Panics
    /// When the answer is another one.
    #[track_caller]
    pub fn command(&mut self, command: &str, answer: &str) -> &mut Self {
        self.write(&format!("{command}\r"));
        let line = self.line();
        assert_eq!(text(&line), answer, "{self:?}");
        self
    }

    /// Puts a frame on the bus.
    #[track_caller]
    pub fn send(&mut self, frame: &str) -> &mut Self {
        self.put(&line::frame(frame))
    }

    /// As [`Emulator::send`], of a frame that is none of text.
    ///
    /// # Panics
    /// When the adapter does not take it.
    #[track_caller]
    pub fn put(&mut self, frame: &Frame) -> &mut Self {
        let digits = if frame.id().is_extended() { 8 } else { 3 };
        let letter = match (frame.is_remote(), frame.id().is_extended()) {
            (false, false) => 't',
            (false, true) => 'T',
            (true, false) => 'r',
            (true, true) => 'R',
        };
        let (id, length, data) = (frame.id().number(), frame.length(), line::hex(frame.data()));
        let answer = if frame.id().is_extended() { "Z\r" } else { "z\r" };
        self.command(&format!("{letter}{id:0digits$X}{length}{data}"), answer)
    }

    /// The next frame that the node sends, and the adapter's time of it, if it gives one.
    ///
    /// # Panics
    /// When none comes, or something else.
    #[track_caller]
    pub fn take(&mut self) -> (Frame, Option<u16>) {
        let line = self.line();
        match Answer::parse(line.as_bytes()) {
            Some(Answer::Received { frame, timestamp }) => (frame, timestamp),
            _ => panic!("{line:?} is no frame\n{self:?}"),
        }
    }

    /// The next frame that the node sends is this one.
    ///
    /// # Panics
    /// When it is another one, or none comes.
    #[track_caller]
    pub fn expect(&mut self, frame: &str) -> &mut Self {
        let (sent, _) = self.take();
        assert_eq!(sent, line::frame(frame), "{self:?}");
        self
    }

    /// Gives the adapter a command that puts a frame on the bus `count` times, without awaiting an answer.
    ///
    /// # Panics
    /// When the line is gone.
    #[track_caller]
    pub fn burst(&mut self, command: &str, count: usize) {
        self.write(&command.repeat(count));
    }

    /// The next line is the adapter's that it has sent a frame.
    ///
    /// # Panics
    /// When it is another one, or none comes.
    #[track_caller]
    pub fn expect_sent(&mut self) -> &mut Self {
        let line = self.line();
        assert_eq!(text(&line), "z\r", "{self:?}");
        self
    }

    /// What is in the microcontroller's RAM now.
    ///
    /// # Panics
    /// When the emulator does not say.
    #[must_use]
    pub fn ram(&mut self) -> Vec<u8> {
        let file = self.folder.join("ram");
        let (start, length) = RAM;
        self.monitor(&format!("pmemsave {start:#x} {length:#x} \"{}\"", file.display()));
        std::fs::read(file).expect("the emulator has written the RAM")
    }

    /// Sends empty lines until one is answered, as the firmware is deaf while it starts; and takes the other answers.
    fn wake(&mut self) {
        let started = Instant::now();
        self.serial.set_read_timeout(Some(PAUSE)).expect("a limit");
        self.write("\r");
        while self.serial.read_exact(&mut [0]).is_err() {
            assert!(started.elapsed() < PATIENCE, "the firmware does not start");
            self.write("\r");
        }
        self.serial.set_read_timeout(Some(PATIENCE)).expect("a limit");
        self.write("V\r");
        while !text(&self.line()).starts_with('V') {}
    }

    #[track_caller]
    fn write(&mut self, text: &str) {
        self.log.push(format!("> {}", text.escape_debug()));
        self.serial
            .write_all(text.as_bytes())
            .unwrap_or_else(|error| panic!("{error}\n{self:?}"));
    }

    #[track_caller]
    fn line(&mut self) -> Line {
        let mut byte = [0];
        loop {
            if let Err(error) = self.serial.read_exact(&mut byte) {
                panic!("nothing more comes: {error}\n{self:?}");
            }
            if let Some(line) = self.lines.push(byte[0]) {
                self.log.push(format!("< {line:?}"));
                return line;
            }
        }
    }

    /// Gives the emulator a command, and waits until it is done.
    fn monitor(&mut self, command: &str) {
        writeln!(self.monitor, "{command}").expect("the emulator runs");
        self.until_prompt();
    }

    fn until_prompt(&mut self) {
        let (mut said, mut byte) = (Vec::new(), [0]);
        while !said.ends_with(b"(qemu) ") {
            self.monitor.read_exact(&mut byte).expect("the emulator answers");
            said.push(byte[0]);
        }
    }
}

impl fmt::Debug for Emulator {
    /// The dialogue.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.log.iter().try_for_each(|line| writeln!(f, "{line}"))
    }
}

impl Drop for Emulator {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.process.kill();
        let _ = self.process.wait();
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// The line as it came.
fn text(line: &Line) -> String {
    let text = String::from_utf8_lossy(line.as_bytes());
    if line.as_bytes() == [slcan::REFUSAL] {
        return text.into_owned();
    }
    text.into_owned() + "\r"
}

/// The emulator makes its sockets when it has started.
fn connect(path: &Path) -> UnixStream {
    let started = Instant::now();
    loop {
        match UnixStream::connect(path) {
            Ok(stream) => {
                stream.set_read_timeout(Some(PATIENCE)).expect("a limit");
                return stream;
            }
            Err(error) if !is_early(error.kind()) || started.elapsed() > PATIENCE => {
                panic!("{}: {error}", path.display())
            }
            Err(_) => sleep(PAUSE),
        }
    }
}

fn is_early(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::NotFound | ErrorKind::ConnectionRefused)
}
