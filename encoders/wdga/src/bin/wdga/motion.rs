//! How the shaft turns, and what is wrong when.

use std::{fs, str::FromStr, time::Instant as Clock};

use lexican_runtime::profile::encoder::{Faults, Reading, Sensor, Shaft};
use lexican_wdga::{Variant, shaft};

/// A motion script: revolutions as a function of time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Motion {
    Still,
    /// Revolutions a second.
    Speed(f64),
    /// Revolutions a second at the beginning and from the end on, seconds between.
    Ramp {
        from: f64,
        to: f64,
        time: f64,
    },
    /// Revolutions to either side, seconds of a period.
    Sine {
        amplitude: f64,
        period: f64,
    },
    /// Seconds and revolutions, rising times.
    Places(Vec<(f64, f64)>),
}

impl Motion {
    /// Revolutions after `time` seconds.
    fn at(&self, time: f64) -> f64 {
        match self {
            Self::Still => 0.0,
            Self::Speed(speed) => speed * time,
            Self::Ramp { from, to, time: ramp } => {
                let rising = time.min(*ramp);
                from * rising + (to - from) * rising * rising / (2.0 * ramp) + to * (time - rising)
            }
            Self::Sine { amplitude, period } => amplitude * (std::f64::consts::TAU * time / period).sin(),
            Self::Places(places) => between(places, time),
        }
    }
}

/// On the straight line between two places; the first before, the last after.
fn between(places: &[(f64, f64)], time: f64) -> f64 {
    let next = places.partition_point(|place| place.0 <= time);
    let before = next.checked_sub(1).and_then(|last| places.get(last));
    match (before, places.get(next)) {
        (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (time - a.0) / (b.0 - a.0),
        (Some(place), None) | (None, Some(place)) => place.1,
        (None, None) => 0.0,
    }
}

impl FromStr for Motion {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts: Vec<&str> = text.split(':').collect();
        match *parts.as_slice() {
            ["still"] => Ok(Self::Still),
            ["speed", rpm] => Ok(Self::Speed(number(rpm)? / 60.0)),
            ["ramp", from, to, time] => Ok(Self::Ramp {
                from: number(from)? / 60.0,
                to: number(to)? / 60.0,
                time: positive(time)?,
            }),
            ["sine", amplitude, period] => Ok(Self::Sine {
                amplitude: number(amplitude)?,
                period: positive(period)?,
            }),
            ["file", ..] => places(text.trim_start_matches("file:")),
            _ => {
                Err("a motion is still, speed:RPM, ramp:FROM:TO:SECONDS, sine:REVOLUTIONS:SECONDS or file:PATH".into())
            }
        }
    }
}

/// Reads the places of a file; empty lines and those that begin with `#` say nothing.
fn places(path: &str) -> Result<Motion, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let mut places: Vec<(f64, f64)> = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        let content = content.trim();
        if content.is_empty() || content.starts_with('#') {
            continue;
        }
        let wrong = |what: &str| format!("{path}:{line}: {what}");
        let (time, turns) = content
            .split_once(char::is_whitespace)
            .ok_or_else(|| wrong("a line has seconds and revolutions, such as `2.5 -10`"))?;
        let place = (
            number(time).map_err(|e| wrong(&e))?,
            number(turns).map_err(|e| wrong(&e))?,
        );
        if places.last().is_some_and(|last| last.0 >= place.0) {
            return Err(wrong("times are to rise from line to line"));
        }
        places.push(place);
    }
    Ok(Motion::Places(places))
}

fn number(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("`{text}` is no number"))
}

fn positive(text: &str) -> Result<f64, String> {
    number(text).and_then(|number| {
        if number > 0.0 {
            Ok(number)
        } else {
            Err(format!("{text} s is no time to pass"))
        }
    })
}

/// Something that is wrong for a time.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    faults: Faults,
    from: f64,
    to: f64,
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text
            .split_once('@')
            .and_then(|(kind, time)| Some((kind, time.split_once("..")?)));
        let (kind, (from, to)) = parts.ok_or("a fault is KIND@FROM..TO, such as position@5..10")?;
        let faults = match kind {
            "position" => Faults::POSITION,
            "singleturn" => Faults::SINGLE_TURN,
            "revolutions" => Faults::REVOLUTIONS,
            "temperature" => Faults::TEMPERATURE,
            _ => {
                return Err(format!(
                    "`{kind}` is no fault: position, singleturn, revolutions, temperature"
                ));
            }
        };
        Ok(Self {
            faults,
            from: if from.is_empty() { 0.0 } else { number(from)? },
            to: if to.is_empty() { f64::INFINITY } else { number(to)? },
        })
    }
}

