//! What the device is, when the file says this and that.

use lexican_eds::document::Keyword;
use lexican_eds::ir::{
    AccessType, Address, DataType, Dictionary, Direction, Entry, NodeId, ObjectCode, ObjectList, Problem, Value,
};

fn lower(text: &str) -> (Dictionary, Vec<Problem>) {
    let reading = lexican_eds::read("test.eds", text.into());
    assert!(reading.eds.problems().is_empty(), "{:?}", reading.eds.problems());
    (reading.dictionary, reading.problems)
}

/// Lowers a file that no list names the objects of; those problems are left out.
fn lower_unlisted(text: &str) -> (Dictionary, Vec<Problem>) {
    let (dictionary, mut problems) = lower(text);
    problems.retain(|problem| !matches!(problem, Problem::UnlistedObject { .. }));
    (dictionary, problems)
}

fn entry(dictionary: &Dictionary, index: u16, sub: u8) -> &Entry {
    let address = Address::new(index, sub);
    let Some(entry) = dictionary.entry(address) else {
        panic!("no {address}")
    };
    entry
}

fn unsigned(dictionary: &Dictionary, index: u16, sub: u8) -> Option<u64> {
    match entry(dictionary, index, sub).default {
        Some(Value::Unsigned(value)) => Some(value),
        _ => None,
    }
}

fn subs(dictionary: &Dictionary, index: u16) -> Vec<u8> {
    let Some(object) = dictionary.object(index) else {
        panic!("no {index:04X}h")
    };
    object.entries.iter().map(|entry| entry.address.sub).collect()
}

const VALUE: &str = "ParameterName=v\nDataType=0x0005\nAccessType=rw\n";

#[test]
fn an_object_has_what_its_section_says() {
    let (dictionary, problems) = lower_unlisted(
        "[6003]\nParameterName=Preset\nObjectType=0x7\nDataType=0x0007\nAccessType=rww\nDefaultValue=5\nLowLimit=1\n\
         HighLimit=9\nPDOMapping=1\nObjFlags=2\nDenotation=Left\nUploadFile=u\nDownloadFile=d\n",
    );
    assert!(problems.is_empty(), "{problems:?}");
    let object = dictionary.object(0x6003).unwrap();
    assert_eq!((object.name.as_str(), object.code), ("Preset", ObjectCode::Var));
    let entry = entry(&dictionary, 0x6003, 0);
    assert_eq!(
        (entry.data_type, entry.access, entry.pdo_mapping),
        (DataType::Unsigned32, AccessType::Rww, true)
    );
    let limits = (entry.low.clone(), entry.default.clone(), entry.high.clone());
    assert_eq!(
        limits,
        (
            Some(Value::Unsigned(1)),
            Some(Value::Unsigned(5)),
            Some(Value::Unsigned(9))
        )
    );
    assert!(!entry.refuse_write_on_download && entry.refuse_read_on_scan && !entry.configured);
    assert_eq!(entry.denotation.as_deref(), Some("Left"));
    assert_eq!(
        (entry.upload_file.as_deref(), entry.download_file.as_deref()),
        (Some("u"), Some("d"))
    );
}

#[test]
fn objects_and_sub_objects_come_sorted_whatever_their_order_in_the_file() {
    let text = format!("[6000]\n{VALUE}[1018sub1]\n{VALUE}[1018sub0]\n{VALUE}[1018]\nParameterName=i\nObjectType=9\n");
    let (dictionary, problems) = lower_unlisted(&text);
    assert!(problems.is_empty(), "{problems:?}");
    let indices = dictionary.objects.iter().map(|object| object.index);
    assert_eq!(indices.collect::<Vec<_>>(), [0x1018, 0x6000]);
    assert_eq!(subs(&dictionary, 0x1018), [0, 1]);
}

