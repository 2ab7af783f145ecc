//! Goes over a document's sections, each to the one that reads it.

use super::field::Fields;
use super::{
    Eds, Module, comments, device_commissioning, device_info, dynamic_channels, file_info, list, object, type_usage,
};
use crate::document::{Document, Keyword, ModulePart, Section, SectionName};

pub(super) fn eds(document: &Document) -> Eds {
    let mut fields = Fields {
        document,
        problems: Vec::new(),
    };
    let mut eds = Eds::default();
    for section in first_of_each_name(document) {
        match section.name {
            SectionName::Object(index)
            | SectionName::Sub(index, _)
            | SectionName::Name(index)
            | SectionName::Value(index)
            | SectionName::Denotation(index)
            | SectionName::ObjectLinks(index) => {
                object::last_or_new(&mut eds.objects, index).read(&mut fields, section);
            }
            SectionName::Module(number, part) => module(&mut eds.modules, number).read(&mut fields, section, part),
            _ => eds.read(&mut fields, section),
        }
    }
    eds.problems = fields.problems;
    eds
}

/// The sections that count, sorted so that those of one object stand together, in the order of [`SectionName`].
fn first_of_each_name(document: &Document) -> Vec<&Section> {
    let mut sections: Vec<&Section> = document.sections().iter().collect();
    sections.sort_by_key(|section| (group(section.name), section.name));
    sections.dedup_by_key(|section| section.name);
    sections
}

/// Index of the object; number of the module and index of the module's object.
const fn group(name: SectionName) -> (u16, u16, u16) {
    match name {
        SectionName::Object(index)
        | SectionName::Sub(index, _)
        | SectionName::Name(index)
        | SectionName::Value(index)
        | SectionName::Denotation(index)
        | SectionName::ObjectLinks(index) => (index, 0, 0),
        SectionName::Module(number, ModulePart::FixedObject(index) | ModulePart::FixedSub(index, _)) => {
            (0, number, index)
        }
        SectionName::Module(number, _) => (0, number, 0),
        _ => (0, 0, 0),
    }
}

/// The last module, if it is the one with `number`, else a new one.
fn module(modules: &mut Vec<Module>, number: u16) -> &mut Module {
    if modules.last().is_none_or(|last| last.number != number) {
        modules.push(Module::new(number));
    }
    let last = modules.len() - 1;
    &mut modules[last]
}

impl Eds {
    /// Reads a section that is neither an object's nor a module's.
    fn read(&mut self, fields: &mut Fields<'_>, section: &Section) {
        match section.name {
            SectionName::FileInfo => self.file_info = Some(file_info::read(fields, section)),
            SectionName::DeviceInfo => self.device_info = Some(device_info::read(fields, section)),
            SectionName::DeviceCommissioning => {
                self.commissioning = Some(device_commissioning::read(fields, section));
            }
            SectionName::DummyUsage => self.dummy_usage = Some(type_usage::read(fields, section)),
            SectionName::StandardDataTypes => self.standard_data_types = Some(type_usage::read(fields, section)),
            SectionName::Comments => self.comments = Some(comments::read(fields, section)),
            SectionName::DynamicChannels => self.dynamic_channels = Some(dynamic_channels::read(fields, section)),
            SectionName::Tools => self.tools.get_or_insert_default().read(fields, section),
            SectionName::Tool(number) => self.tools.get_or_insert_default().read_tool(fields, section, number),
            _ => self.read_list(fields, section),
        }
    }

    fn read_list(&mut self, fields: &mut Fields<'_>, section: &Section) {
        let (list, count) = match section.name {
            SectionName::MandatoryObjects => (&mut self.mandatory, Keyword::SupportedObjects),
            SectionName::OptionalObjects => (&mut self.optional, Keyword::SupportedObjects),
            SectionName::ManufacturerObjects => (&mut self.manufacturer, Keyword::SupportedObjects),
            SectionName::SupportedModules => (&mut self.supported_modules, Keyword::NrOfEntries),
            SectionName::ConnectedModules => (&mut self.connected_modules, Keyword::NrOfEntries),
            _ => return,
        };
        *list = Some(list::read_numbers(fields, section, count));
    }
}
