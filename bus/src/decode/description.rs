//! What an EDS says of the objects of a node, prepared for looking up.

use std::collections::{BTreeMap, HashMap};

use lexican_eds::{
    ir::{self, DataType, Dictionary, Entry, Object, Value},
    render::printable,
};
use lexican_runtime::{Address, NodeId};

/// 1000h: the device profile is in the low half.
const DEVICE_TYPE: ir::Address = ir::Address::new(0x1000, 0);
/// The device profile of encoders.
const ENCODER: u16 = 406;

/// A device's objects by address.
#[derive(Clone, Debug, Default)]
pub struct Description {
    objects: HashMap<Address, Described>,
    /// The defaults of the communication parameters.
    parameters: Vec<(Address, DataType, Value)>,
    is_encoder: bool,
}

/// An object's name and type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Described {
    /// `Position value`; of an array's or record's sub-index `Identity object, Vendor-ID`. Nothing in it steers a terminal.
    pub name: String,
    /// The data type.
    pub data_type: DataType,
    /// Whether it is the only value of its object, so that the index alone names it.
    pub is_alone: bool,
}

impl Description {
    /// What `dictionary` says.
    #[must_use]
    pub fn new(dictionary: &Dictionary) -> Self {
        let mut description = Self {
            is_encoder: device_profile(dictionary) == Some(ENCODER),
            ..Self::default()
        };
        for object in &dictionary.objects {
            for entry in &object.entries {
                description.add(object, entry);
            }
        }
        description
    }

    fn add(&mut self, object: &Object, entry: &Entry) {
        let address = Address::new(entry.address.index, entry.address.sub);
        let described = Described {
            name: name(object, entry),
            data_type: entry.data_type,
            is_alone: is_alone(object, entry),
        };
        self.objects.insert(address, described);
        if let Some(default) = entry.default.as_ref().filter(|_| is_parameter(address)) {
            self.parameters.push((address, entry.data_type, default.clone()));
        }
    }

    /// The object at `address`.
    #[must_use]
    pub fn object(&self, address: Address) -> Option<&Described> {
        self.objects.get(&address)
    }

    /// Whether it is an encoder of CiA 406.
    #[must_use]
    pub const fn is_encoder(&self) -> bool {
        self.is_encoder
    }

    /// The communication parameters of the node `node_id` after power-on.
    pub(super) fn parameters(&self, node_id: NodeId) -> BTreeMap<Address, u64> {
        let node_id = ir::NodeId::new(node_id.get());
        let number = |bytes: &[u8]| {
            bytes
                .iter()
                .rev()
                .fold(0, |number, byte| number << 8 | u64::from(*byte))
        };
        let values = self.parameters.iter();
        values
            .map(|(address, data_type, value)| (*address, number(&value.to_bytes(*data_type, node_id))))
            .collect()
    }
}

/// Whether the object says which frame is of which service, or what is in a PDO.
pub(super) const fn is_parameter(address: Address) -> bool {
    matches!(address.index, 0x1005 | 0x1012 | 0x1014 | 0x1200..=0x127F | 0x1400..=0x1BFF)
}

fn device_profile(dictionary: &Dictionary) -> Option<u16> {
    match dictionary.entry(DEVICE_TYPE)?.default {
        Some(Value::Unsigned(value)) => u16::try_from(value & 0xFFFF).ok(),
        _ => None,
    }
}

fn is_alone(object: &Object, entry: &Entry) -> bool {
    object.entries.len() == 1 && entry.address.sub == 0
}

fn name(object: &Object, entry: &Entry) -> String {
    match (printable(&object.name), printable(&entry.name)) {
        (name, _) if is_alone(object, entry) => name,
        (object, entry) if entry.is_empty() => object,
        (object, entry) if object.is_empty() => entry,
        (object, entry) => format!("{object}, {entry}"),
    }
}
