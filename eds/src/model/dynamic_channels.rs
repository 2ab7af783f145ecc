//! `[DynamicChannels]` (CiA 306-1): objects that a program creates at run time (CiA 302-4).

use std::collections::HashMap;

use super::Expected;
use super::field::{Fields, first};
use crate::document::{Entry, Keyword, Section};
use crate::ir::AccessType;
use crate::literal::{Fault, Literal, unsigned};
use crate::span::{Span, Spanned};

/// `[DynamicChannels]`
#[derive(Clone, Debug, Default)]
pub struct DynamicChannels {
    /// The section's header.
    pub header: Span,
    /// NrOfSeg: how many segments the file says there are.
    pub nr_of_seg: Option<Spanned<u32>>,
    /// In the order in which the file first names them.
    pub segments: Vec<Segment>,
}

/// The keywords with one number: `Type1`, `Dir1`, `Range1`, `PPOffset1`.
#[derive(Clone, Debug, Default)]
pub struct Segment {
    /// The number.
    pub number: u32,
    /// Type: the index of the data type.
    pub data_type: Option<Spanned<u16>>,
    /// Dir: `ro` for outputs of the program, `rww` for inputs.
    pub direction: Option<Spanned<AccessType>>,
    /// Range: the first and the last index.
    pub range: Option<Spanned<(u16, u16)>>,
    /// PPOffset: where in the process picture the segment starts.
    pub pp_offset: Option<Spanned<PpOffset>>,
    /// MaxCnt, before EDS version 4: how many objects there can be.
    pub max_cnt: Option<Spanned<u32>>,
}

/// `0`, or `0, 1` of a BOOLEAN segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PpOffset {
    /// The address of the first object.
    pub offset: u32,
    /// How far the addresses of two objects are apart; of BOOLEAN segments only.
    pub address_difference: Option<u32>,
}

pub(super) fn read(fields: &mut Fields<'_>, section: &Section) -> DynamicChannels {
    let mut channels = DynamicChannels {
        header: section.header,
        ..DynamicChannels::default()
    };
    let mut places = HashMap::new();
    for entry in &section.entries {
        match entry.keyword {
            Keyword::NrOfSeg => first(&mut channels.nr_of_seg, fields.number(entry)),
            Keyword::Type(number)
            | Keyword::Dir(number)
            | Keyword::Range(number)
            | Keyword::PpOffset(number)
            | Keyword::MaxCnt(number) => {
                let place = *places.entry(number).or_insert(channels.segments.len());
                if place == channels.segments.len() {
                    channels.segments.push(Segment::new(number));
                }
                channels.segments[place].read(fields, entry);
            }
            _ => fields.misplaced(entry),
        }
    }
    channels
}

impl Segment {
    fn new(number: u32) -> Self {
        Self {
            number,
            ..Self::default()
        }
    }

    fn read(&mut self, fields: &mut Fields<'_>, entry: &Entry) {
        match entry.keyword {
            Keyword::Type(_) => first(&mut self.data_type, fields.data_type(entry)),
            Keyword::Dir(_) => first(&mut self.direction, fields.access(entry)),
            Keyword::Range(_) => first(&mut self.range, fields.read(entry, Expected::IndexRange, range)),
            Keyword::PpOffset(_) => first(&mut self.pp_offset, fields.read(entry, Expected::PpOffset, pp_offset)),
            _ => first(&mut self.max_cnt, fields.number(entry)),
        }
    }
}

/// `0xA080-0xA0BF`
fn range(text: &str) -> Result<Literal<(u16, u16)>, Fault> {
    let (first, last) = text.split_once('-').ok_or(Fault::NotANumber)?;
    Ok(Literal::plain((index(first.trim_end())?, index(last.trim_start())?)))
}

fn index(text: &str) -> Result<u16, Fault> {
    let index = unsigned(text, 0xFFFF)?.value;
    u16::try_from(index).map_err(|_| Fault::OutOfRange)
}

/// `0x10` or `0, 1`
fn pp_offset(text: &str) -> Result<Literal<PpOffset>, Fault> {
    let (offset, difference) = match text.split_once(',') {
        Some((offset, difference)) => (offset.trim_end(), Some(difference.trim_start())),
        None => (text, None),
    };
    Ok(Literal::plain(PpOffset {
        offset: address(offset)?,
        address_difference: difference.map(address).transpose()?,
    }))
}

fn address(text: &str) -> Result<u32, Fault> {
    let address = unsigned(text, u32::MAX.into())?.value;
    u32::try_from(address).map_err(|_| Fault::OutOfRange)
}
