//! The three lists of objects.

use crate::{
    ir::ObjectList,
    model::{Eds, List},
};

/// The lists that the file has.
pub(super) fn lists(eds: &Eds) -> impl Iterator<Item = (ObjectList, &List<u16>)> {
    let lists = [
        (ObjectList::Mandatory, &eds.mandatory),
        (ObjectList::Optional, &eds.optional),
        (ObjectList::Manufacturer, &eds.manufacturer),
    ];
    lists
        .into_iter()
        .filter_map(|(name, list)| Some((name, list.as_ref()?)))
}

impl ObjectList {
    /// The list that `index` belongs in, as far as CiA 301 says it; a profile may make an optional object mandatory.
    pub(super) const fn of(index: u16) -> Self {
        match index {
            0x1000 | 0x1001 | 0x1018 => Self::Mandatory,
            0x2000..=0x5FFF => Self::Manufacturer,
            _ => Self::Optional,
        }
    }

    /// The name of its section.
    pub(super) const fn section(self) -> &'static str {
        match self {
            Self::Mandatory => "MandatoryObjects",
            Self::Optional => "OptionalObjects",
            Self::Manufacturer => "ManufacturerObjects",
        }
    }
}
