//! What the user writes to name a bus.

use std::{fmt, str::FromStr};

/// The forms that there are, as messages and `--help` list them.
pub const FORMS: &str = "\
slcan:/dev/ttyACM0[@500k], slcan+tcp://host:port[@500k], slcan+tcp-listen://host:port, \
socketcan:can0, virtual:name";

/// socketcand's own port.
const SOCKETCAND_PORT: u16 = 29536;

/// The name of a bus, taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Url {
    /// `slcan:/dev/ttyACM0@500k`: an adapter on a serial line.
    Slcan {
        /// The serial device.
        device: String,
        /// The bit rate of the CAN bus; without one the adapter keeps its own.
        bit_rate: Option<BitRate>,
    },
    /// `slcan+tcp://host:port`: an adapter, or another program's bus, behind a TCP connection.
    SlcanTcp {
        /// `host:port`.
        address: String,
        /// The bit rate of the CAN bus; without one the adapter keeps its own.
        bit_rate: Option<BitRate>,
    },
    /// `slcan+tcp-listen://host:port`: a bus of our own that others join by TCP. Port 0 is any that is free.
    SlcanTcpListen {
        /// `host:port`.
        address: String,
    },
    /// `socketcan:can0`: an interface of this Linux machine.
    SocketCan {
        /// Its name.
        interface: String,
    },
    /// `socketcand://host:port/can0`: an interface of another Linux machine.
    Socketcand {
        /// `host:port`.
        address: String,
        /// The name of the interface there.
        interface: String,
    },
    /// `virtual:name`: a bus inside this process. All that open the same name are on the same bus.
    Virtual {
        /// The name; it may be empty.
        name: String,
    },
}

/// What is wrong with the name of a bus, and how it is to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UrlError(String);

impl fmt::Display for UrlError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for UrlError {}

impl FromStr for Url {
    type Err = UrlError;

    fn from_str(text: &str) -> Result<Self, UrlError> {
        let Some((scheme, rest)) = text.split_once(':') else {
            return Err(UrlError(format!("no bus is named so; the forms are {FORMS}")));
        };
        match scheme {
            "slcan" => serial(rest),
            "slcan+tcp" => slcan_tcp(host(rest)?),
            "slcan+tcp-listen" => Ok(Self::SlcanTcpListen {
                address: with_port(host(rest)?)?,
            }),
            "socketcan" => interface(rest).map(|interface| Self::SocketCan { interface }),
            "socketcand" => socketcand(host(rest)?),
            "virtual" => Ok(Self::Virtual { name: rest.to_owned() }),
            _ => Err(UrlError(format!(
                "there is no kind of bus `{scheme}`; the forms are {FORMS}"
            ))),
        }
    }
}

impl fmt::Display for Url {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let at = |rate: &Option<BitRate>| rate.map_or_else(String::new, |rate| format!("@{}k", rate.kbit_per_s()));
        match self {
            Self::Slcan { device, bit_rate } => write!(f, "slcan:{device}{}", at(bit_rate)),
            Self::SlcanTcp { address, bit_rate } => write!(f, "slcan+tcp://{address}{}", at(bit_rate)),
            Self::SlcanTcpListen { address } => write!(f, "slcan+tcp-listen://{address}"),
            Self::SocketCan { interface } => write!(f, "socketcan:{interface}"),
            Self::Socketcand { address, interface } => write!(f, "socketcand://{address}/{interface}"),
            Self::Virtual { name } => write!(f, "virtual:{name}"),
        }
    }
}

/// A bit rate of a CAN bus that slcan has a command for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BitRate(u8);

/// The bit rates of the commands `S0` to `S8`, in kbit/s.
const RATES: [u32; 9] = [10, 20, 50, 100, 125, 250, 500, 800, 1000];

impl BitRate {
    /// The digit of slcan's command: 0 to 8.
    #[must_use]
    pub const fn digit(self) -> u8 {
        self.0
    }

    /// The bit rate in kbit/s.
    #[must_use]
    pub fn kbit_per_s(self) -> u32 {
        RATES.get(usize::from(self.0)).copied().unwrap_or(0)
    }
}

impl FromStr for BitRate {
    type Err = UrlError;

    /// `500k`, `500000` or `1M`; a number up to 1000 is in kbit/s.
    fn from_str(text: &str) -> Result<Self, UrlError> {
        let kbit_per_s = match (text.strip_suffix(['k', 'K']), text.strip_suffix('M')) {
            (Some(kilo), _) => kilo.parse().ok(),
            (_, Some(mega)) => mega.parse::<u32>().ok().and_then(|mega| mega.checked_mul(1000)),
            _ => text.parse().ok().and_then(plain),
        };
        let digit = kbit_per_s.and_then(|rate| RATES.iter().position(|known| *known == rate));
        let digit = digit.and_then(|digit| u8::try_from(digit).ok());
        digit.map(Self).ok_or_else(|| {
            UrlError(format!(
                "`{text}` is no bit rate of slcan; it has 10k, 20k, 50k, 100k, 125k, 250k, 500k, 800k and 1M"
            ))
        })
    }
}