#[test]
fn what_a_var_leaves_out_gets_the_defaults_of_the_standard() {
    let (dictionary, problems) = lower_unlisted("[2000]\nDataType=0x0005\n");
    let object = dictionary.object(0x2000).unwrap();
    assert_eq!((object.code, object.name.as_str()), (ObjectCode::Var, ""));
    let value = entry(&dictionary, 0x2000, 0);
    assert_eq!(
        (value.access, value.pdo_mapping, value.default.as_ref()),
        (AccessType::Ro, false, None)
    );
    let missing = problems.iter().map(|problem| match problem {
        Problem::MissingKeyword { keyword, address, .. } => (*keyword, address.index),
        other => panic!("{other:?}"),
    });
    let expected = [(Keyword::ParameterName, 0x2000), (Keyword::AccessType, 0x2000)];
    assert_eq!(missing.collect::<Vec<_>>(), expected);
}

#[test]
fn a_value_without_data_type_is_a_domain_and_told() {
    let (dictionary, problems) = lower_unlisted("[2000]\nParameterName=v\nAccessType=ro\n");
    assert_eq!(entry(&dictionary, 0x2000, 0).data_type, DataType::Domain);
    assert!(matches!(
        problems.as_slice(),
        [Problem::MissingKeyword {
            keyword: Keyword::DataType,
            ..
        }]
    ));
}

#[test]
fn a_domain_needs_neither_data_type_nor_access() {
    let (dictionary, problems) = lower_unlisted("[1F50]\nParameterName=Program\nObjectType=2\n");
    let value = entry(&dictionary, 0x1F50, 0);
    assert_eq!((value.data_type, value.access), (DataType::Domain, AccessType::Rw));
    assert!(problems.is_empty(), "{problems:?}");
}

#[test]
fn an_unreadable_keyword_is_not_told_again_as_missing() {
    let reading = lexican_eds::read("t.eds", b"[2000]\nParameterName=v\nDataType=?\nAccessType=?\n".to_vec());
    assert_eq!(reading.eds.problems().len(), 2);
    assert!(matches!(reading.problems.as_slice(), [Problem::UnlistedObject { .. }]));
}

#[test]
fn a_data_type_that_nobody_knows_is_a_domain_and_told() {
    let (dictionary, problems) = lower_unlisted("[2000]\nParameterName=v\nDataType=0x0040\nAccessType=ro\n");
    assert_eq!(entry(&dictionary, 0x2000, 0).data_type, DataType::Domain);
    assert!(matches!(
        problems.as_slice(),
        [Problem::UnknownDataType { data_type: 0x40, .. }]
    ));
}

#[test]
fn sub_objects_take_type_and_access_of_their_array_and_sub_index_0_is_unsigned8() {
    let (dictionary, problems) = lower_unlisted(
        "[2000]\nParameterName=a\nObjectType=8\nDataType=0x0006\nAccessType=rw\nSubNumber=2\n\
         [2000sub0]\nParameterName=n\nDefaultValue=1\n[2000sub1]\nParameterName=v\nDefaultValue=300\n",
    );
    let (first, second) = (entry(&dictionary, 0x2000, 0), entry(&dictionary, 0x2000, 1));
    assert_eq!((first.data_type, first.access), (DataType::Unsigned8, AccessType::Ro));
    assert_eq!(
        (second.data_type, second.access),
        (DataType::Unsigned16, AccessType::Rw)
    );
    assert_eq!(unsigned(&dictionary, 0x2000, 1), Some(300));
    assert_eq!(problems.len(), 4, "DataType and AccessType of both: {problems:?}");
}

#[test]
fn sub_index_0_is_made_up_where_it_is_missing() {
    let text = format!("[2000]\nParameterName=a\nObjectType=9\n[2000sub1]\n{VALUE}[2000sub5]\n{VALUE}");
    let (dictionary, problems) = lower_unlisted(&text);
    assert_eq!(subs(&dictionary, 0x2000), [0, 1, 5]);
    assert_eq!(unsigned(&dictionary, 0x2000, 0), Some(5));
    assert!(matches!(
        problems.as_slice(),
        [Problem::MissingSubZero {
            index: 0x2000,
            highest: 5,
            ..
        }]
    ));
}

