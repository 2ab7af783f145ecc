//! `[DeviceComissioning]` (CiA 306-1, 5.3). The standard spells it with one m.

use super::field::{Fields, first};
use crate::document::{Keyword, Section};
use crate::span::{Span, Spanned};

/// `[DeviceComissioning]`: how a device is configured.
#[derive(Clone, Debug, Default)]
pub struct DeviceCommissioning {
    /// The section's header.
    pub header: Span,
    /// NodeID; any number, though only 1 to 127 is a node-ID.
    pub node_id: Option<Spanned<u8>>,
    /// NodeName
    pub node_name: Option<Spanned<String>>,
    /// NodeRefd: the node's reference designator.
    pub node_refd: Option<Spanned<String>>,
    /// Baudrate in kbit/s.
    pub baud_rate: Option<Spanned<u16>>,
    /// NetNumber
    pub net_number: Option<Spanned<u32>>,
    /// NetworkName
    pub network_name: Option<Spanned<String>>,
    /// NetRefd: the network's reference designator.
    pub net_refd: Option<Spanned<String>>,
    /// CANopenManager
    pub canopen_manager: Option<Spanned<bool>>,
    /// LSS_SerialNumber: 1018h sub 4.
    pub lss_serial_number: Option<Spanned<u32>>,
}

pub(super) fn read(fields: &mut Fields<'_>, section: &Section) -> DeviceCommissioning {
    let mut commissioning = DeviceCommissioning {
        header: section.header,
        ..DeviceCommissioning::default()
    };
    for entry in &section.entries {
        match entry.keyword {
            Keyword::NodeId => first(&mut commissioning.node_id, fields.number(entry)),
            Keyword::NodeName => first(&mut commissioning.node_name, fields.text(entry)),
            Keyword::NodeRefd => first(&mut commissioning.node_refd, fields.text(entry)),
            Keyword::CommissionedBaudRate => first(&mut commissioning.baud_rate, fields.number(entry)),
            Keyword::NetNumber => first(&mut commissioning.net_number, fields.number(entry)),
            Keyword::NetworkName => first(&mut commissioning.network_name, fields.text(entry)),
            Keyword::NetRefd => first(&mut commissioning.net_refd, fields.text(entry)),
            Keyword::CanopenManager => first(&mut commissioning.canopen_manager, fields.flag(entry)),
            Keyword::LssSerialNumber => first(&mut commissioning.lss_serial_number, fields.number(entry)),
            _ => fields.misplaced(entry),
        }
    }
    commissioning
}
