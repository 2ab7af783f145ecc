//! What is stored: when it is loaded, and when it is written.

use super::Node;
use crate::{
    lss::BitRate,
    od::{self, Device, Reset, ServiceSet},
    storage::{self, Change, Group},
    AbortCode, NodeId,
};

pub(super) const DONE: u8 = 0;
pub(super) const NOT_SUPPORTED: u8 = 1;
const ACCESS_ERROR: u8 = 2;

impl<D: Device> Node<D> {
    /// Stores the values of `group` as they are now, as a client does by writing `save` to its sub-index of 1010h.
    ///
    /// # Errors
    /// * [`AbortCode::NOT_STORED`] without a storage
    /// * [`AbortCode::HARDWARE_ERROR`] when it fails; then what was stored before is stored
    pub fn save(&mut self, group: Group) -> Result<(), AbortCode> {
        self.change(Change::Save(group))
    }

    /// Forgets what is stored of `group`, as a client does by writing `load` to its sub-index of 1011h: with the next reset
    /// its values are the defaults.
    ///
    /// # Errors
    /// As [`Node::save`].
    pub fn restore(&mut self, group: Group) -> Result<(), AbortCode> {
        self.change(Change::Forget(group))
    }

    fn change(&mut self, change: Change) -> Result<(), AbortCode> {
        if storage::capabilities(&mut self.device) == 0 {
            return Err(AbortCode::NOT_STORED);
        }
        storage::change(&mut self.device, change).map_err(|_| AbortCode::HARDWARE_ERROR)
    }

    /// Stores what LSS has configured; gives the error code of CiA 305, 6.3.5.
    pub(super) fn store_settings(&mut self) -> u8 {
        if storage::capabilities(&mut self.device) == 0 {
            return NOT_SUPPORTED;
        }
        if storage::change(&mut self.device, Change::Set(self.lss.settings())).is_err() {
            return ACCESS_ERROR;
        }
        self.lss.stored();
        DONE
    }

    /// Gives the values of `device` what is stored; tells the node-ID and bit rate to start with.
    pub(super) fn power_on(device: &mut D, node_id: NodeId) -> (NodeId, Option<BitRate>) {
        let image = storage::newest(device);
        let image_of_lss = image.filter(|_| D::SERVICES.has(ServiceSet::LSS));
        let settings = image_of_lss.and_then(|image| storage::settings(device, image));
        let node_id = settings.map_or(node_id, |settings| settings.node_id);
        od::resolve_node_id(device, node_id);
        Self::show(device, image, Reset::Node);
        (node_id, settings.and_then(|settings| settings.bit_rate))
    }

    /// Gives the values that were reset what is stored.
    pub(super) fn load(&mut self, reset: Reset) {
        let image = storage::newest(&mut self.device);
        Self::show(&mut self.device, image, reset);
    }

    fn show(device: &mut D, image: Option<storage::Image>, reset: Reset) {
        if D::SERVICES.has(ServiceSet::STORAGE) {
            storage::show_capabilities(device);
        }
        if let Some(image) = image {
            storage::load(device, image, reset);
        }
    }
}