#[test]
fn an_array_without_sub_objects_stays_empty_and_is_told() {
    let (dictionary, problems) = lower_unlisted("[2000]\nParameterName=a\nObjectType=8\nSubNumber=3\n");
    assert!(subs(&dictionary, 0x2000).is_empty());
    assert!(matches!(problems.as_slice(), [Problem::NoSubs { index: 0x2000, .. }]));
}

#[test]
fn an_object_with_sub_objects_and_no_object_type_is_a_record() {
    let text = format!("[2000]\nParameterName=a\n[2000sub0]\n{VALUE}");
    let (dictionary, problems) = lower_unlisted(&text);
    assert_eq!(dictionary.object(0x2000).unwrap().code, ObjectCode::Record);
    assert!(matches!(
        problems.as_slice(),
        [Problem::AssumedObjectCode {
            assumed: ObjectCode::Record,
            ..
        }]
    ));
}

#[test]
fn a_var_without_type_but_with_sub_objects_is_a_record() {
    let text = format!("[2000]\nParameterName=a\nObjectType=7\n[2000sub0]\n{VALUE}");
    let (dictionary, problems) = lower_unlisted(&text);
    assert_eq!(subs(&dictionary, 0x2000), [0]);
    assert!(matches!(
        problems.as_slice(),
        [Problem::AssumedObjectCode {
            assumed: ObjectCode::Record,
            ..
        }]
    ));
}

#[test]
fn sub_objects_of_a_var_with_a_type_are_left_out_and_told() {
    let text = format!("[2000]\nObjectType=7\n{VALUE}[2000sub0]\n{VALUE}[2000sub1]\n{VALUE}");
    let (dictionary, problems) = lower_unlisted(&text);
    assert_eq!(subs(&dictionary, 0x2000), [0]);
    assert!(matches!(
        problems.as_slice(),
        [Problem::SubsOfSingleValue {
            code: ObjectCode::Var,
            ..
        }]
    ));
}

#[test]
fn sub_objects_without_an_object_are_kept_as_a_record_and_told() {
    let (dictionary, problems) = lower_unlisted(&format!("[2000sub0]\n{VALUE}[2000sub1]\n{VALUE}"));
    assert_eq!(dictionary.object(0x2000).unwrap().code, ObjectCode::Record);
    assert_eq!(subs(&dictionary, 0x2000), [0, 1]);
    assert!(matches!(
        problems.as_slice(),
        [Problem::OrphanedSubs { index: 0x2000, .. }]
    ));
}

#[test]
fn lists_without_an_object_make_none_and_are_told() {
    let (dictionary, problems) = lower_unlisted("[2000Name]\nNrOfEntries=1\n1=x\n");
    assert!(dictionary.objects.is_empty());
    assert!(matches!(
        problems.as_slice(),
        [Problem::OrphanedSubs { index: 0x2000, .. }]
    ));
}

#[test]
fn an_object_knows_its_list_and_the_lists_are_held_against_the_sections() {
    let text = format!(
        "[MandatoryObjects]\nSupportedObjects=2\n1=0x1000\n2=0x1001\n[OptionalObjects]\nSupportedObjects=1\n1=0x1000\n\
         [ManufacturerObjects]\nSupportedObjects=1\n1=0x2000\n[1000]\n{VALUE}[2000]\n{VALUE}[2001]\n{VALUE}"
    );
    let (dictionary, problems) = lower(&text);
    let lists = dictionary.objects.iter().map(|object| (object.index, object.list));
    let expected = [
        (0x1000, Some(ObjectList::Mandatory)),
        (0x2000, Some(ObjectList::Manufacturer)),
        (0x2001, None),
    ];
    assert_eq!(lists.collect::<Vec<_>>(), expected);
    assert!(matches!(
        problems.as_slice(),
        [
            Problem::ListedTwice { index: 0x1000, .. },
            Problem::AbsentObject {
                index: 0x1001,
                list: ObjectList::Mandatory,
                ..
            },
            Problem::UnlistedObject { index: 0x2001, .. },
        ]
    ));
}

