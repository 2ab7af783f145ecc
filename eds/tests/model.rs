//! What a file says, keyword by keyword.

use lexican_eds::Reading;
use lexican_eds::document::Keyword;
use lexican_eds::ir::{AccessType, DataType, ObjectCode, Value};
use lexican_eds::literal::{Fault, Note};
use lexican_eds::model::{Count, Expected, Object, PpOffset, Problem};
use lexican_eds::span::{Span, Spanned};

fn read(text: &str) -> Reading {
    lexican_eds::read("test.eds", text.into())
}

/// The only object of a file.
fn object(reading: &Reading) -> &Object {
    match reading.eds.objects.as_slice() {
        [object] => object,
        objects => panic!("{} objects", objects.len()),
    }
}

#[expect(
    clippy::ref_option,
    reason = "the fields are what they are; a call for each of them reads better so"
)]
fn value<T: Clone>(field: &Option<Spanned<T>>) -> Option<T> {
    field.as_ref().map(|field| field.value.clone())
}

fn said(reading: &Reading, span: Span) -> &str {
    reading.document.text(span)
}

#[test]
fn file_info_is_read_key_by_key() {
    let reading = read(
        "[FileInfo]\nFileName=a.eds\nFileVersion=1\nFileRevision=0x02\nEDSVersion=4.0\nDescription=A device\n\
         CreationTime=09:45AM\nCreationDate=05-15-2021\nCreatedBy=N. N.\nModificationTime=10:00PM\n\
         ModificationDate=05-16-2021\nModifiedBy=M. M.\nLastEDS=b.eds\n",
    );
    let info = reading.eds.file_info.as_ref().unwrap();
    assert_eq!(value(&info.file_name).unwrap(), "a.eds");
    assert_eq!(
        (value(&info.file_version), value(&info.file_revision)),
        (Some(1), Some(2))
    );
    assert_eq!(value(&info.eds_version).unwrap(), "4.0");
    assert_eq!(value(&info.description).unwrap(), "A device");
    assert_eq!(value(&info.creation_time).unwrap(), "09:45AM");
    assert_eq!(value(&info.creation_date).unwrap(), "05-15-2021");
    assert_eq!(value(&info.created_by).unwrap(), "N. N.");
    assert_eq!(value(&info.modification_time).unwrap(), "10:00PM");
    assert_eq!(value(&info.modification_date).unwrap(), "05-16-2021");
    assert_eq!(value(&info.modified_by).unwrap(), "M. M.");
    assert_eq!(value(&info.last_eds).unwrap(), "b.eds");
    assert_eq!(said(&reading, info.header), "[FileInfo]");
    assert!(reading.eds.problems().is_empty());
}

