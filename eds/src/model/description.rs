//! The keywords that describe an object or a sub-object (CiA 306-1, 4.5.3 and 5.2).

use super::field::{Fields, first};
use crate::document::{Entry, Keyword, Section};
use crate::ir::{AccessType, DataType, ObjectCode, Value};
use crate::span::{Span, Spanned};

/// What a section says of an object, a sub-object, or an object of a module.
#[derive(Clone, Debug, Default)]
pub struct Description {
    /// The section's header.
    pub header: Span,
    /// ParameterName
    pub parameter_name: Option<Spanned<String>>,
    /// ObjectType
    pub object_type: Option<Spanned<ObjectCode>>,
    /// DataType: the type's index, whether CiA 301 defines it or not.
    pub data_type: Option<Spanned<u16>>,
    /// AccessType
    pub access_type: Option<Spanned<AccessType>>,
    /// DefaultValue
    pub default_value: Option<Spanned<Value>>,
    /// LowLimit
    pub low_limit: Option<Spanned<Value>>,
    /// HighLimit
    pub high_limit: Option<Spanned<Value>>,
    /// PDOMapping
    pub pdo_mapping: Option<Spanned<bool>>,
    /// ObjFlags
    pub obj_flags: Option<Spanned<u32>>,
    /// SubNumber: how many sub-objects have a section.
    pub sub_number: Option<Spanned<u16>>,
    /// CompactSubObj: how many sub-objects have none.
    pub compact_sub_obj: Option<Spanned<u16>>,
    /// What few descriptions have.
    pub configuration: Option<Box<Configuration>>,
    value_type: Option<u16>,
    mentioned: u8,
}

/// What few descriptions have: what a DCF adds (CiA 306-1, 5.2), references to other documents, CANopen Safety.
#[derive(Clone, Debug, Default)]
pub struct Configuration {
    /// ParameterValue
    pub parameter_value: Option<Spanned<Value>>,
    /// Denotation
    pub denotation: Option<Spanned<String>>,
    /// UploadFile
    pub upload_file: Option<Spanned<String>>,
    /// DownloadFile
    pub download_file: Option<Spanned<String>>,
    /// ParaRefd, ParamRefd: the parameter's reference designator.
    pub para_refd: Option<Spanned<String>>,
    /// UniqueIDRef
    pub unique_id_ref: Option<Spanned<String>>,
    /// SRDOMapping: whether it may be mapped into an SRDO (EN 50325-5).
    pub srdo_mapping: Option<Spanned<bool>>,
    /// InvertedSRAD: the object that holds the inverted value, `0x610101`.
    pub inverted_srad: Option<Spanned<u32>>,
}

impl Description {
    /// Whether the section has `keyword`, readable or not: ParameterName, ObjectType, DataType, AccessType or PDOMapping.
    #[must_use]
    pub const fn mentions(&self, keyword: Keyword) -> bool {
        self.mentioned & bit(keyword) != 0
    }

    /// The index of the type that the section's values are of: DataType; without it DOMAIN for a DOMAIN, UNSIGNED8 for
    /// sub-index 0 (CiA 301, 7.4.3), the object's type for another sub-index.
    #[must_use]
    pub const fn value_type(&self) -> Option<u16> {
        self.value_type
    }

    /// ParameterValue of a DCF.
    #[must_use]
    pub fn parameter_value(&self) -> Option<&Spanned<Value>> {
        self.configuration.as_ref()?.parameter_value.as_ref()
    }
}

const fn bit(keyword: Keyword) -> u8 {
    match keyword {
        Keyword::ParameterName => 1,
        Keyword::ObjectType => 2,
        Keyword::DataType => 4,
        Keyword::AccessType => 8,
        Keyword::PdoMapping => 16,
        _ => 0,
    }
}

/// The entries whose meaning depends on the data type, which may stand below them.
#[derive(Default)]
struct Typed<'s> {
    default_value: Option<&'s Entry>,
    parameter_value: Option<&'s Entry>,
    low_limit: Option<&'s Entry>,
    high_limit: Option<&'s Entry>,
}