#[test]
fn the_compact_form_is_expanded_with_names_values_and_denotations() {
    let (dictionary, problems) = lower_unlisted(
        "[1003]\nParameterName=Error\nObjectType=8\nCompactSubObj=3\nDataType=0x0007\nAccessType=ro\nDefaultValue=1\n\
         LowLimit=0\nHighLimit=9\nPDOMapping=1\n[1003Name]\nNrOfEntries=1\n2=Second\n[1003Value]\nNrOfEntries=1\n3=7\n\
         [1003Denotation]\nNrOfEntries=1\n1=D\n",
    );
    assert!(problems.is_empty(), "{problems:?}");
    assert_eq!(subs(&dictionary, 0x1003), [0, 1, 2, 3]);
    let zero = entry(&dictionary, 0x1003, 0);
    assert_eq!(
        (zero.data_type, zero.access, zero.pdo_mapping),
        (DataType::Unsigned8, AccessType::Ro, false)
    );
    let values = [0, 1, 2, 3].map(|sub| unsigned(&dictionary, 0x1003, sub));
    assert_eq!(values, [Some(3), Some(1), Some(1), Some(7)]);
    let names = dictionary
        .object(0x1003)
        .unwrap()
        .entries
        .iter()
        .map(|entry| entry.name.as_str());
    assert_eq!(names.collect::<Vec<_>>(), ["NrOfObjects", "Error1", "Second", "Error3"]);
    let second = entry(&dictionary, 0x1003, 2);
    assert_eq!(
        (second.data_type, second.pdo_mapping, second.configured),
        (DataType::Unsigned32, true, false)
    );
    assert_eq!(
        (&second.low, &second.high),
        (&Some(Value::Unsigned(0)), &Some(Value::Unsigned(9)))
    );
    assert!(entry(&dictionary, 0x1003, 3).configured);
    assert_eq!(entry(&dictionary, 0x1003, 1).denotation.as_deref(), Some("D"));
}

#[test]
fn a_section_of_a_sub_object_comes_before_the_compact_form() {
    let (dictionary, problems) = lower_unlisted(
        "[2000]\nParameterName=a\nObjectType=8\nCompactSubObj=2\nDataType=5\nAccessType=ro\n\
         [2000sub1]\nParameterName=own\nDataType=6\nAccessType=rw\nDefaultValue=300\nParameterValue=301\n\
         [2000Name]\n1=other\n[2000Value]\n1=7\n2=8\n",
    );
    assert!(problems.is_empty(), "{problems:?}");
    let own = entry(&dictionary, 0x2000, 1);
    assert_eq!(
        (own.name.as_str(), own.data_type, own.access),
        ("own", DataType::Unsigned16, AccessType::Rw)
    );
    assert_eq!(
        (unsigned(&dictionary, 0x2000, 1), unsigned(&dictionary, 0x2000, 2)),
        (Some(301), Some(8))
    );
}

#[test]
fn a_compact_form_ends_at_254_and_a_line_for_no_sub_object_is_passed_over() {
    let (dictionary, problems) = lower_unlisted(
        "[2000]\nParameterName=a\nObjectType=8\nCompactSubObj=255\nDataType=5\nAccessType=ro\n[2000Name]\n300=x\n",
    );
    assert_eq!(dictionary.object(0x2000).unwrap().entries.len(), 255);
    assert_eq!(unsigned(&dictionary, 0x2000, 0), Some(254));
    assert!(matches!(
        problems.as_slice(),
        [Problem::TooManySubs { .. }, Problem::LineOfNoSub { number: 300, .. }]
    ));
}

#[test]
fn what_a_compact_form_lacks_is_told_once() {
    let (_, problems) = lower_unlisted("[2000]\nParameterName=a\nObjectType=8\nCompactSubObj=100\nDataType=5\n");
    assert!(matches!(
        problems.as_slice(),
        [Problem::MissingKeyword {
            keyword: Keyword::AccessType,
            ..
        }]
    ));
}

