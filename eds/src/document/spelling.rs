//! Sections and keywords as the standard writes them, and in the order in which it has them.

use super::{Keyword, ModulePart, SectionName};
use crate::ir::ObjectList;

impl SectionName {
    /// As the standard writes it: `1018sub4`; `None` for a section that it does not know.
    #[must_use]
    pub fn spelling(self) -> Option<String> {
        Some(match self {
            Self::Unknown => return None,
            Self::Object(index) => format!("{index:04X}"),
            Self::Sub(index, sub) => format!("{index:04X}sub{sub:X}"),
            Self::Name(index) => format!("{index:04X}Name"),
            Self::Value(index) => format!("{index:04X}Value"),
            Self::Denotation(index) => format!("{index:04X}Denotation"),
            Self::ObjectLinks(index) => format!("{index:04X}ObjectLinks"),
            Self::Tool(number) => format!("Tool{number}"),
            Self::Module(number, part) => format!("M{number}{}", part.spelling()),
            _ => self.name()?.to_owned(),
        })
    }

    /// What sections are sorted by: the facts about file and device, each list of objects before its objects, each object
    /// before its sub-objects, modules, tools. A section that the standard does not know comes last.
    pub(crate) fn order(self, list_of: impl Fn(u16) -> ObjectList) -> SectionOrder {
        const LISTS: u8 = 10;
        let place = |list: ObjectList| LISTS + 2 * list as u8;
        let object = |index, part| (place(list_of(index)) + 1, index, part);
        match self {
            Self::FileInfo => (0, 0, 0),
            Self::DeviceInfo => (1, 0, 0),
            Self::DeviceCommissioning => (2, 0, 0),
            Self::DummyUsage => (3, 0, 0),
            Self::StandardDataTypes => (4, 0, 0),
            Self::Comments => (5, 0, 0),
            Self::MandatoryObjects => (place(ObjectList::Mandatory), 0, 0),
            Self::OptionalObjects => (place(ObjectList::Optional), 0, 0),
            Self::ManufacturerObjects => (place(ObjectList::Manufacturer), 0, 0),
            Self::Object(index) => object(index, 0),
            Self::Name(index) => object(index, 1),
            Self::Value(index) => object(index, 2),
            Self::Denotation(index) => object(index, 3),
            Self::ObjectLinks(index) => object(index, 4),
            Self::Sub(index, sub) => object(index, 5 + u32::from(sub)),
            Self::DynamicChannels => (30, 0, 0),
            Self::SupportedModules => (31, 0, 0),
            Self::ConnectedModules => (32, 0, 0),
            Self::Module(number, part) => (33, number, part.order()),
            Self::Tools => (34, 0, 0),
            Self::Tool(number) => (35, number, 0),
            Self::Unknown => (36, 0, 0),
        }
    }
}

/// The group of sections, the index or number within it, the part of that.
pub(crate) type SectionOrder = (u8, u16, u32);

impl ModulePart {
    fn spelling(self) -> String {
        match self {
            Self::ModuleInfo => "ModuleInfo".to_owned(),
            Self::Comments => "Comments".to_owned(),
            Self::FixedObjects => "FixedObjects".to_owned(),
            Self::FixedObject(index) => format!("Fixed{index:04X}"),
            Self::FixedSub(index, sub) => format!("Fixed{index:04X}sub{sub:X}"),
            Self::SubExtends => "SubExtends".to_owned(),
            Self::SubExtension(index) => format!("SubExt{index:04X}"),
        }
    }

    /// The group, then the index and sub-index.
    fn order(self) -> u32 {
        let place = |group: u32, index: u16, sub: u32| (group << 28) | (u32::from(index) << 9) | sub;
        match self {
            Self::ModuleInfo => place(0, 0, 0),
            Self::Comments => place(1, 0, 0),
            Self::FixedObjects => place(2, 0, 0),
            Self::FixedObject(index) => place(3, index, 0),
            Self::FixedSub(index, sub) => place(3, index, 1 + u32::from(sub)),
            Self::SubExtends => place(4, 0, 0),
            Self::SubExtension(index) => place(5, index, 0),
        }
    }
}

impl Keyword {
    /// As the standard writes it, with its number: `NrOfRXPDO`, `BaudRate_500`; `None` for a keyword that it does not know.
    #[must_use]
    pub fn spelling(self) -> Option<String> {
        let name = self.name();
        Some(match self {
            Self::Unknown => return None,
            Self::DataTypeIndex(index) => format!("0x{index:04X}"),
            Self::Dummy(index) => format!("{name}{index:04X}"),
            Self::BaudRate(number) => format!("{name}{number}"),
            Self::Number(number)
            | Self::Line(number)
            | Self::Type(number)
            | Self::Dir(number)
            | Self::Range(number)
            | Self::PpOffset(number)
            | Self::MaxCnt(number) => format!("{name}{number}"),
            _ => name.to_owned(),
        })
    }

    /// What keywords of a section are sorted by. [`Keyword`] itself stands in the order of the standard's tables; here a
    /// count stands before what it counts, limits before the value between them.
    pub(crate) fn order(self) -> (u8, Self) {
        let group = match self {
            Self::ParameterName => 0,
            Self::Denotation | Self::ParaRefd | Self::ParamRefd => 1,
            Self::ObjectType => 2,
            Self::SubNumber | Self::CompactSubObj => 3,
            Self::DataType => 4,
            Self::AccessType => 5,
            Self::LowLimit | Self::HighLimit => 6,
            Self::DefaultValue => 7,
            Self::ParameterValue => 8,
            Self::PdoMapping => 9,
            Self::BaudRate(_) => 10,
            Self::Unknown => 13,
            // Of `[DeviceInfo]` all that follows the bit rates in the standard.
            other if other >= Self::SimpleBootUpMaster && other < Self::NodeId => 12,
            _ => 9,
        };
        (group, self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_spelled_reads_back_as_the_standard_writes_it() {
        for label in [
            "DeviceComissioning",
            "FileInfo",
            "1018",
            "1A00sub1B",
            "1003Value",
            "M2Fixed6000sub1A",
            "Tool12",
        ] {
            let name = SectionName::parse(label);
            assert_eq!(name.spelling().as_deref(), Some(label));
            assert!(name.is_spelled(label));
        }
        for key in [
            "NrOfRXPDO",
            "12",
            "Line3",
            "Dummy001B",
            "BaudRate_500",
            "0x001B",
            "PPOffset4",
        ] {
            let keyword = Keyword::parse(key);
            assert_eq!(keyword.spelling().as_deref(), Some(key));
            assert!(keyword.is_spelled(key));
        }
        assert_eq!(SectionName::Unknown.spelling(), None);
        assert_eq!(Keyword::Unknown.spelling(), None);
    }

    #[test]
    fn a_list_stands_before_its_objects_and_an_object_before_its_sub_objects() {
        let labels = [
            "FileInfo",
            "DeviceInfo",
            "DummyUsage",
            "Comments",
            "MandatoryObjects",
            "1000",
            "1018",
            "1018sub0",
            "OptionalObjects",
            "1003",
            "1003Name",
            "1003sub1",
            "1017",
            "M1ModuleInfo",
            "M1Fixed6000",
            "M1Fixed6000sub1",
            "M1SubExtends",
            "M1SubExt6000",
            "M2ModuleInfo",
            "Tools",
            "Tool1",
            "Vendor",
        ];
        let order = |label: &&str| {
            SectionName::parse(label).order(|index| match index {
                0x1000 | 0x1018 => ObjectList::Mandatory,
                _ => ObjectList::Optional,
            })
        };
        assert!(labels.is_sorted_by_key(order));
    }
}