#[test]
fn device_info_is_read_key_by_key() {
    let reading = read(
        "[DeviceInfo]\nVendorName=\"TR\"\nVendorNumber=0x195\nProductName=E\nProductNumber=7\nRevisionNumber=0x10002\n\
         OrderCode=E-7\nLSS_SerialNumber=99\nBaudRate_10=0\nBaudrate_1000=1\nBaudRate_100=1\nSimpleBootUpMaster=0\n\
         SimpleBootupSlave=1\nGranularity=8\nDynamicChannelsSupported=0x00000000\nGroupMessaging=0\nNrOfRxPDO=2\n\
         NrOfTXPDO=0x4\nLSS_Supported=1\nCompactPDO=23\nNG_Slave=1\nNG_Master=0\nNrOfNG_MonitoredNodes=3\n\
         LSS_Master=1\nBaudRate_auto=0\nCANopenSafetySupported=1\n",
    );
    let info = reading.eds.device_info.as_ref().unwrap();
    assert_eq!(value(&info.vendor_name).unwrap(), "TR");
    assert_eq!(value(&info.vendor_number), Some(0x195));
    assert_eq!(value(&info.product_name).unwrap(), "E");
    assert_eq!(value(&info.product_number), Some(7));
    assert_eq!(value(&info.revision_number), Some(0x10002));
    assert_eq!(value(&info.order_code).unwrap(), "E-7");
    assert_eq!(value(&info.lss_serial_number), Some(99));
    let rates = info.baud_rates.iter().map(|rate| (rate.rate, rate.supported.value));
    assert_eq!(rates.collect::<Vec<_>>(), [(10, false), (1000, true), (100, true)]);
    assert_eq!(value(&info.simple_boot_up_master), Some(false));
    assert_eq!(value(&info.simple_boot_up_slave), Some(true));
    assert_eq!(value(&info.granularity), Some(8));
    assert_eq!(value(&info.dynamic_channels_supported), Some(0));
    assert_eq!(value(&info.group_messaging), Some(false));
    assert_eq!(
        (value(&info.nr_of_rx_pdo), value(&info.nr_of_tx_pdo)),
        (Some(2), Some(4))
    );
    assert_eq!(value(&info.lss_supported), Some(true));
    assert_eq!(value(&info.compact_pdo), Some(23));
    assert_eq!(
        (value(&info.ng_slave), value(&info.ng_master)),
        (Some(true), Some(false))
    );
    assert_eq!(value(&info.nr_of_ng_monitored_nodes), Some(3));
    assert_eq!(
        (value(&info.lss_master), value(&info.baud_rate_auto)),
        (Some(true), Some(false))
    );
    assert_eq!(value(&info.canopen_safety_supported), Some(true));
    let [Problem::Unusual { keyword, note, at, .. }] = *reading.eds.problems() else {
        panic!("{:?}", reading.eds.problems())
    };
    assert_eq!((keyword, note), (Keyword::VendorName, Note::Quoted));
    assert_eq!(said(&reading, at), "\"TR\"");
}

#[test]
fn keywords_of_the_first_eds_versions_are_named_as_such() {
    let reading = read("[DeviceInfo]\nProductVersion=1\nExtendedBootUpSlave=0\n");
    let legacy = |keyword| {
        reading
            .eds
            .problems()
            .iter()
            .any(|problem| matches!(problem, Problem::LegacyKeyword { keyword: found, .. } if *found == keyword))
    };
    assert!(legacy(Keyword::ProductVersion) && legacy(Keyword::ExtendedBootUpSlave));
}

#[test]
fn a_keyword_in_a_section_where_it_means_nothing_is_misplaced() {
    let reading = read("[FileInfo]\nDataType=7\nNoKeywordAtAll=1\n");
    let [Problem::MisplacedKeyword { keyword, at }] = *reading.eds.problems() else {
        panic!("{:?}", reading.eds.problems())
    };
    assert_eq!(keyword, Keyword::DataType);
    assert_eq!(said(&reading, at), "DataType");
}

#[test]
fn commissioning_is_read_in_both_spellings() {
    for spelling in ["DeviceComissioning", "DeviceCommissioning"] {
        let reading = read(&format!(
            "[{spelling}]\nNodeID=0x10\nNodeName=Left\nNodeRefd=A1\nBaudrate=250\nNetNumber=1\nNetworkName=Main\n\
             NetRefd=N1\nCANopenManager=1\nLSS_SerialNumber=0x1234\n"
        ));
        let commissioning = reading.eds.commissioning.as_ref().unwrap();
        assert_eq!(value(&commissioning.node_id), Some(0x10));
        assert_eq!(value(&commissioning.node_name).unwrap(), "Left");
        assert_eq!(value(&commissioning.node_refd).unwrap(), "A1");
        assert_eq!(value(&commissioning.baud_rate), Some(250));
        assert_eq!(value(&commissioning.net_number), Some(1));
        assert_eq!(value(&commissioning.network_name).unwrap(), "Main");
        assert_eq!(value(&commissioning.net_refd).unwrap(), "N1");
        assert_eq!(value(&commissioning.canopen_manager), Some(true));
        assert_eq!(value(&commissioning.lss_serial_number), Some(0x1234));
        assert!(reading.eds.is_dcf());
    }
}