#[test]
fn a_dcf_value_stands_in_place_of_the_default() {
    let text = "[2000]\nParameterName=v\nDataType=5\nAccessType=rw\nDefaultValue=1\nParameterValue=2\n\
                [2001]\nParameterName=v\nDataType=5\nAccessType=rw\nDefaultValue=1\nParameterValue=\n";
    let (dictionary, _) = lower(text);
    assert_eq!(
        (
            unsigned(&dictionary, 0x2000, 0),
            entry(&dictionary, 0x2000, 0).configured
        ),
        (Some(2), true)
    );
    assert_eq!(
        (
            unsigned(&dictionary, 0x2001, 0),
            entry(&dictionary, 0x2001, 0).configured
        ),
        (Some(1), false)
    );
    let at = entry(&dictionary, 0x2000, 0).spans.default;
    assert_eq!(&text[at.start as usize..at.end as usize], "2");
}

#[test]
fn a_missing_fact_points_at_the_section() {
    let text = "[2000]\nParameterName=v\nDataType=5\nAccessType=rw\n";
    let (dictionary, _) = lower(text);
    let spans = entry(&dictionary, 0x2000, 0).spans;
    assert_eq!(spans.low, spans.section);
    assert_eq!(
        &text[spans.section.start as usize..spans.section.end as usize],
        "[2000]"
    );
}

#[test]
fn device_file_and_commissioning_are_carried_over() {
    let (dictionary, _) = lower(
        "[FileInfo]\nFileName=a.eds\nFileVersion=3\n[DeviceInfo]\nVendorName=V\nVendorNumber=1\nBaudRate_500=1\n\
         BaudRate_10=1\nBaudRate_20=0\nNrOfRXPDO=4\nLSS_Supported=1\n[DummyUsage]\nDummy0005=1\nDummy0003=1\nDummy0007=0\n\
         [DeviceComissioning]\nNodeID=5\nBaudrate=250\n[2000]\nParameterName=v\nDataType=5\n\
         AccessType=ro\n[2000ObjectLinks]\nObjectLinks=1\n1=0x1000\n",
    );
    assert_eq!(
        (dictionary.file.file_name.as_str(), dictionary.file.file_version),
        ("a.eds", 3)
    );
    assert_eq!(dictionary.file.eds_version, "3.0");
    assert_eq!(dictionary.device.vendor_number, Some(1));
    assert_eq!(dictionary.device.baud_rates.0, [10, 500]);
    assert_eq!(
        (dictionary.device.nr_of_rx_pdo, dictionary.device.nr_of_tx_pdo),
        (Some(4), None)
    );
    assert!(dictionary.device.lss_supported && !dictionary.device.group_messaging);
    assert_eq!(dictionary.dummies, [DataType::Integer16, DataType::Unsigned8]);
    let commissioning = dictionary.commissioning.as_ref().unwrap();
    assert_eq!(
        (commissioning.node_id, commissioning.baud_rate),
        (NodeId::new(5), Some(250))
    );
    assert_eq!(dictionary.object(0x2000).unwrap().links, [0x1000]);
}

#[test]
fn a_node_id_outside_1_to_127_is_none() {
    for node_id in ["0", "128", "255"] {
        let (dictionary, _) = lower(&format!("[DeviceComissioning]\nNodeID={node_id}\n"));
        assert_eq!(dictionary.commissioning.unwrap().node_id, None);
    }
}

