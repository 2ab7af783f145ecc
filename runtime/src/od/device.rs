//! What the services need of a device.

use super::{NumberSet, Part, ServiceSet, Table, Value};
use crate::{heartbeat::Watch, lss::BitRates, pdo::Room, sdo::Channel, storage::Storage, AbortCode, Address, Event};

/// A device: the dictionary that was generated for it, and the application behind it.
///
/// Implemented by generated code; an application implements the generated `Handlers` trait instead. The methods that
/// give a dictionary's parts are to be `#[inline]`: then what is constant in flash is constant to the services too, and
/// a service whose objects do not exist is compiled to nothing.
pub trait Device {
    /// Room for the longest string among the values, `[u8; N]`: an SDO transfer is collected in it, so that a string is
    /// never stored or sent half old, half new. At least 8 bytes, for the longest number.
    type Buffer: AsRef<[u8]> + AsMut<[u8]>;

    /// Room for the PDOs that the dictionary has objects for: [`Pdos`](crate::pdo::Pdos).
    type Pdos: Room;

    /// Room for the nodes whose heartbeats are watched, `[Watch; N]`: one for each sub-index of 1016h.
    type Watches: AsRef<[Watch]> + AsMut<[Watch]>;

    /// Room for the SDO servers beyond the first, `[Channel<Self::Buffer>; N]`: one for each of 1201h to 127Fh.
    type Servers: AsRef<[Channel<Self::Buffer>]> + AsMut<[Channel<Self::Buffer>]>;

    /// Memory for what is stored when the power is off: [`NoStorage`](crate::storage::NoStorage) for none.
    type Storage: Storage;

    /// The optional services that it has. All of them unless overridden: then the objects that exist at run time decide.
    const SERVICES: ServiceSet = ServiceSet::ALL;

    /// The kinds of numbers that it has. All of them unless overridden.
    const NUMBERS: NumberSet = NumberSet::ALL;

    /// The dictionary's entries.
    fn table(&self) -> Table<'_>;

    /// The bytes of the values.
    fn values(&self) -> &[u8];

    /// The bytes of the values, to write.
    fn values_mut(&mut self) -> &mut [u8];

    /// The bytes of the values after power-on, laid out as [`Device::values`], with 0 for `$NODEID`. Those that are not there
    /// are 0.
    fn defaults(&self) -> &[u8];

    /// An empty buffer.
    fn buffer(&self) -> Self::Buffer;

    /// Room for the PDOs, not used yet.
    fn pdos(&self) -> Self::Pdos;

    /// Room for the nodes that are watched, not used yet.
    fn watches(&self) -> Self::Watches;

    /// Room for the SDO servers beyond the first, not used yet.
    fn servers(&self) -> Self::Servers;

    /// The data types that may stand in an RPDO's mapping for bits that mean nothing (`[DummyUsage]` of an EDS): bit 1 for
    /// 0001h, up to bit 7 for 0007h. None unless overridden.
    fn dummy_usage(&self) -> u8 {
        0
    }

    /// Memory for what is stored when the power is off, if there is any. None unless overridden: then 1010h and 1011h read as
    /// the dictionary says, and refuse to be written.
    fn storage(&mut self) -> Option<&mut Self::Storage> {
        None
    }

    /// The bit rates that LSS may set (`BaudRate_...` of an EDS). All of CiA 305's table unless overridden.
    fn bit_rates(&self) -> BitRates {
        BitRates::ALL
    }

    /// Asks the application to bring the value at `address` up to date in [`Device::values_mut`] before it is read.
    ///
    /// Called only for entries with [`Access::READ_HANDLER`](super::Access::READ_HANDLER).
    ///
    /// # Errors
    /// The abort code that the client is to be answered with.
    fn before_read(&mut self, address: Address) -> Result<(), AbortCode>;

    /// Offers the application the value that is about to be stored at `address`, its length and limits checked.
    ///
    /// Called only for entries with [`Access::WRITE_HANDLER`](super::Access::WRITE_HANDLER).
    ///
    /// # Errors
    /// The abort code that the client is to be answered with; then nothing is stored.
    fn before_write(&mut self, address: Address, value: Value<'_>) -> Result<(), AbortCode>;

    /// Asks the application for bytes of the value at `address`: it copies those from `offset` on into `buffer`, as many as
    /// there are and fit. Gives the length of the whole value, the same from the first byte to the last.
    ///
    /// Called only for entries with [`Access::PARTS`](super::Access::PARTS), for the same byte again when a client has missed
    /// it.
    ///
    /// # Errors
    /// The abort code that the client is to be answered with. [`AbortCode::NO_DATA`] unless overridden.
    fn read_part(&mut self, address: Address, offset: usize, buffer: &mut [u8]) -> Result<usize, AbortCode> {
        let _ = (address, offset, buffer);
        Err(AbortCode::NO_DATA)
    }

    /// Gives the application a part of the value that a client writes to `address`.
    ///
    /// Called only for entries with [`Access::PARTS`](super::Access::PARTS).
    ///
    /// # Errors
    /// The abort code that the client is to be answered with. [`AbortCode::NOT_STORED`] unless overridden.
    fn write_part(&mut self, address: Address, part: Part<'_>) -> Result<(), AbortCode> {
        let _ = (address, part);
        Err(AbortCode::NOT_STORED)
    }

    /// Tells the application what has happened. Does nothing unless overridden.
    fn event(&mut self, event: Event) {
        let _ = event;
    }
}

/// How much an NMT command resets (CiA 301, 7.3.2.2.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Reset {
    /// Reset node: the whole dictionary.
    Node,
    /// Reset communication: 1000h to 1FFFh.
    Communication,
}

impl Reset {
    /// Whether it is about the object at `index`.
    pub(crate) const fn includes(self, index: u16) -> bool {
        match self {
            Self::Node => true,
            Self::Communication => index & 0xF000 == 0x1000,
        }
    }
}
