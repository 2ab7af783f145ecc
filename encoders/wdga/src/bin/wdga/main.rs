//! A virtual WDGA on a bus of this host.

mod eeprom;
mod motion;

use std::{
    error::Error,
    path::PathBuf,
    process::ExitCode,
    time::{Duration, Instant as Clock},
};

use clap::Parser;
use lexican_bus::transport::{self, Transport};
use lexican_runtime::{Instant, profile::encoder::Sensor};
use lexican_wdga::{BitRate, Encoder, Label, Variant};

use eeprom::Eeprom;
use motion::{Fault, Motion, Turned};

/// A Wachendorff WDGA absolute encoder, as the real one behaves on the bus.
#[derive(Debug, Parser)]
#[command(name = "wdga", version)]
struct Arguments {
    /// The bus: slcan+tcp://HOST:PORT, slcan+tcp-listen://HOST:PORT, virtual:NAME …
    #[arg(long)]
    bus: String,
    /// A singleturn encoder instead of a multiturn one.
    #[arg(long)]
    singleturn: bool,
    /// How the shaft turns: `still`, `speed:RPM`, `ramp:FROM:TO:SECONDS` (RPM, then on at TO), `sine:REVOLUTIONS:SECONDS`
    /// (amplitude, period), or `file:PATH` with a line `SECONDS REVOLUTIONS` for each place that it passes.
    #[arg(long, default_value = "still")]
    motion: Motion,
    /// What is wrong, and when, in seconds: `position@5..10`, `singleturn@…`, `revolutions@…`, `temperature@3..`.
    #[arg(long = "fault", value_name = "KIND@FROM..TO")]
    faults: Vec<Fault>,
    /// The temperature within the encoder, in °C.
    #[arg(long, default_value_t = 25, allow_negative_numbers = true)]
    temperature: i16,
    /// The file that outlives power-off, as the encoder's EEPROM; without it nothing does.
    #[arg(long)]
    eeprom: Option<PathBuf>,
    /// The serial number, 1018h:04.
    #[arg(long, default_value_t = 1)]
    serial_number: u32,
    /// Wait for the first frame of another, as the encoder does to find the bit rate, before booting.
    #[arg(long)]
    listen: bool,
}

#[expect(clippy::print_stderr, reason = "a command says what went wrong")]
fn main() -> ExitCode {
    match serve(Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("wdga: {error}");
            ExitCode::from(2)
        }
    }
}

/// Serves until the bus is gone.
fn serve(arguments: Arguments) -> Result<(), Box<dyn Error>> {
    let mut bus = transport::open(&arguments.bus)?;
    announce(&*bus);
    let variant = if arguments.singleturn {
        Variant::Singleturn
    } else {
        Variant::Multiturn
    };
    let label = Label {
        serial_number: arguments.serial_number,
        ..Label::default()
    };
    let sensor = Turned::new(variant, arguments.motion, arguments.faults, arguments.temperature);
    let eeprom = Eeprom::open(arguments.eeprom)?;
    let mut encoder = Encoder::new(sensor, eeprom, label);
    if !arguments.listen && encoder.bit_rate() == BitRate::AUTOMATIC {
        // What carries the frames has its bit rate already.
        encoder.detected(BitRate::KBIT_500);
    }
    run(&mut *bus, &mut encoder)
}

/// Where others join is told, as the system may have chosen the port.
#[expect(clippy::print_stderr, reason = "a user needs it to join the bus")]
fn announce(bus: &dyn Transport) {
    if let Some(address) = bus.address() {
        eprintln!("wdga: others join at slcan+tcp://{address}");
    }
}

fn run<S: Sensor>(bus: &mut dyn Transport, encoder: &mut Encoder<S, Eeprom>) -> Result<(), Box<dyn Error>> {
    let start = Clock::now();
    loop {
        while let Some(frame) = encoder.poll(since(start)) {
            bus.send(&frame)?;
        }
        let patience = patience(since(start), encoder.poll_at());
        if let Some(frame) = bus.receive(patience)? {
            if encoder.bit_rate() == BitRate::AUTOMATIC {
                encoder.detected(BitRate::KBIT_500);
            }
            encoder.receive(since(start), &frame);
        }
    }
}

fn since(start: Clock) -> Instant {
    Instant::from_micros(u64::try_from(start.elapsed().as_micros()).unwrap_or(u64::MAX))
}

/// Until when a frame may come before there is something to do.
fn patience(now: Instant, due: Option<Instant>) -> Duration {
    let most = Duration::from_secs(1);
    let micros = due.map(|due| due.as_micros().saturating_sub(now.as_micros()));
    micros.map_or(most, Duration::from_micros).min(most)
}