#[test]
fn pdos_are_read_from_communication_and_mapping_with_the_node_id_left_open() {
    let text = "[1800]\nParameterName=c\nObjectType=9\n[1800sub0]\nParameterName=n\nDataType=5\nAccessType=ro\nDefaultValue=1\n\
         [1800sub1]\nParameterName=i\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n[1A00]\nParameterName=m\n\
         ObjectType=9\n[1A00sub0]\nParameterName=n\nDataType=5\nAccessType=rw\nDefaultValue=1\n[1A00sub1]\nParameterName=e\n\
         DataType=7\nAccessType=rw\nDefaultValue=0x60040020\n[1A01]\nParameterName=m\nObjectType=9\n[1A01sub0]\nParameterName=n\n\
         DataType=5\nAccessType=rw\n";
    let (dictionary, _) = lower(text);
    let pdos: Vec<_> = dictionary.pdos(Direction::Transmit).collect();
    assert_eq!(pdos.iter().map(|pdo| pdo.number).collect::<Vec<_>>(), [1, 2]);
    assert_eq!(pdos[0].cob_id(), Some(&Value::NodeIdPlus(0x180)));
    let mapped: Vec<_> = pdos[0].mapped().map(|mapped| (mapped.address, mapped.bits)).collect();
    assert_eq!(mapped, [(Address::new(0x6004, 0), 32)]);
    assert!(pdos[1].communication.is_none());
}

#[test]
fn compact_pdo_stands_for_the_objects_of_pdos_without_sections() {
    let text = format!(
        "[DeviceInfo]\nGranularity=8\nNrOfRXPDO=5\nNrOfTXPDO=1\nCompactPDO=23\n[1400]\nParameterName=own\nObjectType=9\n\
         [1400sub0]\n{VALUE}"
    );
    let (dictionary, problems) = lower_unlisted(&text);
    assert!(problems.is_empty(), "{problems:?}");
    assert_eq!(dictionary.object(0x1400).unwrap().name, "own");
    assert_eq!(subs(&dictionary, 0x1401), [0, 1, 2, 3, 5], "bits 0, 1, 2 and 4");
    assert_eq!(unsigned(&dictionary, 0x1401, 0), Some(5));
    assert_eq!(entry(&dictionary, 0x1401, 1).default, Some(Value::NodeIdPlus(0x300)));
    assert_eq!(
        entry(&dictionary, 0x1404, 1).default,
        Some(Value::Unsigned(0x8000_0000))
    );
    assert_eq!(entry(&dictionary, 0x1800, 1).default, Some(Value::NodeIdPlus(0x180)));
    assert_eq!(
        subs(&dictionary, 0x1600),
        (0..=8).collect::<Vec<_>>(),
        "eight objects of eight bits"
    );
    assert_eq!(entry(&dictionary, 0x1600, 0).access, AccessType::Rw);
    assert_eq!(dictionary.pdos(Direction::Receive).count(), 5);
    assert_eq!(dictionary.pdos(Direction::Transmit).count(), 1);
}

const MODULES: &str = "[M1FixedObjects]\nNrOfEntries=1\n1=0x6423\n[M1Fixed6423]\nParameterName=Enable\nDataType=1\n\
    AccessType=rw\n[M1SubExtends]\nNrOfEntries=1\n1=0x6000\n[M1SubExt6000]\nParameterName=Input\nDataType=5\n\
    AccessType=ro\nPDOMapping=1\nCount=2\n[M2SubExt6020]\nParameterName=Bit\nDataType=5\nAccessType=ro\nCount=0;3\n";

#[test]
fn connected_modules_add_their_objects_once_and_their_sub_objects_each() {
    let text = format!("[ConnectedModules]\nNrOfEntries=2\n1=1\n2=1\n{MODULES}");
    let (dictionary, problems) = lower(&text);
    assert!(problems.is_empty(), "{problems:?}");
    assert_eq!(dictionary.object(0x6423).unwrap().name, "Enable");
    let extended = dictionary.object(0x6000).unwrap();
    assert_eq!((extended.code, extended.name.as_str()), (ObjectCode::Array, "Input"));
    assert_eq!(subs(&dictionary, 0x6000), [0, 1, 2, 3, 4]);
    assert_eq!(unsigned(&dictionary, 0x6000, 0), Some(4));
    assert!(entry(&dictionary, 0x6000, 4).pdo_mapping);
    assert_eq!(entry(&dictionary, 0x6000, 4).name, "Input4");
}

#[test]
fn without_connected_modules_nothing_is_added() {
    let (dictionary, _) = lower(MODULES);
    assert!(dictionary.objects.is_empty());
}