#[test]
fn lists_comments_dummies_tools_and_channels_are_read() {
    let reading = read(
        "[OptionalObjects]\nSupportedObjects=0x2\n1=0x1003\n2=4120\n[Comments]\nLines=1\nLine1=\"As is\"\n\
         [DummyUsage]\nDummy0005=1\nDummy0007=0\n[StandardDataTypes]\n0x0001=1\n\
         [Tools]\nItems=1\n[Tool1]\nName=Setup\nCommand=setup $EDS\n\
         [DynamicChannels]\nNrOfSeg=1\nType1=0x0007\nDir1=rww\nRange1=0xA080-0xA0BF\nPPOffset1=0x10, 1\nMaxCnt1=64\n",
    );
    let optional = reading.eds.optional.as_ref().unwrap();
    assert_eq!(value(&optional.count), Some(2));
    assert_eq!(
        optional.values().map(|index| index.value).collect::<Vec<_>>(),
        [0x1003, 0x1018]
    );
    let comments = reading.eds.comments.as_ref().unwrap();
    assert_eq!(comments.items[0].value.value, "\"As is\"");
    let dummies = reading.eds.dummy_usage.as_ref().unwrap();
    assert_eq!((dummies.types[0].data_type, dummies.types[0].used.value), (5, true));
    assert_eq!(reading.eds.standard_data_types.as_ref().unwrap().types[0].data_type, 1);
    let tools = reading.eds.tools.as_ref().unwrap();
    assert_eq!(value(&tools.items), Some(1));
    assert_eq!(value(&tools.tools[0].command).unwrap(), "setup $EDS");
    let channels = reading.eds.dynamic_channels.as_ref().unwrap();
    let segment = &channels.segments[0];
    assert_eq!((value(&channels.nr_of_seg), segment.number), (Some(1), 1));
    assert_eq!(value(&segment.data_type), Some(7));
    assert_eq!(value(&segment.direction), Some(AccessType::Rww));
    assert_eq!(value(&segment.range), Some((0xA080, 0xA0BF)));
    let offset = PpOffset {
        offset: 0x10,
        address_difference: Some(1),
    };
    assert_eq!(
        (value(&segment.pp_offset), value(&segment.max_cnt)),
        (Some(offset), Some(64))
    );
    assert!(reading.eds.problems().is_empty(), "{:?}", reading.eds.problems());
}

#[test]
fn an_object_is_read_key_by_key_and_each_value_has_its_place() {
    let reading = read(
        "[6003]\nParameterName=Preset\nObjectType=0x7\nLowLimit=-5\nHighLimit=0x7FFF\nDefaultValue=0x10\nDataType=0x0004\n\
         AccessType=rw\nPDOMapping=0\nObjFlags=3\nParameterValue=17\nDenotation=Left\nUploadFile=u.bin\n\
         DownloadFile=d.bin\nParaRefd=P1\nUniqueIDRef=id7\n\
         SRDOMapping=1\nInvertedSRAD=0x610101\n",
    );
    let description = object(&reading).description.as_ref().unwrap();
    assert_eq!(value(&description.parameter_name).unwrap(), "Preset");
    assert_eq!(value(&description.object_type), Some(ObjectCode::Var));
    assert_eq!(value(&description.data_type), Some(4));
    assert_eq!(value(&description.access_type), Some(AccessType::Rw));
    assert_eq!(value(&description.pdo_mapping), Some(false));
    assert_eq!(value(&description.low_limit), Some(Value::Integer(-5)));
    assert_eq!(value(&description.high_limit), Some(Value::Integer(0x7FFF)));
    assert_eq!(value(&description.obj_flags), Some(3));
    let default = description.default_value.as_ref().unwrap();
    assert_eq!(
        (&default.value, said(&reading, default.span)),
        (&Value::Integer(16), "0x10")
    );
    let configuration = description.configuration.as_ref().unwrap();
    assert_eq!(value(&configuration.parameter_value), Some(Value::Integer(17)));
    assert_eq!(value(&configuration.denotation).unwrap(), "Left");
    assert_eq!(value(&configuration.upload_file).unwrap(), "u.bin");
    assert_eq!(value(&configuration.download_file).unwrap(), "d.bin");
    assert_eq!(value(&configuration.para_refd).unwrap(), "P1");
    assert_eq!(value(&configuration.unique_id_ref).unwrap(), "id7");
    assert_eq!(value(&configuration.srdo_mapping), Some(true));
    assert_eq!(value(&configuration.inverted_srad), Some(0x61_0101));
    assert!(reading.eds.problems().is_empty());
}

