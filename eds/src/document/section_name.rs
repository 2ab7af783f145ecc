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

    /// Whether `label` is written as the standard allows, apart from the case of letters: no blank, no `0x`, no leading
    /// zero in a sub-index.
    #[must_use]
    pub fn is_spelled(self, label: &str) -> bool {
        let canonical = match self {
            Self::Unknown => return false,
            Self::Object(index) => format!("{index:04x}"),
            Self::Sub(index, sub) => format!("{index:04x}sub{sub:x}"),
            Self::Name(index) => format!("{index:04x}Name"),
            Self::Value(index) => format!("{index:04x}Value"),
            Self::Denotation(index) => format!("{index:04x}Denotation"),
            Self::ObjectLinks(index) => format!("{index:04x}ObjectLinks"),
            Self::Tool(number) => format!("Tool{number}"),
            Self::Module(number, part) => format!("M{number}{}", part.suffix()),
            Self::DeviceCommissioning => return label.len() == label.trim().len(),
            _ => {
                return NAMED
                    .iter()
                    .any(|(name, text)| *name == self && text.eq_ignore_ascii_case(label));
            }
        };
        canonical.eq_ignore_ascii_case(label)
    }
}

impl ModulePart {
    fn suffix(self) -> String {
        match self {
            Self::ModuleInfo => "ModuleInfo".into(),
            Self::Comments => "Comments".into(),
            Self::FixedObjects => "FixedObjects".into(),
            Self::FixedObject(index) => format!("Fixed{index:04x}"),
            Self::FixedSub(index, sub) => format!("Fixed{index:04x}sub{sub:x}"),
            Self::SubExtends => "SubExtends".into(),
            Self::SubExtension(index) => format!("SubExt{index:04x}"),
        }
    }
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
        ModulePart::ModuleInfo,
        ModulePart::Comments,
        ModulePart::FixedObjects,
        ModulePart::SubExtends,
    ];
    if let Some(found) = whole
        .into_iter()
        .find(|whole| whole.suffix().eq_ignore_ascii_case(part))
    {
        return Some(found);
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
