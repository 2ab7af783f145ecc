//! Whatever an EDS says, the dictionary is sorted, whole, and of the types that it names.

use lexican_eds::Reading;
use lexican_eds::ir::{DataType, Entry, Object, ObjectCode, Value};
use lexican_eds::span::Span;
use proptest::prelude::*;
use proptest::sample::select;

const SECTIONS: &[&str] = &[
    "FileInfo",
    "DeviceInfo",
    "DeviceComissioning",
    "DummyUsage",
    "MandatoryObjects",
    "OptionalObjects",
    "ManufacturerObjects",
    "DynamicChannels",
    "SupportedModules",
    "ConnectedModules",
    "M1ModuleInfo",
    "M1FixedObjects",
    "M1Fixed2000",
    "M1Fixed2000sub1",
    "M1SubExtends",
    "M1SubExt2000",
    "M2SubExt2001",
    "0000",
    "1400",
    "2000",
    "2000sub0",
    "2000sub1",
    "2000subFF",
    "2000Name",
    "2000Value",
    "2000Denotation",
    "2000ObjectLinks",
    "2001",
    "2001sub2",
    "FFFF",
    "FFFFsub0",
];

const KEYWORDS: &[&str] = &[
    "ParameterName",
    "ObjectType",
    "DataType",
    "AccessType",
    "DefaultValue",
    "ParameterValue",
    "LowLimit",
    "HighLimit",
    "PDOMapping",
    "ObjFlags",
    "SubNumber",
    "CompactSubObj",
    "Denotation",
    "Count",
    "ObjExtend",
    "NrOfEntries",
    "SupportedObjects",
    "NrOfRXPDO",
    "NrOfTXPDO",
    "CompactPDO",
    "Granularity",
    "NodeID",
    "Type1",
    "Range1",
    "Dummy0005",
    "BaudRate_500",
    "0",
    "1",
    "2",
    "255",
    "4294967295",
];

const VALUES: &[&str] = &[
    "",
    "0",
    "1",
    "2",
    "7",
    "8",
    "9",
    "255",
    "65535",
    "-1",
    "-0x80",
    "0x7F",
    "0x80",
    "0x80000000",
    "0xFFFFFFFFFFFFFFFF",
    "010",
    "09",
    "1.5",
    "0x3F800000",
    "1e400",
    "NaN",
    "$NODEID+0x180",
    "0xFFFFFFFF + $NodeID",
    "ro",
    "RW # rw",
    "const",
    "\"text\"",
    "ünïcödé",
    "00 ff",
    "365 43200000",
    "0x2000",
    "0x2000-0x2001",
    "0;3",
];

proptest! {
    #[test]
    fn a_dictionary_is_sorted_and_whole(text in eds()) {
        let reading = lexican_eds::read("any.eds", text.clone().into_bytes());
        let objects = &reading.dictionary.objects;
        prop_assert!(objects.is_sorted_by(|one, next| one.index < next.index), "{text}");
        for object in objects {
            prop_assert!(is_whole(object), "{object:?}\n{text}");
        }
    }

    #[test]
    fn each_value_is_of_the_type_that_its_entry_names(text in eds()) {
        let reading = lexican_eds::read("any.eds", text.clone().into_bytes());
        for entry in reading.dictionary.entries() {
            for value in [&entry.default, &entry.low, &entry.high].into_iter().flatten() {
                prop_assert!(is_of_type(value, entry.data_type), "{entry:?}\n{text}");
            }
        }
    }

    #[test]
    fn each_span_is_a_place_in_the_file(text in eds()) {
        let reading = lexican_eds::read("any.eds", text.clone().into_bytes());
        let of_entries = reading.dictionary.entries().flat_map(spans);
        let of_model = reading.eds.problems().iter().map(lexican_eds::model::Problem::span);
        let of_dictionary = reading.problems.iter().map(lexican_eds::ir::Problem::span);
        for span in of_entries.chain(of_model).chain(of_dictionary) {
            prop_assert!(is_place(&reading, span), "{span:?}\n{text}");
        }
    }
}

/// Sections and keywords that make sense together often enough.
fn eds() -> impl Strategy<Value = String> {
    let entry = (select(KEYWORDS), select(VALUES)).prop_map(|(key, value)| format!("{key}={value}\n"));
    let section = (select(SECTIONS), prop::collection::vec(entry, 0..8));
    let section = section.prop_map(|(name, entries)| format!("[{name}]\n{}", entries.concat()));
    prop::collection::vec(section, 0..24).prop_map(|sections| sections.concat())
}

/// Sorted, each value once and at its own object, and sub-index 0 where there are sub-indices.
fn is_whole(object: &Object) -> bool {
    let entries = &object.entries;
    let sorted = entries.is_sorted_by(|one, next| one.address.sub < next.address.sub);
    let own = entries.iter().all(|entry| entry.address.index == object.index);
    let first = entries.first().is_none_or(|entry| entry.address.sub == 0);
    let single = matches!(object.code, ObjectCode::Var | ObjectCode::Domain | ObjectCode::DefType);
    sorted && own && first && (!single || entries.len() == 1)
}

fn is_of_type(value: &Value, data_type: DataType) -> bool {
    let kind = match value {
        Value::Boolean(_) => data_type == DataType::Boolean,
        Value::Integer(_) => data_type.is_signed(),
        Value::Unsigned(_) => data_type.is_unsigned(),
        Value::NodeIdPlus(_) => data_type.is_signed() || data_type.is_unsigned(),
        Value::Real32(_) => data_type == DataType::Real32,
        Value::Real64(_) => data_type == DataType::Real64,
        Value::Text(_) => matches!(data_type, DataType::VisibleString | DataType::UnicodeString),
        Value::Bytes(_) => matches!(data_type, DataType::OctetString | DataType::Domain),
        Value::Time { .. } => matches!(data_type, DataType::TimeOfDay | DataType::TimeDifference),
    };
    let length = data_type.bytes();
    kind && length.is_none_or(|length| value.to_bytes(data_type, None).len() == length)
}

fn spans(entry: &Entry) -> [Span; 8] {
    let spans = entry.spans;
    [
        spans.section,
        spans.name,
        spans.data_type,
        spans.access,
        spans.pdo_mapping,
        spans.default,
        spans.low,
        spans.high,
    ]
}

/// Within the text, on one line, and not the place that nothing has.
fn is_place(reading: &Reading, span: Span) -> bool {
    let text = reading.document.source().text();
    let place = text.get(span.start as usize..span.end as usize);
    place.is_some_and(|place| !place.contains('\n')) && span.end > 0
}