#[test]
fn modules_extend_an_object_that_the_device_has_itself() {
    let text = format!(
        "[ConnectedModules]\n1=1\n[6000]\nParameterName=Inputs\nObjectType=8\n[6000sub0]\nParameterName=n\nDataType=5\n\
         AccessType=ro\nDefaultValue=1\n[6000sub1]\n{VALUE}{MODULES}"
    );
    let (dictionary, _) = lower_unlisted(&text);
    assert_eq!(subs(&dictionary, 0x6000), [0, 1, 2, 3]);
    assert_eq!(unsigned(&dictionary, 0x6000, 0), Some(3));
}

#[test]
fn modules_that_add_bits_share_sub_objects() {
    let text = format!("[ConnectedModules]\n1=2\n2=2\n3=2\n{MODULES}");
    let (dictionary, _) = lower(&text);
    assert_eq!(
        subs(&dictionary, 0x6020),
        [0, 1, 2],
        "nine bits need two sub-objects of eight"
    );
}

#[test]
fn an_extension_goes_on_in_the_next_object_where_it_may() {
    let extension = "[M1SubExt6000]\nParameterName=i\nDataType=5\nAccessType=ro\nCount=3\nObjExtend=4\n";
    let (dictionary, problems) = lower(&format!("[ConnectedModules]\n1=1\n2=1\n{extension}"));
    assert!(problems.is_empty(), "{problems:?}");
    assert_eq!(
        (subs(&dictionary, 0x6000).len(), subs(&dictionary, 0x6001).len()),
        (5, 3)
    );
    assert_eq!(
        (unsigned(&dictionary, 0x6000, 0), unsigned(&dictionary, 0x6001, 0)),
        (Some(4), Some(2))
    );
}

#[test]
fn an_extension_stops_where_an_object_is_full() {
    let extension = "[M1SubExt6000]\nParameterName=i\nDataType=5\nAccessType=ro\nCount=200\n";
    let (dictionary, problems) = lower(&format!("[ConnectedModules]\n1=1\n2=1\n{extension}"));
    assert_eq!(subs(&dictionary, 0x6000).len(), 255);
    assert!(matches!(
        problems.as_slice(),
        [Problem::NoRoomForModule { index: 0x6000, .. }]
    ));
}

#[test]
fn modules_that_nobody_describes_are_told() {
    let (dictionary, problems) = lower("[ConnectedModules]\n1=9\n2=1\n[M1FixedObjects]\n1=0x6000\n");
    assert!(dictionary.objects.is_empty());
    assert!(matches!(
        problems.as_slice(),
        [
            Problem::UnknownModule { number: 9, .. },
            Problem::AbsentModuleObject {
                number: 1,
                index: 0x6000,
                ..
            }
        ]
    ));
}

#[test]
fn at_most_254_modules_are_connected() {
    let lines = (1..=300)
        .map(|number| format!("{number}=1\n"))
        .collect::<Vec<_>>()
        .concat();
    let extension = "[M1SubExt6000]\nParameterName=i\nDataType=5\nAccessType=ro\nCount=1\n";
    let (dictionary, problems) = lower(&format!("[ConnectedModules]\n{lines}{extension}"));
    assert_eq!(subs(&dictionary, 0x6000).len(), 255);
    assert!(matches!(problems.as_slice(), [Problem::TooManyModules { .. }]));
}

#[test]
fn compact_forms_stand_for_no_more_values_than_memory_can_hold() {
    let object = |index| format!("[{index:04X}]\n{VALUE}ObjectType=8\nCompactSubObj=254\n");
    let objects: Vec<_> = (0x2000..0x3000).map(object).collect();
    let (dictionary, problems) = lower_unlisted(&objects.concat());
    assert!(dictionary.entries().count() < 510_000);
    let first = problems
        .iter()
        .find(|problem| matches!(problem, Problem::TooManyValues { .. }));
    assert!(
        matches!(first, Some(Problem::TooManyValues { index: 0x27B0, .. })),
        "{first:?}"
    );
}
