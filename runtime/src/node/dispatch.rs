//! CAN-ID → service.

use crate::{
    od::{Device, ServiceSet},
    wire::{CanId, Frame},
    NodeId,
};

/// Who a frame is for, with the data that it has been found to carry.
#[derive(Clone, Copy, Debug)]
pub(super) enum Service {
    /// NMT commands.
    Nmt,
    /// The SDO server: always eight bytes.
    Sdo([u8; 8]),
    /// The LSS slave: always eight bytes.
    Lss([u8; 8]),
    /// One whose identifier is configured, or nobody here.
    Other,
}

/// The service that `frame` is for.
#[inline]
pub(super) fn service<D: Device>(frame: &Frame, node_id: NodeId) -> Service {
    match frame.data_id() {
        Some(id) if id == CanId::sdo_request(node_id) => frame.full_data().map_or(Service::Other, Service::Sdo),
        Some(CanId::NMT) => Service::Nmt,
        Some(CanId::LSS_REQUEST) if D::SERVICES.has(ServiceSet::LSS) => {
            frame.full_data().map_or(Service::Other, Service::Lss)
        }
        _ => Service::Other,
    }
}
