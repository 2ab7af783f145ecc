//! The whole dictionary.

use super::{Address, Commissioning, DataType, DeviceInfo, Entry, FileInfo, Object};

/// A device as its file describes it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dictionary {
    /// About the file.
    pub file: FileInfo,
    /// About the device.
    pub device: DeviceInfo,
    /// How it was configured; of a DCF only.
    pub commissioning: Option<Commissioning>,
    /// The dummy types that may fill a PDO (`[DummyUsage]`).
    pub dummies: Vec<DataType>,
    /// The objects, sorted by index, no index twice.
    pub objects: Vec<Object>,
}

impl Dictionary {
    /// The object at `index`.
    #[must_use]
    pub fn object(&self, index: u16) -> Option<&Object> {
        let at = self.objects.binary_search_by_key(&index, |object| object.index).ok()?;
        self.objects.get(at)
    }

    /// The value at `address`.
    #[must_use]
    pub fn entry(&self, address: Address) -> Option<&Entry> {
        self.object(address.index)?.entry(address.sub)
    }

    /// All values, in the order of index and sub-index.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.objects.iter().flat_map(|object| &object.entries)
    }
}