#[test]
fn an_unreadable_value_is_left_out_and_told_with_its_place_and_what_was_expected() {
    let reading = read("[2000]\nObjectType=7\nDataType=0x0006\nDefaultValue=12 mm\nHighLimit=65536\nLowLimit=1\n");
    let description = object(&reading).description.as_ref().unwrap();
    assert_eq!(description.default_value, None);
    assert_eq!(description.high_limit, None);
    assert_eq!(value(&description.low_limit), Some(Value::Unsigned(1)));
    let [
        Problem::Unreadable {
            keyword,
            expected,
            fault,
            at,
        },
        Problem::Unreadable { fault: of_limit, .. },
    ] = *reading.eds.problems()
    else {
        panic!("{:?}", reading.eds.problems())
    };
    assert_eq!(keyword, Keyword::DefaultValue);
    assert_eq!(expected, Expected::Value(DataType::Unsigned16));
    assert_eq!((fault, of_limit), (Fault::NotANumber, Fault::OutOfRange));
    assert_eq!(said(&reading, at), "12 mm");
}

#[test]
fn an_unusual_spelling_is_read_and_told() {
    let reading = read("[2000]\nDataType=0x0004 # INTEGER32\nAccessType=RW\nLowLimit=0x80000000\n");
    let description = object(&reading).description.as_ref().unwrap();
    assert_eq!(value(&description.data_type), Some(4));
    assert_eq!(value(&description.access_type), Some(AccessType::Rw));
    assert_eq!(value(&description.low_limit), Some(Value::Integer(i64::from(i32::MIN))));
    let notes = reading.eds.problems().iter().map(|problem| match problem {
        Problem::Unusual { keyword, note, .. } => (*keyword, *note),
        other => panic!("{other:?}"),
    });
    let expected = [
        (Keyword::DataType, Note::TrailingComment),
        (Keyword::AccessType, Note::LetterCase),
        (Keyword::LowLimit, Note::TwosComplement),
    ];
    assert_eq!(notes.collect::<Vec<_>>(), expected);
}

#[test]
fn an_empty_value_is_none_and_told_where_a_keyword_needs_one() {
    let reading = read("[2000]\nParameterName=\nDataType=0x0009\nAccessType=\nDefaultValue=\nLowLimit=\n");
    let description = object(&reading).description.as_ref().unwrap();
    assert_eq!(value(&description.parameter_name).unwrap(), "");
    assert_eq!(description.access_type, None);
    assert_eq!(description.default_value, None);
    assert!(description.mentions(Keyword::AccessType) && !description.mentions(Keyword::ObjectType));
    let [Problem::EmptyValue { keyword, at, .. }] = *reading.eds.problems() else {
        panic!("{:?}", reading.eds.problems())
    };
    assert_eq!((keyword, said(&reading, at)), (Keyword::AccessType, "AccessType"));
}

#[test]
fn a_data_type_that_nobody_knows_is_kept_but_its_values_are_not() {
    let reading = read("[2000]\nDataType=0x0040\nDefaultValue=5\n[2001]\nObjectType=9\nDefaultValue=5\n");
    let [unknown, missing] = reading.eds.objects.as_slice() else {
        panic!("two objects")
    };
    assert_eq!(value(&unknown.description.as_ref().unwrap().data_type), Some(0x40));
    assert_eq!(missing.description.as_ref().unwrap().default_value, None);
    assert!(matches!(
        reading.eds.problems(),
        [
            Problem::ValueOfUnknownType { data_type: 0x40, .. },
            Problem::ValueWithoutType { .. }
        ]
    ));
}

#[test]
fn a_limit_of_a_text_is_no_limit() {
    let reading = read("[2000]\nDataType=0x0009\nHighLimit=255\nDefaultValue=255\n");
    let description = object(&reading).description.as_ref().unwrap();
    assert_eq!(description.high_limit, None);
    assert_eq!(value(&description.default_value), Some(Value::Text("255".into())));
    let [Problem::LimitOfUnorderedType { data_type, .. }] = *reading.eds.problems() else {
        panic!("{:?}", reading.eds.problems())
    };
    assert_eq!(data_type, DataType::VisibleString);
}

