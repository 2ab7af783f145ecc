//! The names of sections (CiA 306-1, 4.4 to 4.7 and 5).

/// What a section is about.
///
/// Parsed without regard to case. [`Document::text`](super::Document::text) of a section's label has the spelling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SectionName {
    /// `[FileInfo]`
    FileInfo,
    /// `[DeviceInfo]`
    DeviceInfo,
    /// `[DeviceComissioning]`, the standard's spelling, or `[DeviceCommissioning]`, English spelling.
    DeviceCommissioning,
    /// `[DummyUsage]`
    DummyUsage,
    /// `[Comments]`
    Comments,
    /// `[StandardDataTypes]`, of EDS version 1 and 2.
    StandardDataTypes,
    /// `[MandatoryObjects]`
    MandatoryObjects,
    /// `[OptionalObjects]`
    OptionalObjects,
    /// `[ManufacturerObjects]`
    ManufacturerObjects,
    /// `[1018]`: an object.
    Object(u16),
    /// `[1018sub4]`: a sub-object.
    Sub(u16, u8),
    /// `[1003Name]`: names of the sub-objects of a compact form.
    Name(u16),
    /// `[1003Value]`: values of the sub-objects of a compact form.
    Value(u16),
    /// `[1003Denotation]`: denotations of the sub-objects of a compact form; DCF.
    Denotation(u16),
    /// `[2000ObjectLinks]`
    ObjectLinks(u16),
    /// `[DynamicChannels]`
    DynamicChannels,
    /// `[SupportedModules]`
    SupportedModules,
    /// `[ConnectedModules]`; DCF.
    ConnectedModules,
    /// `[M1ModuleInfo]`, `[M1FixedObjects]` …: a part of the description of module 1.
    Module(u16, ModulePart),
    /// `[Tools]`
    Tools,
    /// `[Tool1]`
    Tool(u16),
    /// Anything else.
    Unknown,
}

/// A part of a module's description (CiA 306-1, 4.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ModulePart {
    /// `[MxModuleInfo]`
    ModuleInfo,
    /// `[MxComments]`
    Comments,
    /// `[MxFixedObjects]`
    FixedObjects,
    /// `[MxFixed1000]`
    FixedObject(u16),
    /// `[MxFixed1000sub1]`
    FixedSub(u16, u8),
    /// `[MxSubExtends]`
    SubExtends,
    /// `[MxSubExt6000]`
    SubExtension(u16),
}

impl SectionName {
    /// The section that `label`, the text between the brackets, names, in any case.
    ///
    /// Blanks, `0x` and leading zeros, which the standard does not allow, are seen through; [`SectionName::is_spelled`]
    /// tells.
    #[must_use]
    pub fn parse(label: &str) -> Self {
        let label = label.trim();
        object(label)
            .or_else(|| named(label))
            .or_else(|| numbered(label))
            .unwrap_or(Self::Unknown)
    }

    /// The standard's names of the sections that a file has once.
    pub fn names() -> impl Iterator<Item = &'static str> {
        let standard = NAMED.iter().filter(|(_, text)| *text != "DeviceCommissioning");
        standard.map(|(_, text)| *text)
    }

    /// The standard's name of a section that a file has once.
    pub(super) fn name(self) -> Option<&'static str> {
        let found = NAMED.iter().find(|(name, _)| *name == self);
        found.map(|(_, text)| *text)
    }

    /// Whether `label`, which names this section, is written as the standard allows, apart from the case of letters: no
    /// blank, no `0x`, no leading zero in a sub-index.
    #[must_use]
    pub fn is_spelled(self, label: &str) -> bool {
        // All that `parse` sees through makes a label longer.
        let length = match self {
            Self::Unknown => return false,
            Self::Object(_) => 4,
            Self::Sub(_, sub) => "1018sub".len() + hex_digits(sub),
            Self::Name(_) => "1018Name".len(),
            Self::Value(_) => "1018Value".len(),
            Self::Denotation(_) => "1018Denotation".len(),
            Self::ObjectLinks(_) => "1018ObjectLinks".len(),
            Self::Tool(number) => "Tool".len() + decimal_digits(number),
            Self::Module(number, part) => "M".len() + decimal_digits(number) + part.length(),
            _ => return label.trim().len() == label.len(),
        };
        label.len() == length
    }
}

