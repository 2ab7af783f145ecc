//! Connected modules (CiA 306-1, 4.7 and 5.4): what each adds to the bus coupler's dictionary.

use std::collections::{HashMap, HashSet};

use super::{Lowering, Problem, entry, object};
use crate::ir::{Address, DataType, Entry, Object, ObjectCode, Value};
use crate::model::{Count, Eds, List, Module, SubExtension};

/// Object 1027h has that many sub-indices for modules (CiA 301, 7.5.2.27).
const MOST_MODULES: usize = 254;

/// The highest sub-index that can be used.
const HIGHEST: u8 = 254;

/// Adds to `objects` what the connected modules bring, in the order of their places.
pub(super) fn compose(eds: &Eds, objects: &mut Vec<Object>, lowering: &mut Lowering) {
    let Some(connected) = &eds.connected_modules else {
        return;
    };
    let mut places: Vec<_> = connected.items.iter().collect();
    places.sort_by_key(|place| place.number.value);
    if let Some(beyond) = places.get(MOST_MODULES) {
        lowering.report(Problem::TooManyModules { at: beyond.value.span });
    }
    let mut composition = Composition::new(objects, lowering);
    for place in places.into_iter().take(MOST_MODULES) {
        let number = place.value.value;
        match eds.modules.binary_search_by_key(&number, |module| module.number) {
            Ok(at) => composition.connect(&eds.modules[at]),
            Err(_) => composition.lowering.report(Problem::UnknownModule {
                number,
                at: place.value.span,
            }),
        }
    }
}

struct Composition<'a> {
    objects: &'a mut Vec<Object>,
    lowering: &'a mut Lowering,
    /// Where an object stands in `objects`.
    places: HashMap<u16, usize>,
    /// The modules whose fixed objects are there.
    known: HashSet<u16>,
    /// Where the next sub-object of an extended object goes, by the index that the extension names.
    extended: HashMap<u16, Extended>,
}

/// How far an object is extended.
struct Extended {
    /// The index in use: the one that the extension names, or one after it.
    index: u16,
    /// Bits of the last sub-object that no module uses yet.
    free_bits: u8,
}

impl<'a> Composition<'a> {
    fn new(objects: &'a mut Vec<Object>, lowering: &'a mut Lowering) -> Self {
        let places = objects
            .iter()
            .enumerate()
            .map(|(place, object)| (object.index, place))
            .collect();
        Self {
            objects,
            lowering,
            places,
            known: HashSet::new(),
            extended: HashMap::new(),
        }
    }

    fn connect(&mut self, module: &Module) {
        if self.known.insert(module.number) {
            self.add_fixed(module);
        }
        for extension in &module.extensions {
            self.extend(extension);
        }
    }

    /// Fixed objects are there once, however many modules of the kind are connected.
    fn add_fixed(&mut self, module: &Module) {
        for fixed in &module.fixed {
            if !self.places.contains_key(&fixed.index) {
                let object = object::lower(fixed, self.lowering);
                if let Some(object) = object {
                    self.push(object);
                }
            }
        }
        for listed in module.fixed_objects.iter().flat_map(List::values) {
            if !self.places.contains_key(&listed.value) {
                self.lowering.report(Problem::AbsentModuleObject {
                    number: module.number,
                    index: listed.value,
                    at: listed.span,
                });
            }
        }
    }

    fn push(&mut self, object: Object) {
        self.places.insert(object.index, self.objects.len());
        self.objects.push(object);
    }

    fn extend(&mut self, extension: &SubExtension) {
        let added = match extension.count.map(|count| count.value) {
            Some(Count::Subs(subs)) => (0..subs).try_for_each(|_| self.add_sub(extension)),
            Some(Count::Bits(bits)) => self.add_bits(extension, bits),
            None => self.add_sub(extension),
        };
        if let Err(problem) = added {
            self.lowering.report(problem);
        }
    }

    /// Takes bits of the last sub-object, and further sub-objects when they are used up.
    fn add_bits(&mut self, extension: &SubExtension, bits: u8) -> Result<(), Problem> {
        let data_type = extension.description.data_type;
        let data_type = data_type.and_then(|index| DataType::from_index(index.value));
        let width = data_type.and_then(DataType::bits).unwrap_or(8);
        let extended = self.extended.get(&extension.index);
        let mut free = extended.map_or(0, |extended| extended.free_bits);
        let mut needed = bits;
        while needed > free {
            needed -= free;
            self.add_sub(extension)?;
            free = width;
        }
        if let Some(extended) = self.extended.get_mut(&extension.index) {
            extended.free_bits = free - needed;
        }
        Ok(())
    }

    /// Adds one sub-object behind the last one; in the next object when this one is full.
    fn add_sub(&mut self, extension: &SubExtension) -> Result<(), Problem> {
        let (index, at) = (extension.index, extension.description.header);
        let address = self
            .next_free(extension)
            .ok_or(Problem::NoRoomForModule { index, at })?;
        if !self.lowering.take_room(1) {
            return Err(Problem::TooManyValues { index, at });
        }
        let entry = sub_object(address, extension, self.lowering);
        if let Some(object) = self.object_at(address.index) {
            object.entries.push(entry);
            let sub_zero = object.entries.first_mut();
            if let Some(sub_zero) = sub_zero.filter(|entry| entry.data_type.is_unsigned()) {
                sub_zero.default = Some(Value::Unsigned(address.sub.into()));
            }
        }
        let extended = Extended {
            index: address.index,
            free_bits: 0,
        };
        self.extended.insert(index, extended);
        Ok(())
    }

    /// Where the next sub-object goes: ObjExtend is the last sub-index of an object before the next index is used; if it
    /// is 0, the next index is not used.
    fn next_free(&mut self, extension: &SubExtension) -> Option<Address> {
        let index = self
            .extended
            .get(&extension.index)
            .map_or(extension.index, |extended| extended.index);
        let (limit, next) = match extension.obj_extend.map_or(0, |limit| limit.value) {
            0 => (HIGHEST, None),
            limit => (limit.min(HIGHEST), index.checked_add(1)),
        };
        let highest = self.highest(index, extension)?;
        if highest < limit {
            return Some(Address::new(index, highest + 1));
        }
        let highest = self.highest(next?, extension)?;
        (highest < limit).then_some(Address::new(next?, highest + 1))
    }

    /// The highest sub-index of an object, which is made if it is not there; `None` if it has no sub-indices.
    fn highest(&mut self, index: u16, extension: &SubExtension) -> Option<u8> {
        if !self.places.contains_key(&index) {
            self.push(array(index, extension));
        }
        let object = self
            .object_at(index)
            .filter(|object| object::is_structured(object.code))?;
        if object.entries.is_empty() {
            object.entries.push(entry::sub_zero(index, 0, object.span));
        }
        object.entries.last().map(|last| last.address.sub)
    }

    fn object_at(&mut self, index: u16) -> Option<&mut Object> {
        let place = *self.places.get(&index)?;
        self.objects.get_mut(place)
    }
}

/// An object that is there by its extensions alone.
fn array(index: u16, extension: &SubExtension) -> Object {
    let header = extension.description.header;
    Object {
        index,
        name: entry::text(extension.description.parameter_name.as_ref()),
        code: ObjectCode::Array,
        list: None,
        entries: vec![entry::sub_zero(index, 0, header)],
        links: Vec::new(),
        span: header,
    }
}

fn sub_object(address: Address, extension: &SubExtension, lowering: &mut Lowering) -> Entry {
    let mut entry = entry::lower(address, &extension.description, None, lowering);
    entry.name.push_str(&address.sub.to_string());
    entry
}