/// Reads a section. `fallback` is the type of its values when it has no DataType.
///
/// Keywords that only some descriptions have are handed to `other`.
pub(super) fn read<'d>(
    fields: &mut Fields<'d>,
    section: &Section,
    fallback: Option<u16>,
    mut other: impl FnMut(&mut Fields<'d>, &Entry),
) -> Description {
    let mut description = Description {
        header: section.header,
        ..Description::default()
    };
    let mut typed = Typed::default();
    for entry in &section.entries {
        description.mentioned |= bit(entry.keyword);
        match entry.keyword {
            Keyword::DefaultValue => first(&mut typed.default_value, Some(entry)),
            Keyword::ParameterValue => first(&mut typed.parameter_value, Some(entry)),
            Keyword::LowLimit => first(&mut typed.low_limit, Some(entry)),
            Keyword::HighLimit => first(&mut typed.high_limit, Some(entry)),
            Keyword::ParameterName => first(&mut description.parameter_name, fields.text(entry)),
            Keyword::ObjectType => first(&mut description.object_type, fields.object_code(entry)),
            Keyword::DataType => first(&mut description.data_type, fields.data_type(entry)),
            Keyword::AccessType => first(&mut description.access_type, fields.access(entry)),
            Keyword::PdoMapping => first(&mut description.pdo_mapping, fields.flag(entry)),
            Keyword::ObjFlags => first(&mut description.obj_flags, fields.number(entry)),
            Keyword::SubNumber => first(&mut description.sub_number, fields.number(entry)),
            Keyword::CompactSubObj => first(&mut description.compact_sub_obj, fields.number(entry)),
            keyword if is_configuration(keyword) => description.configure(fields, entry),
            _ => other(fields, entry),
        }
    }
    description.read_values(fields, &typed, fallback);
    description
}

const fn is_configuration(keyword: Keyword) -> bool {
    matches!(
        keyword,
        Keyword::Denotation
            | Keyword::UploadFile
            | Keyword::DownloadFile
            | Keyword::ParaRefd
            | Keyword::ParamRefd
            | Keyword::UniqueIdRef
            | Keyword::SrdoMapping
            | Keyword::InvertedSrad
    )
}

impl Description {
    fn configure(&mut self, fields: &mut Fields<'_>, entry: &Entry) {
        let configuration = self.configuration.get_or_insert_default();
        let text = match entry.keyword {
            Keyword::Denotation => &mut configuration.denotation,
            Keyword::UploadFile => &mut configuration.upload_file,
            Keyword::DownloadFile => &mut configuration.download_file,
            Keyword::ParaRefd | Keyword::ParamRefd => &mut configuration.para_refd,
            Keyword::SrdoMapping => return first(&mut configuration.srdo_mapping, fields.flag(entry)),
            Keyword::InvertedSrad => return first(&mut configuration.inverted_srad, fields.number(entry)),
            _ => &mut configuration.unique_id_ref,
        };
        first(text, fields.text(entry));
    }

    fn read_values(&mut self, fields: &mut Fields<'_>, typed: &Typed<'_>, fallback: Option<u16>) {
        self.value_type = self.stated_type().or(fallback);
        let data_type = self.value_type;
        self.default_value = typed.default_value.and_then(|entry| fields.value(entry, data_type));
        self.low_limit = typed.low_limit.and_then(|entry| fields.limit(entry, data_type));
        self.high_limit = typed.high_limit.and_then(|entry| fields.limit(entry, data_type));
        let parameter_value = typed.parameter_value.and_then(|entry| fields.value(entry, data_type));
        if parameter_value.is_some() {
            self.configuration.get_or_insert_default().parameter_value = parameter_value;
        }
    }

    /// DataType; an object that is a DOMAIN may leave it out (CiA 306-1, table 7).
    fn stated_type(&self) -> Option<u16> {
        let is_domain = self.object_type.is_some_and(|code| code.value == ObjectCode::Domain);
        let domain = is_domain.then(|| DataType::Domain.index());
        self.data_type.map(|data_type| data_type.value).or(domain)
    }
}
