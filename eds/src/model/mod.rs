//! What the file says, keyword by keyword.
//!
//! Every value is read by the kind that CiA 306-1 gives its keyword, and keeps its place ([`Spanned`]). A keyword that
//! the file does not have is `None`; so is one whose value cannot be read, and then [`Eds::problems`] says why. No default
//! is applied, nothing is put together: that is for [lowering](crate::ir::lower).
//!
//! Where a section or a keyword stands twice the first one counts, as in the INI functions of Windows that the format was
//! made for; the document's problems name the second.

mod comments;
mod description;
mod device_commissioning;
mod device_info;
mod dynamic_channels;
mod field;
mod file_info;
mod interpret;
mod list;
mod module;
mod object;
mod problem;
mod tools;
mod type_usage;

pub use comments::Comments;
pub use description::{Configuration, Description};
pub use device_commissioning::DeviceCommissioning;
pub use device_info::{BaudRate, DeviceInfo};
pub use dynamic_channels::{DynamicChannels, PpOffset, Segment};
pub use file_info::FileInfo;
pub use list::{Item, List};
pub use module::{Count, Module, ModuleInfo, SubExtension};
pub use object::{Object, Sub};
pub use problem::{Expected, Problem};
pub use tools::{Tool, Tools};
pub use type_usage::{TypeUsage, UsedType};

use crate::document::Document;

#[cfg(doc)]
use crate::span::Spanned;

/// An EDS or a DCF.
#[derive(Clone, Debug, Default)]
pub struct Eds {
    /// `[FileInfo]`
    pub file_info: Option<FileInfo>,
    /// `[DeviceInfo]`
    pub device_info: Option<DeviceInfo>,
    /// `[DeviceComissioning]` in either spelling; DCF.
    pub commissioning: Option<DeviceCommissioning>,
    /// `[DummyUsage]`
    pub dummy_usage: Option<TypeUsage>,
    /// `[StandardDataTypes]`, of EDS versions before 4.
    pub standard_data_types: Option<TypeUsage>,
    /// `[Comments]`
    pub comments: Option<Comments>,
    /// `[MandatoryObjects]`
    pub mandatory: Option<List<u16>>,
    /// `[OptionalObjects]`
    pub optional: Option<List<u16>>,
    /// `[ManufacturerObjects]`
    pub manufacturer: Option<List<u16>>,
    /// The objects with all their sections, sorted by index.
    pub objects: Vec<Object>,
    /// `[DynamicChannels]`
    pub dynamic_channels: Option<DynamicChannels>,
    /// `[SupportedModules]`
    pub supported_modules: Option<List<u16>>,
    /// `[ConnectedModules]`: which module is in which place; DCF.
    pub connected_modules: Option<List<u16>>,
    /// The modules described by `[MxModuleInfo]` and so on, sorted by number.
    pub modules: Vec<Module>,
    /// `[Tools]` and `[Toolx]`
    pub tools: Option<Tools>,
    problems: Vec<Problem>,
}

impl Eds {
    /// Reads what a document's sections and keywords say.
    #[must_use]
    pub fn interpret(document: &Document) -> Self {
        interpret::eds(document)
    }

    /// What could not be read, and what is written in an unusual way, in the order of reading.
    #[must_use]
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// The object at `index`.
    #[must_use]
    pub fn object(&self, index: u16) -> Option<&Object> {
        let at = self.objects.binary_search_by_key(&index, |object| object.index).ok()?;
        self.objects.get(at)
    }

    /// Whether the file is a DCF: it says how a device is configured.
    #[must_use]
    pub fn is_dcf(&self) -> bool {
        self.commissioning.is_some()
    }
}