#[test]
fn the_sections_of_an_object_come_together_and_sorted() {
    let reading = read(
        "[2000sub2]\nParameterName=b\nDataType=5\nDefaultValue=2\n[2000Value]\nNrOfEntries=1\n2=9\n[2000Name]\n1=x\n\
         [2000]\nSubNumber=2\nCompactSubObj=3\n[2000sub0]\nDefaultValue=2\n[2000Denotation]\n1=d\n\
         [2000ObjectLinks]\nObjectLinks=1\n1=0x1000\n",
    );
    let object = object(&reading);
    assert_eq!(object.subs.iter().map(|sub| sub.sub).collect::<Vec<_>>(), [0, 2]);
    assert_eq!(
        value(&object.sub(0).unwrap().description.default_value),
        Some(Value::Unsigned(2)),
        "sub-index 0 is UNSIGNED8"
    );
    let description = object.description.as_ref().unwrap();
    assert_eq!(
        (value(&description.sub_number), value(&description.compact_sub_obj)),
        (Some(2), Some(3))
    );
    let values = object.values.as_ref().unwrap();
    assert_eq!(
        (values.items[0].number.value, &values.items[0].value.value),
        (2, &Value::Unsigned(9))
    );
    assert_eq!(object.names.as_ref().unwrap().items[0].value.value, "x");
    assert_eq!(object.denotations.as_ref().unwrap().items[0].value.value, "d");
    assert_eq!(object.links.as_ref().unwrap().items[0].value.value, 0x1000);
}

#[test]
fn the_first_of_two_sections_and_of_two_keywords_counts() {
    let reading = read("[2000]\nDataType=5\nDataType=6\n[2000]\nDataType=7\n");
    let description = object(&reading).description.as_ref().unwrap();
    assert_eq!(value(&description.data_type), Some(5));
}

#[test]
fn modules_are_read_with_all_their_sections() {
    let reading = read(
        "[SupportedModules]\nNrOfEntries=2\n1=1\n2=2\n[ConnectedModules]\nNrOfEntries=2\n1=2\n2=1\n\
         [M1ModuleInfo]\nProductName=DI8\nProductVersion=1\nProductRevision=2\nOrderCode=D-8\n[M1Comments]\nLines=1\nLine1=x\n\
         [M1FixedObjects]\nNrOfEntries=1\n1=0x6423\n[M1Fixed6423]\nParameterName=Enable\nDataType=1\nAccessType=rw\n\
         [M1SubExtends]\nNrOfEntries=1\n1=0x6000\n[M1SubExt6000]\nParameterName=Input\nDataType=5\nAccessType=ro\nCount=2\nObjExtend=128\n\
         [M2SubExt6000]\nDataType=5\nCount=0;4\n",
    );
    let [first, second] = reading.eds.modules.as_slice() else {
        panic!("two modules")
    };
    let info = first.info.as_ref().unwrap();
    assert_eq!(value(&info.product_name).unwrap(), "DI8");
    assert_eq!(
        (value(&info.product_version), value(&info.product_revision)),
        (Some(1), Some(2))
    );
    assert_eq!(value(&info.order_code).unwrap(), "D-8");
    assert_eq!(first.comments.as_ref().unwrap().items.len(), 1);
    assert_eq!(first.fixed_objects.as_ref().unwrap().items[0].value.value, 0x6423);
    assert_eq!(first.fixed[0].index, 0x6423);
    assert_eq!(first.sub_extends.as_ref().unwrap().items[0].value.value, 0x6000);
    assert_eq!(value(&first.extensions[0].count), Some(Count::Subs(2)));
    assert_eq!(value(&first.extensions[0].obj_extend), Some(128));
    assert_eq!(value(&second.extensions[0].count), Some(Count::Bits(4)));
    let connected = reading.eds.connected_modules.as_ref().unwrap();
    assert_eq!(
        connected.values().map(|module| module.value).collect::<Vec<_>>(),
        [2, 1]
    );
    assert_eq!(value(&reading.eds.supported_modules.as_ref().unwrap().count), Some(2));
    assert!(reading.eds.problems().is_empty(), "{:?}", reading.eds.problems());
}
