use std::collections::{BTreeMap, btree_map::Entry as Slot};

use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary, Entry, Object},
    rules::{DictionaryRule, Report, declare_rule, quoted},
};

declare_rule! {
    /// ## What it does
    /// Finds sub-objects of one object with the same ParameterName, and objects with the same. Upper and lower case count as the same.
    /// One finding for an object. Communication objects, 1000h to 1FFFh, are left alone: the standard itself calls many of them alike.
    ///
    /// ## Why it matters
    /// Users of a tool see a list of equal names, and generators that make identifiers of them have to number them.
    ///
    /// ## Example
    /// ```ini
    /// [2100sub1]
    /// ParameterName=Point
    /// [2100sub2]
    /// ParameterName=Point
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2100sub1]
    /// ParameterName=Point 1
    /// [2100sub2]
    /// ParameterName=Point 2
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, ParameterName
    pub(crate) RepeatedName { code: "OBJ030", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for RepeatedName {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let mut names: BTreeMap<String, u16> = BTreeMap::new();
        // The standard itself calls all RPDOs alike.
        let own = dictionary
            .objects
            .iter()
            .filter(|object| !(0x1000..0x2000).contains(&object.index));
        for object in own {
            if let Some(first) = taken(&mut names, &object.name, object.index) {
                let index = object.index;
                let name = quoted(&object.name);
                report
                    .at(
                        object.span,
                        format!("{index:04X}h is called {name}, as {first:04X}h is"),
                    )
                    .help("give each object a name of its own");
            } else if let Some((entry, first)) = repeated(object) {
                let (address, name) = (entry.address, quoted(&entry.name));
                report
                    .at(entry.spans.name, format!("{address} is called {name}, as {first} is"))
                    .help("give each sub-object a name of its own");
            }
        }
    }
}

/// The first sub-object with the name of another, and that one.
fn repeated(object: &Object) -> Option<(&Entry, Address)> {
    let mut names = BTreeMap::new();
    object.entries.iter().find_map(|entry| {
        let first = taken(&mut names, &entry.name, entry.address)?;
        Some((entry, first))
    })
}

/// Who has the name already; an empty name is none.
fn taken<T: Copy>(names: &mut BTreeMap<String, T>, name: &str, owner: T) -> Option<T> {
    if name.is_empty() {
        return None;
    }
    match names.entry(name.to_ascii_lowercase()) {
        Slot::Occupied(first) => Some(*first.get()),
        Slot::Vacant(place) => {
            place.insert(owner);
            None
        }
    }
}
