//! Modules of a modular device (CiA 306-1, 4.7): what a bus coupler's dictionary gets by each module plugged in.

use super::Expected;
use super::comments::{self, Comments};
use super::description::{self, Description};
use super::field::{Fields, first};
use super::list::{self, List};
use super::object::{self, Object, Sub, read_description};
use crate::document::{Entry, Keyword, ModulePart, Section};
use crate::literal::{Fault, Literal, unsigned};
use crate::span::{Span, Spanned};

/// The sections of one kind of module: `[M1ModuleInfo]` and so on.
#[derive(Clone, Debug, Default)]
pub struct Module {
    /// The kind's number, as [ConnectedModules](super::Eds::connected_modules) names it.
    pub number: u16,
    /// `[MxModuleInfo]`
    pub info: Option<ModuleInfo>,
    /// `[MxComments]`
    pub comments: Option<Comments>,
    /// `[MxFixedObjects]`: objects that are there once if any such module is connected.
    pub fixed_objects: Option<List<u16>>,
    /// `[MxFixedxxxx]` and `[MxFixedxxxxsubN]`, sorted by index.
    pub fixed: Vec<Object>,
    /// `[MxSubExtends]`: objects that get further sub-objects by each such module.
    pub sub_extends: Option<List<u16>>,
    /// `[MxSubExtxxxx]`, sorted by index.
    pub extensions: Vec<SubExtension>,
}

/// `[MxModuleInfo]`
#[derive(Clone, Debug, Default)]
pub struct ModuleInfo {
    /// The section's header.
    pub header: Span,
    /// ProductName
    pub product_name: Option<Spanned<String>>,
    /// ProductVersion
    pub product_version: Option<Spanned<u8>>,
    /// ProductRevision
    pub product_revision: Option<Spanned<u8>>,
    /// OrderCode
    pub order_code: Option<Spanned<String>>,
}

/// `[MxSubExt6000]`: sub-objects that each module adds to an object.
#[derive(Clone, Debug, Default)]
pub struct SubExtension {
    /// The object's index.
    pub index: u16,
    /// What each of the sub-objects is.
    pub description: Description,
    /// Count: how many.
    pub count: Option<Spanned<Count>>,
    /// ObjExtend: the last sub-index that is used before the next index is; 0: the next index is not used.
    pub obj_extend: Option<Spanned<u8>>,
}

/// How much a module adds to an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// `2`: sub-objects of its own.
    Subs(u8),
    /// `0;4`: bits, which share sub-objects with those of other modules.
    Bits(u8),
}

impl Module {
    pub(super) fn new(number: u16) -> Self {
        Self {
            number,
            ..Self::default()
        }
    }

    /// Reads one more section of the module. Those of an object come together, its own first.
    pub(super) fn read(&mut self, fields: &mut Fields<'_>, section: &Section, part: ModulePart) {
        match part {
            ModulePart::ModuleInfo => self.info = Some(read_info(fields, section)),
            ModulePart::Comments => self.comments = Some(comments::read(fields, section)),
            ModulePart::FixedObjects => {
                self.fixed_objects = Some(list::read_numbers(fields, section, Keyword::NrOfEntries));
            }
            ModulePart::FixedObject(index) => {
                self.fixed_object(index).description = Some(read_description(fields, section, None));
            }
            ModulePart::FixedSub(index, sub) => {
                let object = self.fixed_object(index);
                let description = read_description(fields, section, object.sub_type(sub));
                object.subs.push(Sub { sub, description });
            }
            ModulePart::SubExtends => {
                self.sub_extends = Some(list::read_numbers(fields, section, Keyword::NrOfEntries));
            }
            ModulePart::SubExtension(index) => self.extensions.push(read_extension(fields, section, index)),
        }
    }

    /// The last object, if it is the one with `index`, else a new one: the sections come sorted.
    fn fixed_object(&mut self, index: u16) -> &mut Object {
        object::last_or_new(&mut self.fixed, index)
    }
}

fn read_info(fields: &mut Fields<'_>, section: &Section) -> ModuleInfo {
    let mut info = ModuleInfo {
        header: section.header,
        ..ModuleInfo::default()
    };
    for entry in &section.entries {
        match entry.keyword {
            Keyword::ProductName => first(&mut info.product_name, fields.text(entry)),
            Keyword::ProductVersion => first(&mut info.product_version, fields.number(entry)),
            Keyword::ProductRevision => first(&mut info.product_revision, fields.number(entry)),
            Keyword::OrderCode => first(&mut info.order_code, fields.text(entry)),
            _ => fields.misplaced(entry),
        }
    }
    info
}

fn read_extension(fields: &mut Fields<'_>, section: &Section, index: u16) -> SubExtension {
    let (mut count, mut obj_extend) = (None, None);
    let other = |fields: &mut Fields<'_>, entry: &Entry| match entry.keyword {
        Keyword::Count => first(&mut count, fields.read(entry, Expected::Count, read_count)),
        Keyword::ObjExtend => first(&mut obj_extend, fields.number(entry)),
        _ => fields.misplaced(entry),
    };
    let description = description::read(fields, section, None, other);
    SubExtension {
        index,
        description,
        count,
        obj_extend,
    }
}

fn read_count(text: &str) -> Result<Literal<Count>, Fault> {
    let Some((subs, bits)) = text.split_once(';') else {
        return byte(text).map(Count::Subs).map(Literal::plain);
    };
    match (byte(subs.trim_end())?, byte(bits.trim_start())?) {
        (0, bits) => Ok(Literal::plain(Count::Bits(bits))),
        _ => Err(Fault::OutOfRange),
    }
}

fn byte(text: &str) -> Result<u8, Fault> {
    let value = unsigned(text, 0xFF)?.value;
    u8::try_from(value).map_err(|_| Fault::OutOfRange)
}