fn plain(rate: u32) -> Option<u32> {
    match rate {
        0..=1000 => Some(rate),
        _ if rate.is_multiple_of(1000) => Some(rate / 1000),
        _ => None,
    }
}

fn serial(rest: &str) -> Result<Url, UrlError> {
    let (device, bit_rate) = with_bit_rate(rest)?;
    if device.is_empty() {
        return Err(UrlError("a serial device is missing, as in slcan:/dev/ttyACM0".into()));
    }
    Ok(Url::Slcan {
        device: device.to_owned(),
        bit_rate,
    })
}

fn slcan_tcp(rest: &str) -> Result<Url, UrlError> {
    let (address, bit_rate) = with_bit_rate(rest)?;
    Ok(Url::SlcanTcp {
        address: with_port(address)?,
        bit_rate,
    })
}

/// What stands before and behind the last `@`.
fn with_bit_rate(text: &str) -> Result<(&str, Option<BitRate>), UrlError> {
    match text.rsplit_once('@') {
        Some((before, rate)) => Ok((before, Some(rate.parse()?))),
        None => Ok((text, None)),
    }
}

fn socketcand(rest: &str) -> Result<Url, UrlError> {
    let missing = || UrlError("an interface is missing, as in socketcand://host/can0".into());
    let (address, name) = rest.split_once('/').ok_or_else(missing)?;
    let address = with_port(address).or_else(|_| with_port(&format!("{address}:{SOCKETCAND_PORT}")))?;
    Ok(Url::Socketcand {
        address,
        interface: interface(name)?,
    })
}

/// What stands behind `//`.
fn host(rest: &str) -> Result<&str, UrlError> {
    let host = rest.strip_prefix("//").map(|host| host.trim_end_matches('/'));
    host.ok_or_else(|| UrlError(format!("`//` is missing before the host; the forms are {FORMS}")))
}

/// `host:port`.
fn with_port(address: &str) -> Result<String, UrlError> {
    let is_whole = address
        .rsplit_once(':')
        .is_some_and(|(host, port)| !host.is_empty() && port.parse::<u16>().is_ok());
    if !is_whole {
        return Err(UrlError(format!("`{address}` is not host:port, as in localhost:4711")));
    }
    Ok(address.to_owned())
}

/// Linux takes up to 15 bytes.
fn interface(name: &str) -> Result<String, UrlError> {
    if name.is_empty() || name.len() > 15 || name.contains(|c: char| c == '/' || c.is_whitespace()) {
        return Err(UrlError(format!("`{name}` is no name of a CAN interface, as can0 is")));
    }
    Ok(name.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_read_is_written_as_it_was() {
        for text in [
            "slcan:/dev/ttyACM0",
            "slcan:/dev/serial/by-id/usb@2@500k",
            "slcan+tcp://localhost:4711",
            "slcan+tcp://[::1]:4711@1000k",
            "slcan+tcp-listen://0.0.0.0:0",
            "socketcan:can0",
            "socketcand://pi:29536/can0",
            "virtual:",
            "virtual:a:b",
        ] {
            assert_eq!(text.parse::<Url>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn bit_rates_are_read_with_their_units_and_without() {
        for text in ["500k", "500", "500000", "500K"] {
            assert_eq!(text.parse::<BitRate>().unwrap().kbit_per_s(), 500, "{text}");
        }
        assert_eq!("1M".parse::<BitRate>().unwrap().digit(), 8);
        for text in ["", "333k", "500001", "5000000M", "-1", "1m"] {
            assert!(text.parse::<BitRate>().is_err(), "{text}");
        }
    }

    #[test]
    fn a_name_that_is_none_is_told_how_it_is_to_be() {
        for (text, told) in [
            ("can0", "socketcan:can0"),
            ("usb:can0", "no kind of bus `usb`"),
            ("slcan+tcp:localhost:4711", "`//` is missing"),
            ("slcan+tcp://localhost", "not host:port"),
            ("slcan+tcp://localhost:99999", "not host:port"),
            ("slcan:", "slcan:/dev/ttyACM0"),
            ("slcan:/dev/ttyACM0@3k", "800k"),
            ("socketcand://pi", "socketcand://host/can0"),
            ("socketcan:a name", "no name of a CAN interface"),
        ] {
            let error = text.parse::<Url>().unwrap_err().to_string();
            assert!(error.contains(told), "{text}: {error}");
        }
    }

    #[test]
    fn socketcand_has_a_port_of_its_own() {
        let url: Url = "socketcand://pi/can0".parse().unwrap();
        assert_eq!(url.to_string(), "socketcand://pi:29536/can0");
    }
}
