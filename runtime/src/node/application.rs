//! What the application asks of the node: its state, its device, its errors.

use super::{effects::Effects, Node, Pending};
use crate::{
    od::{self, Device, Value},
    wire::{
        emcy::Emergency,
        nmt::{NmtCommand, NmtState},
    },
    AbortCode, Address, NodeId,
};

impl<D: Device> Node<D> {
    /// The NMT state.
    #[inline]
    #[must_use]
    pub fn state(&self) -> NmtState {
        self.nmt.state()
    }

    /// The node-ID; `None` while the node waits for LSS to give it one.
    #[inline]
    #[must_use]
    pub fn node_id(&self) -> Option<NodeId> {
        self.id.configured()
    }

    /// Gives the node another node-ID: it resets its communication and boots up under the new one.
    pub fn set_node_id(&mut self, node_id: NodeId) {
        self.id = node_id;
        self.lss.set_node_id(node_id);
        od::resolve_node_id(&mut self.device, node_id);
        self.obey(NmtCommand::ResetCommunication);
    }

    /// The device: its dictionary and its application.
    #[inline]
    #[must_use]
    pub fn device(&self) -> &D {
        &self.device
    }

    /// The device, to change. What configures a service takes effect at the next [`Node::poll`], however it was written,
    /// but for the parameters of PDOs: use [`Node::write`] there.
    #[inline]
    pub fn device_mut(&mut self) -> &mut D {
        self.pending.add(Pending::CONFIGURATION);
        &mut self.device
    }

    /// The device, for the application to show what it has measured. As [`Node::device_mut`], but no service looks at its
    /// objects again: what configures one is not to be changed here.
    #[inline]
    pub fn application_mut(&mut self) -> &mut D {
        &mut self.device
    }

    /// Sets how long an SDO client may leave a transfer open, in ms; 1000 unless set.
    pub fn set_sdo_timeout(&mut self, timeout_ms: u32) {
        self.sdo.set_timeout(timeout_ms);
        for channel in self.channels.as_mut() {
            channel.set_timeout(timeout_ms);
        }
    }

    /// Reads the value at `address` as a client would, the application's handler included.
    ///
    /// # Errors
    /// As [`od::read`].
    pub fn read(&mut self, address: Address) -> Result<Value<'_>, AbortCode> {
        od::read(&mut self.device, address)
    }

    /// Writes `data`, little-endian as on the bus, to `address` as a client would: checked, and with its effects.
    ///
    /// # Errors
    /// As [`od::write()`].
    pub fn write(&mut self, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        let mut effects = Effects {
            pending: &mut self.pending,
            pdos: &mut self.pdos,
        };
        od::write(&mut self.device, &mut effects, address, data)
    }

    /// Reports an error: in the error register (1001h), the history (1003h) and an emergency message, each as far as the
    /// dictionary has it. The message waits while the node is not PRE-OPERATIONAL or OPERATIONAL.
    ///
    /// `false`, and nothing has happened, when the error stands already, so that it may be raised again and again while its
    /// cause is there; when [`STANDING`](crate::emcy::STANDING) others stand; or when its code is 0000h. A reset forgets all errors.
    pub fn raise_emergency(&mut self, emergency: Emergency) -> bool {
        let raised = self.emcy.raise(&mut self.device, emergency);
        self.tell_emergencies();
        raised
    }

    /// Reports that the error `code` is gone: an emergency message with error code 0000h says what is left in the error
    /// register. `false` when the error did not stand.
    pub fn clear_emergency(&mut self, code: u16) -> bool {
        let cleared = self.emcy.clear(&mut self.device, code);
        self.tell_emergencies();
        cleared
    }

    /// Whether the error `code` was raised and not cleared since, by the application or by a service.
    #[must_use]
    pub fn is_error_standing(&self, code: u16) -> bool {
        self.emcy.is_standing(code)
    }
}