impl ModulePart {
    /// How long its name is, without the module's number.
    fn length(self) -> usize {
        match self {
            Self::ModuleInfo => "ModuleInfo".len(),
            Self::Comments => "Comments".len(),
            Self::FixedObjects => "FixedObjects".len(),
            Self::FixedObject(_) => "Fixed6000".len(),
            Self::FixedSub(_, sub) => "Fixed6000sub".len() + hex_digits(sub),
            Self::SubExtends => "SubExtends".len(),
            Self::SubExtension(_) => "SubExt6000".len(),
        }
    }
}

const fn hex_digits(sub: u8) -> usize {
    if sub < 0x10 { 1 } else { 2 }
}

fn decimal_digits(number: u16) -> usize {
    number.checked_ilog10().map_or(1, |log| log as usize + 1)
}

/// The sections that have one name. Later entries are other spellings.
const NAMED: [(SectionName, &str); 14] = [
    (SectionName::FileInfo, "FileInfo"),
    (SectionName::DeviceInfo, "DeviceInfo"),
    (SectionName::DummyUsage, "DummyUsage"),
    (SectionName::Comments, "Comments"),
    (SectionName::MandatoryObjects, "MandatoryObjects"),
    (SectionName::OptionalObjects, "OptionalObjects"),
    (SectionName::ManufacturerObjects, "ManufacturerObjects"),
    (SectionName::DeviceCommissioning, "DeviceComissioning"),
    (SectionName::DeviceCommissioning, "DeviceCommissioning"),
    (SectionName::StandardDataTypes, "StandardDataTypes"),
    (SectionName::DynamicChannels, "DynamicChannels"),
    (SectionName::SupportedModules, "SupportedModules"),
    (SectionName::ConnectedModules, "ConnectedModules"),
    (SectionName::Tools, "Tools"),
];

fn named(label: &str) -> Option<SectionName> {
    let found = NAMED.iter().find(|(_, text)| text.eq_ignore_ascii_case(label));
    found.map(|(name, _)| *name)
}

/// `1018`, `1018sub4`, `1003Value` …
fn object(label: &str) -> Option<SectionName> {
    let (index, rest) = index(label)?;
    let rest = rest.trim_start();
    if rest.is_empty() {
        return Some(SectionName::Object(index));
    }
    if let Some(sub) = after(rest, "sub") {
        return sub_index(sub).map(|sub| SectionName::Sub(index, sub));
    }
    let parts = [
        ("Name", SectionName::Name(index)),
        ("Value", SectionName::Value(index)),
        ("Denotation", SectionName::Denotation(index)),
        ("ObjectLinks", SectionName::ObjectLinks(index)),
    ];
    let found = parts.iter().find(|(text, _)| text.eq_ignore_ascii_case(rest));
    found.map(|(_, name)| *name)
}

/// `Tool1`, `M1ModuleInfo` …
fn numbered(label: &str) -> Option<SectionName> {
    if let Some(number) = after(label, "Tool") {
        return decimal(number)
            .filter(|(_, rest)| rest.is_empty())
            .map(|(number, _)| SectionName::Tool(number));
    }
    let (number, part) = decimal(after(label, "M")?)?;
    module_part(part).map(|part| SectionName::Module(number, part))
}

fn module_part(part: &str) -> Option<ModulePart> {
    let whole = [
        ("ModuleInfo", ModulePart::ModuleInfo),
        ("Comments", ModulePart::Comments),
        ("FixedObjects", ModulePart::FixedObjects),
        ("SubExtends", ModulePart::SubExtends),
    ];
    if let Some((_, found)) = whole.iter().find(|(name, _)| name.eq_ignore_ascii_case(part)) {
        return Some(*found);
    }
    if let Some(object_of_module) = after(part, "Fixed") {
        return match object(object_of_module)? {
            SectionName::Object(index) => Some(ModulePart::FixedObject(index)),
            SectionName::Sub(index, sub) => Some(ModulePart::FixedSub(index, sub)),
            _ => None,
        };
    }
    match object(after(part, "SubExt")?)? {
        SectionName::Object(index) => Some(ModulePart::SubExtension(index)),
        _ => None,
    }
}

/// Four hexadecimal digits, or any number of them after `0x`; and what follows.
fn index(label: &str) -> Option<(u16, &str)> {
    if let Some(digits) = after(label, "0x") {
        let length = digits.bytes().take_while(u8::is_ascii_hexdigit).count();
        let (digits, rest) = digits.split_at_checked(length)?;
        return Some((u16::from_str_radix(digits, 16).ok()?, rest));
    }
    let (digits, rest) = label.split_at_checked(4)?;
    let all_hex = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    all_hex.then(|| u16::from_str_radix(digits, 16).ok().map(|index| (index, rest)))?
}

