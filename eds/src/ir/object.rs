//! An object and its values.

use super::{Address, DataType, Value};
use crate::span::Span;

/// What kind of object an index holds (CiA 301, table 42). The EDS keyword is ObjectType.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ObjectCode {
    /// 0: an object without data.
    Null,
    /// 2: a large variable amount of data, such as a program.
    Domain,
    /// 5: a type definition.
    DefType,
    /// 6: a definition of a record type.
    DefStruct,
    /// 7: a single value.
    Var,
    /// 8: values of one type.
    Array,
    /// 9: values of any types.
    Record,
}

impl ObjectCode {
    /// The object code with the standard's number; `None` for a number that CiA 301 does not define.
    #[must_use]
    pub const fn from_number(number: u8) -> Option<Self> {
        Some(match number {
            0 => Self::Null,
            2 => Self::Domain,
            5 => Self::DefType,
            6 => Self::DefStruct,
            7 => Self::Var,
            8 => Self::Array,
            9 => Self::Record,
            _ => return None,
        })
    }

    /// The object code with the standard's name, in any case: `VAR`.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let all = [
            Self::Null,
            Self::Domain,
            Self::DefType,
            Self::DefStruct,
            Self::Var,
            Self::Array,
            Self::Record,
        ];
        all.into_iter().find(|code| code.name().eq_ignore_ascii_case(name))
    }

    /// The standard's name: `VAR`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Null => "NULL",
            Self::Domain => "DOMAIN",
            Self::DefType => "DEFTYPE",
            Self::DefStruct => "DEFSTRUCT",
            Self::Var => "VAR",
            Self::Array => "ARRAY",
            Self::Record => "RECORD",
        }
    }

    /// The standard's number.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::Null => 0,
            Self::Domain => 2,
            Self::DefType => 5,
            Self::DefStruct => 6,
            Self::Var => 7,
            Self::Array => 8,
            Self::Record => 9,
        }
    }
}

/// What a client may do with a value (CiA 306-1, table for AccessType).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AccessType {
    /// Read only, never changes.
    Const,
    /// Read only.
    Ro,
    /// Write only.
    Wo,
    /// Read and write.
    Rw,
    /// Read and write; in a PDO it is read (TPDO).
    Rwr,
    /// Read and write; in a PDO it is written (RPDO).
    Rww,
}

impl AccessType {
    /// Whether a client may read it.
    #[must_use]
    pub const fn readable(self) -> bool {
        !matches!(self, Self::Wo)
    }

    /// Whether a client may write it.
    #[must_use]
    pub const fn writable(self) -> bool {
        matches!(self, Self::Wo | Self::Rw | Self::Rwr | Self::Rww)
    }

    /// As an EDS writes it: `rwr`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Const => "const",
            Self::Ro => "ro",
            Self::Wo => "wo",
            Self::Rw => "rw",
            Self::Rwr => "rwr",
            Self::Rww => "rww",
        }
    }
}

/// The list that names an object (CiA 306-1, 4.5.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ObjectList {
    /// `[MandatoryObjects]`
    Mandatory,
    /// `[OptionalObjects]`
    Optional,
    /// `[ManufacturerObjects]`
    Manufacturer,
}

/// An object: one index of the dictionary.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// The index, `0x0001..=0xFFFF`.
    pub index: u16,
    /// ParameterName; may be empty.
    pub name: String,
    /// The kind of object.
    pub code: ObjectCode,
    /// The list that names it; `None` when none does.
    pub list: Option<ObjectList>,
    /// The values, sorted by sub-index; one with sub-index 0 for [`ObjectCode::Var`] and [`ObjectCode::Domain`].
    pub entries: Vec<Entry>,
    /// The objects linked by `[xxxxObjectLinks]`.
    pub links: Vec<u16>,
    /// Where the object's section starts: its header.
    pub span: Span,
}

impl Object {
    /// The value at `sub`.
    #[must_use]
    pub fn entry(&self, sub: u8) -> Option<&Entry> {
        let at = self
            .entries
            .binary_search_by_key(&sub, |entry| entry.address.sub)
            .ok()?;
        self.entries.get(at)
    }
}

/// A value: one index and sub-index.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Index and sub-index.
    pub address: Address,
    /// ParameterName; may be empty.
    pub name: String,
    /// The data type.
    pub data_type: DataType,
    /// What a client may do.
    pub access: AccessType,
    /// PDOMapping: whether it may be mapped into a PDO.
    pub pdo_mapping: bool,
    /// The value after power-on: a DCF's ParameterValue, else DefaultValue; `None` when the file gives none.
    pub default: Option<Value>,
    /// Whether [`Entry::default`] is a DCF's ParameterValue.
    pub configured: bool,
    /// LowLimit.
    pub low: Option<Value>,
    /// HighLimit.
    pub high: Option<Value>,
    /// ObjFlags bit 0: a scan shall not write it.
    pub refuse_write_on_download: bool,
    /// ObjFlags bit 1: a scan shall not read it.
    pub refuse_read_on_scan: bool,
    /// Denotation of a DCF.
    pub denotation: Option<String>,
    /// UploadFile of a DCF: where a tool puts what it reads.
    pub upload_file: Option<String>,
    /// DownloadFile of a DCF: what a tool writes.
    pub download_file: Option<String>,
    /// Where all that was read.
    pub spans: EntrySpans,
}

/// Where an entry's facts stand; a fact that the file does not give points at the section's header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(missing_docs, reason = "named as the fields of Entry")]
pub struct EntrySpans {
    /// The section's header, or the line of a compact form.
    pub section: Span,
    pub name: Span,
    pub data_type: Span,
    pub access: Span,
    pub pdo_mapping: Span,
    pub default: Span,
    pub low: Span,
    pub high: Span,
}

impl EntrySpans {
    /// All facts of an entry that no section describes, at the place that it follows from.
    pub(crate) const fn all_at(at: Span) -> Self {
        Self {
            section: at,
            name: at,
            data_type: at,
            access: at,
            pdo_mapping: at,
            default: at,
            low: at,
            high: at,
        }
    }
}
