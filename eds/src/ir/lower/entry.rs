//! One value.

use super::{Lowering, Problem};
use crate::document::Keyword;
use crate::ir::{AccessType, Address, DataType, Entry, EntrySpans, ObjectCode, Value};
use crate::model::{Configuration, Description};
use crate::span::{Span, Spanned};

/// Lowers the description of one value; `object` is that of its object, when that is another one.
pub(super) fn lower(
    address: Address,
    description: &Description,
    object: Option<&Description>,
    lowering: &mut Lowering,
) -> Entry {
    require_name(address, description, lowering);
    let data_type = data_type(address, description, lowering);
    let access = access(address, description, object, lowering);
    let configuration = description.configuration.as_deref();
    let configured = description.parameter_value();
    let default = configured.or(description.default_value.as_ref());
    let flags = description.obj_flags.map_or(0, |flags| flags.value);
    Entry {
        address,
        name: text(description.parameter_name.as_ref()),
        data_type: data_type.value,
        access: access.value,
        pdo_mapping: description.pdo_mapping.is_some_and(|mappable| mappable.value),
        default: value(default),
        configured: configured.is_some(),
        low: value(description.low_limit.as_ref()),
        high: value(description.high_limit.as_ref()),
        refuse_write_on_download: flags & 1 != 0,
        refuse_read_on_scan: flags & 2 != 0,
        denotation: configured_text(configuration, |configuration| &configuration.denotation),
        upload_file: configured_text(configuration, |configuration| &configuration.upload_file),
        download_file: configured_text(configuration, |configuration| &configuration.download_file),
        spans: EntrySpans {
            section: description.header,
            name: span(description.parameter_name.as_ref(), description.header),
            data_type: data_type.span,
            access: access.span,
            pdo_mapping: span(description.pdo_mapping.as_ref(), description.header),
            default: span(default, description.header),
            low: span(description.low_limit.as_ref(), description.header),
            high: span(description.high_limit.as_ref(), description.header),
        },
    }
}

/// A value that no section describes, such as a sub-index 0 that the file leaves out.
pub(super) fn made_up(address: Address, name: String, data_type: DataType, access: AccessType, at: Span) -> Entry {
    Entry {
        address,
        name,
        data_type,
        access,
        pdo_mapping: false,
        default: None,
        configured: false,
        low: None,
        high: None,
        refuse_write_on_download: false,
        refuse_read_on_scan: false,
        denotation: None,
        upload_file: None,
        download_file: None,
        spans: EntrySpans::all_at(at),
    }
}

/// Sub-index 0 of an ARRAY or RECORD that the file leaves out.
pub(super) fn sub_zero(index: u16, highest: u8, at: Span) -> Entry {
    let address = Address::new(index, 0);
    let mut entry = made_up(
        address,
        "NrOfObjects".to_owned(),
        DataType::Unsigned8,
        AccessType::Ro,
        at,
    );
    entry.default = Some(Value::Unsigned(highest.into()));
    entry
}

pub(super) fn text(text: Option<&Spanned<String>>) -> String {
    text.map(|text| text.value.clone()).unwrap_or_default()
}

fn value(value: Option<&Spanned<Value>>) -> Option<Value> {
    value.map(|value| value.value.clone())
}

fn configured_text(
    configuration: Option<&Configuration>,
    field: impl Fn(&Configuration) -> &Option<Spanned<String>>,
) -> Option<String> {
    let text = configuration.and_then(|configuration| field(configuration).as_ref())?;
    Some(text.value.clone()).filter(|text| !text.is_empty())
}

fn span<T>(value: Option<&Spanned<T>>, header: Span) -> Span {
    value.map_or(header, |value| value.span)
}

fn require_name(address: Address, description: &Description, lowering: &mut Lowering) {
    if !description.mentions(Keyword::ParameterName) {
        lowering.report(missing(Keyword::ParameterName, address, description));
    }
}

fn missing(keyword: Keyword, address: Address, description: &Description) -> Problem {
    Problem::MissingKeyword {
        keyword,
        address,
        at: description.header,
    }
}

fn is_domain(description: &Description) -> bool {
    description
        .object_type
        .is_some_and(|code| code.value == ObjectCode::Domain)
}

fn data_type(address: Address, description: &Description, lowering: &mut Lowering) -> Spanned<DataType> {
    if !is_domain(description) && !description.mentions(Keyword::DataType) {
        lowering.report(missing(Keyword::DataType, address, description));
    }
    let at = span(description.data_type.as_ref(), description.header);
    let Some(data_type) = description.value_type() else {
        return Spanned::new(DataType::Domain, at);
    };
    let known = DataType::from_index(data_type).unwrap_or_else(|| {
        lowering.report(Problem::UnknownDataType { address, data_type, at });
        DataType::Domain
    });
    Spanned::new(known, at)
}

fn access(
    address: Address,
    description: &Description,
    object: Option<&Description>,
    lowering: &mut Lowering,
) -> Spanned<AccessType> {
    let optional = is_domain(description);
    if !optional && !description.mentions(Keyword::AccessType) {
        lowering.report(missing(Keyword::AccessType, address, description));
    }
    let of_object = || object.filter(|_| address.sub != 0)?.access_type;
    let assumed = if optional { AccessType::Rw } else { AccessType::Ro };
    let read = description.access_type.or_else(of_object);
    read.unwrap_or(Spanned::new(assumed, description.header))
}