/// A shaft that turns by a script, from the moment on that it was made.
#[derive(Debug)]
pub(crate) struct Turned {
    shaft: Shaft,
    motion: Motion,
    faults: Vec<Fault>,
    temperature: i16,
    start: Clock,
}

impl Turned {
    pub(crate) fn new(variant: Variant, motion: Motion, faults: Vec<Fault>, temperature: i16) -> Self {
        Self {
            shaft: shaft(variant),
            motion,
            faults,
            temperature,
            start: Clock::now(),
        }
    }

    /// The reading after so many revolutions, backwards from the end of the shaft's for negative ones.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "steps are whole, and a script of more than 2^63 of them ends there"
    )]
    fn reading_at(&self, revolutions: f64) -> Reading {
        let steps = (revolutions * f64::from(self.shaft.resolution())).floor() as i128;
        let resolution = i128::from(self.shaft.resolution());
        let turn = steps.div_euclid(resolution).rem_euclid(self.shaft.revolutions().into());
        Reading {
            turn: u64::try_from(turn).unwrap_or(0),
            angle: u32::try_from(steps.rem_euclid(resolution)).unwrap_or(0),
        }
    }
}

impl Sensor for Turned {
    fn shaft(&self) -> Shaft {
        self.shaft
    }

    fn reading(&mut self) -> Reading {
        self.reading_at(self.motion.at(self.start.elapsed().as_secs_f64()))
    }

    fn temperature(&mut self) -> Option<i16> {
        Some(self.temperature)
    }

    fn faults(&mut self) -> Faults {
        let now = self.start.elapsed().as_secs_f64();
        let standing = self.faults.iter().filter(|fault| (fault.from..fault.to).contains(&now));
        standing.fold(Faults::NONE, |all, fault| all.with(fault.faults))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a script has the shaft, in thousandths of a revolution.
    #[track_caller]
    fn at(script: &str, time: f64) -> i64 {
        let motion: Motion = script.parse().expect("a script");
        #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
        let thousandths = (motion.at(time) * 1000.0).round() as i64;
        thousandths
    }

    #[test]
    fn scripts_turn_the_shaft_as_they_say() {
        assert_eq!(at("still", 9.0), 0);
        assert_eq!(at("speed:-120", 1.5), -3000);
        assert_eq!(at("ramp:0:60:2", 1.0), 250);
        assert_eq!(at("ramp:0:60:2", 3.0), 2000);
        assert_eq!(at("sine:3:4", 1.0), 3000);
        assert_eq!(at("sine:3:4", 3.0), -3000);
        assert_eq!(between(&[(1.0, 5.0), (3.0, 9.0)], 2.0).to_bits(), 7.0f64.to_bits());
        assert_eq!(between(&[(1.0, 5.0), (3.0, 9.0)], 0.0).to_bits(), 5.0f64.to_bits());
        assert_eq!(between(&[(1.0, 5.0), (3.0, 9.0)], 4.0).to_bits(), 9.0f64.to_bits());
    }

    #[test]
    fn a_shaft_that_turns_backwards_comes_from_the_end() {
        let turned = Turned::new(Variant::Multiturn, Motion::Still, Vec::new(), 20);
        assert_eq!(turned.reading_at(1.5), Reading { turn: 1, angle: 8192 });
        let last = Reading {
            turn: (1 << 39) - 1,
            angle: 12288,
        };
        assert_eq!(turned.reading_at(-0.25), last);
    }

    #[test]
    fn what_is_no_script_or_fault_says_what_would_be() {
        assert!(
            "spin"
                .parse::<Motion>()
                .expect_err("no motion")
                .contains("sine:REVOLUTIONS")
        );
        assert_eq!("speed:x".parse::<Motion>(), Err("`x` is no number".into()));
        assert_eq!("sine:1:0".parse::<Motion>(), Err("0 s is no time to pass".into()));
        assert!(
            "smoke@1..2"
                .parse::<Fault>()
                .expect_err("no fault")
                .contains("temperature")
        );
        let fault: Fault = "position@5..".parse().expect("a fault");
        assert_eq!(
            fault,
            Fault {
                faults: Faults::POSITION,
                from: 5.0,
                to: f64::INFINITY
            }
        );
    }
}
