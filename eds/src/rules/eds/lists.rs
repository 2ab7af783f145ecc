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

/// Whether a list's lines can be numbered anew. Where a number stands twice, readers differ in what is listed.
pub(super) fn is_plain(list: &List<u16>) -> bool {
    let mut numbers: Vec<u32> = list.items.iter().map(|item| item.number.value).collect();
    numbers.sort_unstable();
    numbers.is_sorted_by(|one, next| one < next)
}

/// Whether objects can be put into the list, which is plain then or not there at all.
pub(super) fn is_open(eds: &Eds, list: ObjectList) -> bool {
    let mut found = lists(eds).filter(|(name, _)| *name == list);
    found.next().is_none_or(|(_, list)| is_plain(list))
}

impl ObjectList {
    /// The list that `index` belongs in, as far as CiA 301 says it; a profile may make an optional object mandatory.
    pub(crate) const fn of(index: u16) -> Self {
        match index {
            0x1000 | 0x1001 | 0x1018 => Self::Mandatory,
            0x2000..=0x5FFF => Self::Manufacturer,
            _ => Self::Optional,
        }
    }

    /// The name of its section.
    pub(crate) const fn section(self) -> &'static str {
        match self {
            Self::Mandatory => "MandatoryObjects",
            Self::Optional => "OptionalObjects",
            Self::Manufacturer => "ManufacturerObjects",
        }
    }
}
