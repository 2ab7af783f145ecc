//! One device, asked for one value after the other.

use lexican_eds::{
    dump::{AbortCode, Answer, Dump, Identity},
    ir,
};
use lexican_runtime::{Address, NodeId};

use super::{Error, Order};
use crate::{
    sdo::{self, Channel, Client, Failure, Manner, Patience},
    transport::Transport,
};

/// After so many values in a row without an answer the node is asked for 1000h, which every device has.
const SILENCES: usize = 3;

/// A dump that is being taken.
///
/// ```no_run
/// use lexican_bus::{dump::{Order, Reader}, sdo::Patience, transport::Transport};
/// use lexican_eds::{dump::Dump, ir::NodeId};
///
/// # fn take(transport: &mut impl Transport) -> Result<Dump, lexican_bus::dump::Error> {
/// let node_id = NodeId::new(5).expect("1 to 127");
/// let mut reader = Reader::new(Dump::new(node_id), Order::scan(Order::ALL), Patience::default());
/// reader.identify(transport)?;
/// while let Some(address) = reader.step(transport)? {
///     println!("{address}: {:?}", reader.dump().answer(address));
/// }
/// # Ok(reader.into_dump())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Reader {
    client: Client,
    order: Order,
    dump: Dump,
    /// The values in a row that got no answer.
    silent: Vec<ir::Address>,
}

impl Reader {
    /// Reads into `dump` what of `order` it does not hold yet.
    #[must_use]
    pub fn new(dump: Dump, order: Order, patience: Patience) -> Self {
        Self {
            client: Client::new(channel(dump.node_id), patience),
            order: order.after(&dump),
            dump,
            silent: Vec::new(),
        }
    }

    /// Asks the device who it is; to be called once, before the first step.
    ///
    /// # Errors
    /// When the bus is gone, the node answers nothing, or it is another device than the one that the dump was begun with.
    pub fn identify(&mut self, transport: &mut impl Transport) -> Result<(), Error> {
        let device_type = self.ask(transport, ir::Address::new(0x1000, 0))?;
        if device_type == Answer::Timeout {
            return Err(Error::Silent(self.dump.node_id));
        }
        let mut fact = |sub| Ok::<_, Error>(number(&self.ask(transport, ir::Address::new(0x1018, sub))?));
        let identity = Identity {
            vendor_id: fact(1)?,
            product_code: fact(2)?,
            revision_number: fact(3)?,
            serial_number: fact(4)?,
            device_type: number(&device_type),
        };
        if self.dump.device.is_some_and(|device| device != identity) {
            return Err(Error::OtherDevice(self.dump.node_id));
        }
        self.dump.device = Some(identity);
        Ok(())
    }

    /// Asks for the next value: its address, or `None` at the end. A scan that finds nothing there keeps nothing.
    ///
    /// # Errors
    /// When the bus is gone, or the node answers nothing any more; what it was last asked for in vain is not kept then, so that
    /// a dump that goes on asks again.
    pub fn step(&mut self, transport: &mut impl Transport) -> Result<Option<ir::Address>, Error> {
        let Some(address) = self.order.present() else {
            return Ok(None);
        };
        let answer = self.ask(transport, address)?;
        self.note_silence(transport, address, &answer)?;
        if self.order.answered(&answer) {
            self.dump.objects.insert(address, answer);
        }
        Ok(Some(address))
    }

    /// How many steps are done.
    #[must_use]
    pub fn done(&self) -> usize {
        self.order.done()
    }

    /// How many steps there are; see [`Order::total`].
    #[must_use]
    pub const fn total(&self) -> usize {
        self.order.total()
    }

    /// What was read until now.
    #[must_use]
    pub const fn dump(&self) -> &Dump {
        &self.dump
    }

    /// What was read.
    #[must_use]
    pub fn into_dump(self) -> Dump {
        self.dump
    }

    fn ask(&mut self, transport: &mut impl Transport, address: ir::Address) -> Result<Answer, Error> {
        let address = Address::new(address.index, address.sub);
        let outcome = sdo::upload(transport, &mut self.client, address, Manner::Fastest)?;
        Ok(answer(outcome))
    }

    /// Tells a value that times out from a node that is gone.
    fn note_silence(
        &mut self,
        transport: &mut impl Transport,
        address: ir::Address,
        answer: &Answer,
    ) -> Result<(), Error> {
        if *answer != Answer::Timeout {
            self.silent.clear();
            return Ok(());
        }
        self.silent.push(address);
        if !self.silent.len().is_multiple_of(SILENCES) {
            return Ok(());
        }
        if self.ask(transport, ir::Address::new(0x1000, 0))? != Answer::Timeout {
            return Ok(());
        }
        for address in &self.silent {
            self.dump.objects.remove(address);
        }
        Err(Error::Silent(self.dump.node_id))
    }
}

fn channel(node_id: ir::NodeId) -> Channel {
    // Both mean 1 to 127.
    let node_id = NodeId::new(node_id.get());
    Channel::default_of(node_id.unwrap_or(LAST))
}

const LAST: NodeId = match NodeId::new(127) {
    Some(node_id) => node_id,
    None => unreachable!(),
};

/// How a dump tells the end of a transfer.
fn answer(outcome: Result<Vec<u8>, Failure>) -> Answer {
    match outcome {
        Ok(bytes) => Answer::Value(bytes),
        Err(Failure::Refused(code) | Failure::Broken(code)) => Answer::Abort(AbortCode(code.0)),
        Err(Failure::Silent { .. } | Failure::Rebooted) => Answer::Timeout,
    }
}

/// Four bytes, the lowest first.
fn number(answer: &Answer) -> Option<u32> {
    Some(u32::from_le_bytes(answer.value()?.try_into().ok()?))
}