/// The hexadecimal digits of a sub-index, to the end.
fn sub_index(text: &str) -> Option<u8> {
    let text = text.trim_start();
    let digits = after(text, "0x").unwrap_or(text);
    let all_hex = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    all_hex.then(|| u8::from_str_radix(digits, 16).ok())?
}

/// A decimal number and what follows.
fn decimal(text: &str) -> Option<(u16, &str)> {
    let length = text.bytes().take_while(u8::is_ascii_digit).count();
    let (digits, rest) = text.split_at_checked(length)?;
    Some((digits.parse().ok()?, rest))
}

/// What follows `word`, which may be in any case.
fn after<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    let (start, rest) = text.split_at_checked(word.len())?;
    start.eq_ignore_ascii_case(word).then_some(rest)
}

#[cfg(test)]
mod tests {
    use super::ModulePart;
    use super::SectionName::{self, *};

    #[test]
    fn every_section_of_the_standard_is_known_in_any_case() {
        for (label, name) in [
            ("FileInfo", FileInfo),
            ("DEVICEINFO", DeviceInfo),
            ("Optionalobjects", OptionalObjects),
            ("DeviceComissioning", DeviceCommissioning),
            ("DeviceCommissioning", DeviceCommissioning),
            ("1018", Object(0x1018)),
            ("1a00", Object(0x1A00)),
            ("1A00Sub0", Sub(0x1A00, 0)),
            ("1003subFE", Sub(0x1003, 0xFE)),
            ("1003subfe", Sub(0x1003, 0xFE)),
            ("1003Name", Name(0x1003)),
            ("1003VALUE", Value(0x1003)),
            ("2100Denotation", Denotation(0x2100)),
            ("2000ObjectLinks", ObjectLinks(0x2000)),
            ("Tools", Tools),
            ("Tool12", Tool(12)),
            ("DynamicChannels", DynamicChannels),
            ("SupportedModules", SupportedModules),
            ("ConnectedModules", ConnectedModules),
            ("M1ModuleInfo", Module(1, ModulePart::ModuleInfo)),
            ("M10Comments", Module(10, ModulePart::Comments)),
            ("M2FixedObjects", Module(2, ModulePart::FixedObjects)),
            ("M2Fixed6000", Module(2, ModulePart::FixedObject(0x6000))),
            ("M2Fixed6000sub1A", Module(2, ModulePart::FixedSub(0x6000, 0x1A))),
            ("M2SubExtends", Module(2, ModulePart::SubExtends)),
            ("M2SubExt6000", Module(2, ModulePart::SubExtension(0x6000))),
        ] {
            assert_eq!(SectionName::parse(label), name, "{label}");
            assert!(name.is_spelled(label), "{label}");
        }
    }

    #[test]
    fn careless_spellings_are_understood_and_told() {
        for (label, name) in [
            ("0x1018", Object(0x1018)),
            ("0X1018sub1", Sub(0x1018, 1)),
            ("1018sub01", Sub(0x1018, 1)),
            ("1018sub0x1", Sub(0x1018, 1)),
            ("1018 sub 1", Sub(0x1018, 1)),
            (" 1018", Object(0x1018)),
            ("1018 Name", Name(0x1018)),
            ("M01ModuleInfo", Module(1, ModulePart::ModuleInfo)),
            ("Tool01", Tool(1)),
            ("FileInfo ", FileInfo),
        ] {
            assert_eq!(SectionName::parse(label), name, "{label}");
            assert!(!name.is_spelled(label), "{label}");
        }
    }

    #[test]
    fn what_only_resembles_a_section_is_unknown() {
        for label in [
            "",
            "ADC",
            "10188",
            "1018sub",
            "1018sub100",
            "1018subG",
            "1018sub+1",
            "+101",
            "1018Names",
            "Tool",
            "ToolInfos",
            "Tool65536",
            "M",
            "MModuleInfo",
            "M1",
            "M1Fixed",
            "M1Fixed6000Name",
            "Motor",
            "0x",
            "0x10000",
            "é018",
            "101é",
            "PreDefines",
        ] {
            assert_eq!(SectionName::parse(label), Unknown, "{label}");
        }
    }
}
