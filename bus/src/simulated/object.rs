//! An object as a simulated device is told of it.

use lexican_eds::ir;
use lexican_runtime::{
    Address,
    od::{Access, DataType},
};

/// A value that a simulated device is to have.
#[derive(Clone, Debug)]
pub struct Object {
    /// Index and sub-index.
    pub address: Address,
    /// The data type.
    pub data_type: DataType,
    /// [`Access::READ`], [`Access::WRITE`], [`Access::NODE_ID`] and whether it may be mapped.
    pub access: Access,
    /// The value after power-on, as on the bus.
    pub default: Vec<u8>,
    /// Low and high limit, as on the bus.
    pub limits: Option<(Vec<u8>, Vec<u8>)>,
    /// How many bytes a string may have; the longer of this and the default counts.
    pub capacity: usize,
}

impl Object {
    /// A number of 1, 2, 4 or 8 bytes without limits, unsigned, which a client may read and write.
    ///
    /// # Panics
    /// When it has another length.
    #[must_use]
    pub fn number(index: u16, sub: u8, length: usize, default: u64) -> Self {
        let data_type = match length {
            1 => DataType::UNSIGNED8,
            2 => DataType::UNSIGNED16,
            4 => DataType::UNSIGNED32,
            8 => DataType::UNSIGNED64,
            _ => panic!("no number has {length} bytes"),
        };
        Self {
            address: Address::new(index, sub),
            data_type,
            access: Access::READ.with(Access::WRITE),
            default: default.to_le_bytes().into_iter().take(length).collect(),
            limits: None,
            capacity: 0,
        }
    }

    /// The same with `access` added.
    #[must_use]
    pub fn with(mut self, access: Access) -> Self {
        self.access = self.access.with(access);
        self
    }
}

/// How many bytes a string of an EDS may have at least; an EDS does not say.
const CAPACITY: usize = 64;

impl From<&ir::Entry> for Object {
    fn from(entry: &ir::Entry) -> Self {
        let bytes = |value: &ir::Value| value.to_bytes(entry.data_type, None);
        let length = entry.data_type.bytes().unwrap_or(0);
        let counted = entry.address.index == 0x1003 && entry.address.sub != 0;
        let formula = matches!(entry.default, Some(ir::Value::NodeIdPlus(_)));
        Self {
            address: Address::new(entry.address.index, entry.address.sub),
            data_type: DataType(u8::try_from(entry.data_type.index()).unwrap_or(0)),
            access: access(entry.access)
                .with(if formula { Access::NODE_ID } else { Access(0) })
                .with(if counted { Access::COUNTED } else { Access(0) })
                .with(mappable(entry)),
            default: entry.default.as_ref().map_or_else(|| vec![0; length], bytes),
            limits: entry
                .low
                .as_ref()
                .zip(entry.high.as_ref())
                .map(|(low, high)| (bytes(low), bytes(high))),
            capacity: if length == 0 { CAPACITY } else { 0 },
        }
    }
}

fn access(access: ir::AccessType) -> Access {
    match (access.readable(), access.writable()) {
        (true, true) => Access::READ.with(Access::WRITE),
        (false, _) => Access::WRITE,
        (true, false) => Access::READ,
    }
}

/// Into which PDOs it may be mapped (CiA 306-1, AccessType).
fn mappable(entry: &ir::Entry) -> Access {
    match entry.access {
        _ if !entry.pdo_mapping => Access(0),
        ir::AccessType::Rw => Access::TPDO.with(Access::RPDO),
        ir::AccessType::Wo | ir::AccessType::Rww => Access::RPDO,
        _ => Access::TPDO,
    }
}
