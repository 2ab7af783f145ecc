//! The three object lists.

use super::{Lowering, Problem};
use crate::ir::{Object, ObjectList};
use crate::model::{Eds, List};
use crate::span::Span;

/// An index that a list names, and where.
struct Listed {
    index: u16,
    list: ObjectList,
    at: Span,
}

/// Tells each object the list that names it. `objects` are sorted.
pub(super) fn assign(eds: &Eds, objects: &mut [Object], lowering: &mut Lowering) {
    let mut objects = objects.iter_mut().peekable();
    for listed in listed_once(eds, lowering) {
        while objects.next_if(|object| object.index < listed.index).is_some() {}
        match objects.peek_mut().filter(|object| object.index == listed.index) {
            Some(object) => object.list = Some(listed.list),
            None => lowering.report(Problem::AbsentObject {
                index: listed.index,
                list: listed.list,
                at: listed.at,
            }),
        }
    }
}

/// Reports the objects that have sections but stand in no list. `objects` are sorted and know their lists.
pub(super) fn report_unlisted(eds: &Eds, objects: &[Object], lowering: &mut Lowering) {
    let mut fixed: Vec<u16> = eds
        .modules
        .iter()
        .filter_map(|module| module.fixed_objects.as_ref())
        .flat_map(List::values)
        .map(|index| index.value)
        .collect();
    fixed.sort_unstable();
    let unlisted = objects.iter().filter(|object| object.list.is_none());
    let described = unlisted.filter(|object| eds.object(object.index).is_some());
    let unlisted = described.filter(|object| fixed.binary_search(&object.index).is_err());
    lowering.problems.extend(unlisted.map(|object| Problem::UnlistedObject {
        index: object.index,
        at: object.span,
    }));
}

/// All listed indices, sorted; each once.
fn listed_once(eds: &Eds, lowering: &mut Lowering) -> Vec<Listed> {
    let lists = [
        (&eds.mandatory, ObjectList::Mandatory),
        (&eds.optional, ObjectList::Optional),
        (&eds.manufacturer, ObjectList::Manufacturer),
    ];
    let lists = lists
        .into_iter()
        .filter_map(|(list, kind)| Some((list.as_ref()?, kind)));
    let mut all: Vec<Listed> = lists.flat_map(|(list, kind)| listed(list, kind)).collect();
    all.sort_by_key(|listed| listed.index);
    all.dedup_by(|again, first| {
        let same = again.index == first.index;
        if same {
            lowering.report(Problem::ListedTwice {
                index: again.index,
                at: again.at,
                first: first.at,
            });
        }
        same
    });
    all
}

fn listed(list: &List<u16>, kind: ObjectList) -> impl Iterator<Item = Listed> {
    list.values().map(move |index| Listed {
        index: index.value,
        list: kind,
        at: index.span,
    })
}
