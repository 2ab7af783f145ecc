//! Values that are not the file's, as far as no rule of their own looks at them.

use super::{
    answers::{Answered, answered},
    cob_id_of_another_node::other_node,
    impossible_mapping::impossible,
    shown::shown,
    value_beyond_limits::exceeded,
    wrong_highest_sub_index::is_highest_sub_index,
    wrong_identity::is_identity,
    wrong_sdo_cob_id::predefined,
};
use crate::{
    dump::Dump,
    ir::{DataType, Dictionary, NodeId},
};

/// A value of the device that is not the one that the file gives.
pub(super) struct Difference<'a> {
    pub(super) answer: Answered<'a>,
    expected: Vec<u8>,
}

impl Difference<'_> {
    /// `2000h answers 0x05; the file says 0x0A`
    pub(super) fn message(&self) -> String {
        let data_type = self.answer.entry.data_type;
        let (found, expected) = (shown(self.answer.bytes, data_type), shown(&self.expected, data_type));
        format!("{} answers {found}; the file says {expected}", self.answer.named())
    }
}

/// The values that differ from the file's, without those of which another rule says what is wrong.
pub(super) fn differences<'a>(dictionary: &'a Dictionary, dump: &'a Dump) -> impl Iterator<Item = Difference<'a>> {
    answered(dictionary, dump).filter_map(move |answer| {
        let expected = expected_instead(&answer, dump.node_id)?;
        (!is_spoken_for(dictionary, dump, &answer)).then_some(Difference { answer, expected })
    })
}

fn is_spoken_for(dictionary: &Dictionary, dump: &Dump, answer: &Answered<'_>) -> bool {
    let (address, node_id) = (answer.entry.address, dump.node_id);
    is_identity(address)
        || is_highest_sub_index(answer.object, answer.entry)
        || predefined(address, node_id).is_some()
        || other_node(answer, node_id).is_some()
        || exceeded(answer, node_id).is_some()
        || impossible(dictionary, dump, answer).is_some()
}

/// The bytes that the file gives in place of those that the device answered; `None` when they are the same, when the file
/// gives none, and when the answer's length is wrong already.
pub(super) fn expected_instead(answer: &Answered<'_>, node_id: NodeId) -> Option<Vec<u8>> {
    let data_type = answer.entry.data_type;
    let expected = answer.entry.default.as_ref()?.to_bytes(data_type, Some(node_id));
    let differs = content(&expected, data_type) != content(answer.bytes, data_type);
    (differs && answer.fits()).then_some(expected)
}

/// Whether the device answered what the file gives.
pub(super) fn is_default(answer: &Answered<'_>, node_id: NodeId) -> bool {
    answer.entry.default.is_some() && expected_instead(answer, node_id).is_none()
}

/// The bytes without what a device fills a VISIBLE_STRING up with: NUL is one of its characters (CiA 301), and shows nothing.
fn content(bytes: &[u8], data_type: DataType) -> &[u8] {
    let length = match data_type {
        DataType::VisibleString => bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1),
        _ => bytes.len(),
    };
    bytes.get(..length).unwrap_or(bytes)
}
