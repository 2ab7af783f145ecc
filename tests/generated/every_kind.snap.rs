pub mod every_kind {
    //! Object dictionary of `Every kind`, generated from `every_kind.eds`. Do not edit.
    //!
    //! * Vendor: `Lexican`
    //! * Order code: `EK-1`
    //! * Description: `Every kind of object`
    //! * 405 values of 112 objects; 792 bytes of RAM
    use core::mem::offset_of;
    use lexican_runtime::{AbortCode, Address, Event, NodeId, bytemuck};
    use lexican_runtime::od::{
        Access, Boolean, DataType, Extra, NumberSet, OctetString, Part, Row, ServiceSet,
        Table, TimeOfDay, Value, VisibleString, place, resized, set_element, written,
    };
    /// The values of the dictionary: first those that are not 0 after power-on, and of both kinds the widest first.
    #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
    #[bytemuck(crate = "::lexican_runtime::bytemuck")]
    #[repr(C)]
    pub struct Dictionary {
        /// 2005h `Value INTEGER40`, `INTEGER40`, rw, default `-549_755_813_888`
        pub value_integer40: i64,
        /// 2006h `Value INTEGER48`, `INTEGER48`, rw, default `-140_737_488_355_328`
        pub value_integer48: i64,
        /// 2007h `Value INTEGER56`, `INTEGER56`, rw, default `-36_028_797_018_963_968`
        pub value_integer56: i64,
        /// 2008h `Value INTEGER64`, `INTEGER64`, rw, default `-9_223_372_036_854_775_808`
        pub value_integer64: i64,
        /// 200Dh `Value UNSIGNED40`, `UNSIGNED40`, rw, default `1_099_511_627_775`
        pub value_unsigned40: u64,
        /// 200Eh `Value UNSIGNED48`, `UNSIGNED48`, rw, default `281_474_976_710_655`
        pub value_unsigned48: u64,
        /// 200Fh `Value UNSIGNED56`, `UNSIGNED56`, rw, default `72_057_594_037_927_935`
        pub value_unsigned56: u64,
        /// 2010h `Value UNSIGNED64`, `UNSIGNED64`, rw, default `18_446_744_073_709_551_615`
        pub value_unsigned64: u64,
        /// 2012h `Value REAL64`, `REAL64`, rw, default `2.718_281_828_459_045`
        pub value_real64: f64,
        /// 2203h `Limited UNSIGNED40`, `UNSIGNED40`, rw, `4_294_967_296` to `1_095_216_660_480`, default `4_294_967_296`
        pub limited_unsigned40: u64,
        /// 2404h `Formula UNSIGNED64`, `UNSIGNED64`, rw, default `$NODEID+0x100000000`
        pub formula_unsigned64: u64,
        /// 1005h `COB-ID SYNC`, `UNSIGNED32`, rw, default `0x0000_0080`
        pub cob_id_sync: u32,
        /// 1010sub1 `Store parameters`, `UNSIGNED32`, rw, default `0x0000_0001`
        pub store_parameters: [u32; 1],
        /// 1014h `COB-ID EMCY`, `UNSIGNED32`, rw, default `$NODEID+0x80`
        pub cob_id_emcy: u32,
        /// 1800sub1 `TPDO communication parameter`, `COB-ID used by TPDO`, `UNSIGNED32`, rw, default `$NODEID+0x180`
        pub tpdo_communication_parameter_1800_cob_id_used_by_tpdo: u32,
        /// 1801sub1 `TPDO communication parameter`, `COB-ID used by TPDO`, `UNSIGNED32`, rw, default `$NODEID+0x280`
        pub tpdo_communication_parameter_1801_cob_id_used_by_tpdo: u32,
        /// 1A00sub1 to 1A00sub3 `TPDO mapping parameter`, `UNSIGNED32`, rw
        ///
        /// * `[0]`: `Mapped object 1`, default `0x6004_0020`
        /// * `[1]`: `Mapped object 2`, default `0x6030_0110`
        /// * `[2]`: `Mapped object 3`, default `0x0000_0000`
        pub tpdo_mapping_parameter: [u32; 3],
        /// 2003h `Value INTEGER32`, `INTEGER32`, rw, default `-70000`, PDO-mappable
        pub value_integer32: i32,
        /// 2004h `Value INTEGER24`, `INTEGER24`, rw, default `-8_388_608`
        pub value_integer24: i32,
        /// 200Bh `Value UNSIGNED32`, `UNSIGNED32`, rw, default `4_294_967_295`, PDO-mappable
        pub value_unsigned32: u32,
        /// 200Ch `Value UNSIGNED24`, `UNSIGNED24`, rw, default `16_777_215`
        pub value_unsigned24: u32,
        /// 2011h `Value REAL32`, `REAL32`, rw, default `3.14`, PDO-mappable
        pub value_real32: f32,
        /// 2204h `Limited REAL32`, `REAL32`, rw, `0.5` to `2.0`, default `1.0`
        pub limited_real32: f32,
        /// 2403h `Formula UNSIGNED24`, `UNSIGNED24`, rw, default `$NODEID+0x10000`
        pub formula_unsigned24: u32,
        /// 2405sub1 to 2405sub2 `Formula list`, `UNSIGNED32`, rw
        ///
        /// * `[0]`: `First`, default `$NODEID+0x200`
        /// * `[1]`: `Second`, default `5`
        pub formula_list: [u32; 2],
        /// 1017h `Producer heartbeat time`, `UNSIGNED16` in ms, rw, default `1000`
        pub producer_heartbeat_time: u16,
        /// 2002h `Value INTEGER16`, `INTEGER16`, rw, default `-300`, PDO-mappable
        pub value_integer16: i16,
        /// 200Ah `Value UNSIGNED16`, `UNSIGNED16`, rw, default `65535`, PDO-mappable
        pub value_unsigned16: u16,
        /// 2300sub1 to 2300sub3 `Limited list`, `INTEGER16`, rw
        ///
        /// * `[0]`: `Element 1`, `-10` to `10`, default `1`
        /// * `[1]`: `Element 2`, `-10` to `20`, default `2`
        /// * `[2]`: `Element 3`, `-10` to `30`, default `3`
        pub limited_list: [i16; 3],
        /// 2401h `Formula UNSIGNED16`, `UNSIGNED16`, rw, default `$NODEID+0x700`
        pub formula_unsigned16: u16,
        /// 2402h `Formula INTEGER16`, `INTEGER16`, rw, default `$NODEID+0x10`
        pub formula_integer16: i16,
        /// 1800sub2 `TPDO communication parameter`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_communication_parameter_1800_transmission_type: u8,
        /// 1801sub2 `TPDO communication parameter`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_communication_parameter_1801_transmission_type: u8,
        /// 1A00sub0 `TPDO mapping parameter`, `Number of mapped objects`, `UNSIGNED8`, rw, default `2`
        pub tpdo_mapping_parameter_number_of_mapped_objects: u8,
        /// 2000h `Value BOOLEAN`, `BOOLEAN`, rw, default `true`, PDO-mappable
        pub value_boolean: Boolean,
        /// 2001h `Value INTEGER8`, `INTEGER8`, rw, default `-5`, PDO-mappable
        pub value_integer8: i8,
        /// 2009h `Value UNSIGNED8`, `UNSIGNED8`, rw, default `255`, PDO-mappable
        pub value_unsigned8: u8,
        /// 2013h `Value VISIBLE_STRING`, `VISIBLE_STRING`, rw, at most 20 bytes, default `text`
        pub value_visible_string: VisibleString<20>,
        /// 2014h `Value OCTET_STRING`, `OCTET_STRING`, rw, at most 3 bytes, default `01 02 FF`
        pub value_octet_string: OctetString<3>,
        /// 2015h `Value UNICODE_STRING`, `UNICODE_STRING`, rw, at most 10 bytes, default `Größe`
        pub value_unicode_string: OctetString<10>,
        /// 2207h `Limited BOOLEAN`, `BOOLEAN`, rw, at least `true`, default `true`
        pub limited_boolean: Boolean,
        /// 2301sub1 to 2301subFE `Long list`, `UNSIGNED8`, rw, default `7`
        pub long_list: [u8; 254],
        /// 2303sub1 to 2303sub2 `List of texts`, `VISIBLE_STRING`, rw, at most 6 bytes
        ///
        /// * `[0]`: `First`, default `one`
        /// * `[1]`: `Second`, default `second`
        pub list_of_texts: [VisibleString<6>; 2],
        /// 2602h `Note`, `VISIBLE_STRING`, rw, at most 3 bytes, default `abc`
        pub note: VisibleString<3>,
        /// 2605h `Motto`, `VISIBLE_STRING`, const, at most 23 bytes, default `const, but answered for`
        pub motto: VisibleString<23>,
        /// 2606sub1 to 2606sub2 `Switches`, `BOOLEAN`, rw
        ///
        /// * `[0]`: `Switch 1`, default `false`
        /// * `[1]`: `Switch 2`, default `true`
        pub switches: [Boolean; 2],
        /// 2202h `Limited INTEGER40`, `INTEGER40`, rw, `-1000` to `549_755_813_887`, default `0`
        pub limited_integer40: i64,
        /// 2205h `Limited REAL64`, `REAL64`, rw, at least `-1.0e300`, default `0.0`
        pub limited_real64: f64,
        /// 1018sub4 `Identity object`, `Serial number`, `UNSIGNED32`, const, default `0x0000_0000`
        pub identity_object_serial_number: u32,
        /// 2201h `Limited INTEGER24`, `INTEGER24`, rw, `-100` to `100`, default `0`
        pub limited_integer24: i32,
        /// 2500h `type`, `UNSIGNED32`, rw, default `0`
        pub type_: u32,
        /// 2501h `self`, `UNSIGNED32`, rw, default `0`
        pub self_: u32,
        /// 2502h `2nd value`, `UNSIGNED32`, rw, default `0`
        pub object_2nd_value: u32,
        /// 2503h (no name), `UNSIGNED32`, rw, default `0`
        pub object_2503: u32,
        /// 2504h (no name), `UNSIGNED32`, rw, default `0`
        pub object_2504: u32,
        /// 2505h `Größe µ`, `UNSIGNED32`, rw, default `0`
        pub grosse_u: u32,
        /// 2506h `速度`, `UNSIGNED32`, rw, default `0`
        pub su_du: u32,
        /// 2507h `Twin`, `UNSIGNED32`, rw, default `0`
        pub twin_2507: u32,
        /// 2508h `Twin`, `UNSIGNED32`, rw, default `0`
        pub twin_2508: u32,
        /// 2509h ``` a`b``c [x] <b> \\ "q" {c} https://example.com ```, `UNSIGNED32`, rw, default `0`
        pub a_b_c_x_b_q_c_https_example_com: u32,
        /// 250Ah `very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name very long name`, `UNSIGNED32`, rw, default `0`
        pub very_long_name_very_long_name_very_long_name_very_long_name_250a: u32,
        /// 250Ch `!?`, `UNSIGNED32`, rw, default `0`
        pub object_250c: u32,
        /// 250Dh `Underscore_`, `UNSIGNED32`, rw, default `0`
        pub underscore: u32,
        /// 250Eh `Twin 2509`, `UNSIGNED32`, rw, default `0`
        pub twin_2509: u32,
        /// 250Fh `PDOs of IDs`, `UNSIGNED32`, rw, default `0`
        pub pdos_of_ids: u32,
        /// 2510h `Dictionary value`, `UNSIGNED32`, rw, default `0`
        pub dictionary_value: u32,
        /// 2520sub1 `Record of twins`, `Twin`, `UNSIGNED32`, rw
        pub record_of_twins_twin_sub1: u32,
        /// 2520sub2 `Record of twins`, `Twin`, `UNSIGNED32`, rw
        pub record_of_twins_twin_sub2: u32,
        /// 2520sub3 `Record of twins`, (no name), `UNSIGNED32`, rw
        pub record_of_twins_sub3: u32,
        /// 2520sub4 `Record of twins`, `Record of twins own`, `UNSIGNED32`, rw
        pub record_of_twins_own: u32,
        /// 6003h `Preset value`, `UNSIGNED32`, rw, `0` to `4096`, default `0`
        pub preset_value: u32,
        /// 6004h `Position value`, `UNSIGNED32`, ro, default `0`, PDO-mappable
        pub position_value: u32,
        /// 1800sub3 `TPDO communication parameter`, `Inhibit time`, `UNSIGNED16` in multiples of 100 µs, rw, default `0`
        pub tpdo_communication_parameter_1800_inhibit_time: u16,
        /// 1800sub5 `TPDO communication parameter`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        pub tpdo_communication_parameter_1800_event_timer: u16,
        /// 1801sub3 `TPDO communication parameter`, `Inhibit time`, `UNSIGNED16` in multiples of 100 µs, rw, default `0`
        pub tpdo_communication_parameter_1801_inhibit_time: u16,
        /// 1801sub5 `TPDO communication parameter`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        pub tpdo_communication_parameter_1801_event_timer: u16,
        /// 2206h `Limited UNSIGNED16`, `UNSIGNED16`, rw, `0` to `65535`, default `0`
        pub limited_unsigned16: u16,
        /// 2302sub1 `List with a gap`, `Element 1`, `UNSIGNED16`, rw, default `0`
        pub list_with_a_gap_element_1: u16,
        /// 2302sub2 `List with a gap`, `Element 2`, `UNSIGNED16`, rw, default `0`
        pub list_with_a_gap_element_2: u16,
        /// 2302sub4 `List with a gap`, `Element 4`, `UNSIGNED16`, rw, default `0`
        pub list_with_a_gap_element_4: u16,
        /// 6030sub1 to 6030sub3 `Speed value`, `INTEGER16`, ro, default `0`, PDO-mappable
        pub speed_value: [i16; 3],
        /// 1001h `Error register`, `UNSIGNED8`, ro, default `0`, PDO-mappable
        pub error_register: u8,
        /// 100Ah `Manufacturer software version`, `VISIBLE_STRING`, const, at most 32 bytes
        pub manufacturer_software_version: VisibleString<32>,
        /// 2016h `Value TIME_OF_DAY`, `TIME_OF_DAY`, rw
        pub value_time_of_day: TimeOfDay,
        /// 2017h `Value TIME_DIFFERENCE`, `TIME_DIFFERENCE`, rw
        pub value_time_difference: TimeOfDay,
        /// 2018h `Value DOMAIN`, `DOMAIN`, rw, at most 32 bytes
        pub value_domain: OctetString<32>,
        /// 2116h `Constant TIME_OF_DAY`, `TIME_OF_DAY`, const
        pub constant_time_of_day: TimeOfDay,
        /// 2117h `Constant TIME_DIFFERENCE`, `TIME_DIFFERENCE`, const
        pub constant_time_difference: TimeOfDay,
        /// 2118h `Constant DOMAIN`, `DOMAIN`, const, at most 32 bytes
        pub constant_domain: OctetString<32>,
        /// 2200h `Limited INTEGER8`, `INTEGER8`, rw, `-10` to `10`, default `0`
        pub limited_integer8: i8,
        /// 2400h `Formula UNSIGNED8`, `UNSIGNED8`, rw, default `$NODEID`
        pub formula_unsigned8: u8,
        /// 2600h `Switch`, `BOOLEAN`, rw, default `false`
        pub switch: Boolean,
        /// 2601h `Command`, `UNSIGNED8`, wo, at most `3`, default `0`
        pub command: u8,
        /// 2604h `Clock`, `TIME_OF_DAY`, rw
        pub clock: TimeOfDay,
        _padding: [u8; 1],
    }
    impl Dictionary {
        /// 1000h `Device type`, `UNSIGNED32`, ro
        pub const DEVICE_TYPE: u32 = 0x0002_0196;
        /// 1008h `Manufacturer device name`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_DEVICE_NAME: &'static str = "Every kind";
        /// 1009h `Manufacturer hardware version`, `VISIBLE_STRING`, ro
        pub const MANUFACTURER_HARDWARE_VERSION: &'static str = "1.0";
        /// 1010sub0 `Store parameters`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const STORE_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 1018sub0 `Identity object`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const IDENTITY_OBJECT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1018sub1 `Identity object`, `Vendor-ID`, `UNSIGNED32`, ro
        pub const IDENTITY_OBJECT_VENDOR_ID: u32 = 0x1234_5678;
        /// 1018sub2 `Identity object`, `Product code`, `UNSIGNED32`, ro
        pub const IDENTITY_OBJECT_PRODUCT_CODE: u32 = 0x0000_0001;
        /// 1018sub3 `Identity object`, `Revision number`, `UNSIGNED32`, ro
        pub const IDENTITY_OBJECT_REVISION_NUMBER: u32 = 0x0001_0001;
        /// 1800sub0 `TPDO communication parameter`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_COMMUNICATION_PARAMETER_1800_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 1801sub0 `TPDO communication parameter`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_COMMUNICATION_PARAMETER_1801_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 2100h `Constant BOOLEAN`, `BOOLEAN`, const
        pub const CONSTANT_BOOLEAN: bool = true;
        /// 2101h `Constant INTEGER8`, `INTEGER8`, const
        pub const CONSTANT_INTEGER8: i8 = -5;
        /// 2102h `Constant INTEGER16`, `INTEGER16`, const
        pub const CONSTANT_INTEGER16: i16 = -300;
        /// 2103h `Constant INTEGER32`, `INTEGER32`, const
        pub const CONSTANT_INTEGER32: i32 = -70000;
        /// 2104h `Constant INTEGER24`, `INTEGER24`, const
        pub const CONSTANT_INTEGER24: i32 = -8_388_608;
        /// 2105h `Constant INTEGER40`, `INTEGER40`, const
        pub const CONSTANT_INTEGER40: i64 = -549_755_813_888;
        /// 2106h `Constant INTEGER48`, `INTEGER48`, const
        pub const CONSTANT_INTEGER48: i64 = -140_737_488_355_328;
        /// 2107h `Constant INTEGER56`, `INTEGER56`, const
        pub const CONSTANT_INTEGER56: i64 = -36_028_797_018_963_968;
        /// 2108h `Constant INTEGER64`, `INTEGER64`, const
        pub const CONSTANT_INTEGER64: i64 = -9_223_372_036_854_775_808;
        /// 2109h `Constant UNSIGNED8`, `UNSIGNED8`, const
        pub const CONSTANT_UNSIGNED8: u8 = 255;
        /// 210Ah `Constant UNSIGNED16`, `UNSIGNED16`, const
        pub const CONSTANT_UNSIGNED16: u16 = 65535;
        /// 210Bh `Constant UNSIGNED32`, `UNSIGNED32`, const
        pub const CONSTANT_UNSIGNED32: u32 = 4_294_967_295;
        /// 210Ch `Constant UNSIGNED24`, `UNSIGNED24`, const
        pub const CONSTANT_UNSIGNED24: u32 = 16_777_215;
        /// 210Dh `Constant UNSIGNED40`, `UNSIGNED40`, const
        pub const CONSTANT_UNSIGNED40: u64 = 1_099_511_627_775;
        /// 210Eh `Constant UNSIGNED48`, `UNSIGNED48`, const
        pub const CONSTANT_UNSIGNED48: u64 = 281_474_976_710_655;
        /// 210Fh `Constant UNSIGNED56`, `UNSIGNED56`, const
        pub const CONSTANT_UNSIGNED56: u64 = 72_057_594_037_927_935;
        /// 2110h `Constant UNSIGNED64`, `UNSIGNED64`, const
        pub const CONSTANT_UNSIGNED64: u64 = 18_446_744_073_709_551_615;
        /// 2111h `Constant REAL32`, `REAL32`, const
        pub const CONSTANT_REAL32: f32 = 314.0 / 100.0;
        /// 2112h `Constant REAL64`, `REAL64`, const
        pub const CONSTANT_REAL64: f64 = core::f64::consts::E;
        /// 2113h `Constant VISIBLE_STRING`, `VISIBLE_STRING`, const
        pub const CONSTANT_VISIBLE_STRING: &'static str = "text";
        /// 2114h `Constant OCTET_STRING`, `OCTET_STRING`, const
        pub const CONSTANT_OCTET_STRING: &'static [u8] = &[0x01, 0x02, 0xFF];
        /// 2115h `Constant UNICODE_STRING`, `UNICODE_STRING`, const
        pub const CONSTANT_UNICODE_STRING: &'static str = "Größe";
        /// 2300sub0 `Limited list`, `Number of entries`, `UNSIGNED8`, const
        pub const LIMITED_LIST_NUMBER_OF_ENTRIES: u8 = 3;
        /// 2301sub0 `Long list`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const LONG_LIST_NR_OF_OBJECTS: u8 = 254;
        /// 2302sub0 `List with a gap`, `Number of entries`, `UNSIGNED8`, const
        pub const LIST_WITH_A_GAP_NUMBER_OF_ENTRIES: u8 = 4;
        /// 2303sub0 `List of texts`, `Number of entries`, `UNSIGNED8`, const
        pub const LIST_OF_TEXTS_NUMBER_OF_ENTRIES: u8 = 2;
        /// 2304sub0 `Constant list`, `Number of entries`, `UNSIGNED8`, const
        pub const CONSTANT_LIST_NUMBER_OF_ENTRIES: u8 = 2;
        /// 2304sub1 to 2304sub2 `Constant list`, `INTEGER32`, const
        ///
        /// * `[0]`: `First`, default `-1`
        /// * `[1]`: `Second`, default `2`
        pub const CONSTANT_LIST: [i32; 2] = [-1, 2];
        /// 2305sub0 `List of constant texts`, `Number of entries`, `UNSIGNED8`, const
        pub const LIST_OF_CONSTANT_TEXTS_NUMBER_OF_ENTRIES: u8 = 2;
        /// 2305sub1 to 2305sub2 `List of constant texts`, `VISIBLE_STRING`, const
        ///
        /// * `[0]`: `First`, default `one`
        /// * `[1]`: `Second`, default `two`
        pub const LIST_OF_CONSTANT_TEXTS: [&'static str; 2] = ["one", "two"];
        /// 2405sub0 `Formula list`, `Number of entries`, `UNSIGNED8`, const
        pub const FORMULA_LIST_NUMBER_OF_ENTRIES: u8 = 2;
        /// 250Bh `Defaults`, `UNSIGNED32`, const
        pub const DEFAULTS_250B: u32 = 0;
        /// 2520sub0 `Record of twins`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const RECORD_OF_TWINS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 2606sub0 `Switches`, `Number of entries`, `UNSIGNED8`, const
        pub const SWITCHES_NUMBER_OF_ENTRIES: u8 = 2;
        /// 6030sub0 `Speed value`, `Number of entries`, `UNSIGNED8`, ro
        pub const SPEED_VALUE_NUMBER_OF_ENTRIES: u8 = 3;
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            value_integer40: -549_755_813_888,
            value_integer48: -140_737_488_355_328,
            value_integer56: -36_028_797_018_963_968,
            value_integer64: -9_223_372_036_854_775_808,
            value_unsigned40: 1_099_511_627_775,
            value_unsigned48: 281_474_976_710_655,
            value_unsigned56: 72_057_594_037_927_935,
            value_unsigned64: 18_446_744_073_709_551_615,
            value_real64: core::f64::consts::E,
            limited_unsigned40: 4_294_967_296,
            formula_unsigned64: 0x0000_0001_0000_0000,
            cob_id_sync: 0x0000_0080,
            store_parameters: [0x0000_0001],
            cob_id_emcy: 0x0000_0080,
            tpdo_communication_parameter_1800_cob_id_used_by_tpdo: 0x0000_0180,
            tpdo_communication_parameter_1801_cob_id_used_by_tpdo: 0x0000_0280,
            tpdo_mapping_parameter: [0x6004_0020, 0x6030_0110, 0x0000_0000],
            value_integer32: -70000,
            value_integer24: -8_388_608,
            value_unsigned32: 4_294_967_295,
            value_unsigned24: 16_777_215,
            value_real32: 314.0 / 100.0,
            limited_real32: 1.0,
            formula_unsigned24: 0x0001_0000,
            formula_list: [0x0000_0200, 5],
            producer_heartbeat_time: 1000,
            value_integer16: -300,
            value_unsigned16: 65535,
            limited_list: [1, 2, 3],
            formula_unsigned16: 0x0700,
            formula_integer16: 0x0010,
            tpdo_communication_parameter_1800_transmission_type: 254,
            tpdo_communication_parameter_1801_transmission_type: 254,
            tpdo_mapping_parameter_number_of_mapped_objects: 2,
            value_boolean: Boolean::new(true),
            value_integer8: -5,
            value_unsigned8: 255,
            value_visible_string: VisibleString::new(b"text"),
            value_octet_string: OctetString::new(&[0x01, 0x02, 0xFF]),
            value_unicode_string: OctetString::new(
                &[0x47, 0x00, 0x72, 0x00, 0xF6, 0x00, 0xDF, 0x00, 0x65, 0x00],
            ),
            limited_boolean: Boolean::new(true),
            long_list: [7; 254],
            list_of_texts: [VisibleString::new(b"one"), VisibleString::new(b"second")],
            note: VisibleString::new(b"abc"),
            motto: VisibleString::new(b"const, but answered for"),
            switches: [Boolean::new(false), Boolean::new(true)],
            limited_integer40: 0,
            limited_real64: 0.0,
            identity_object_serial_number: 0x0000_0000,
            limited_integer24: 0,
            type_: 0,
            self_: 0,
            object_2nd_value: 0,
            object_2503: 0,
            object_2504: 0,
            grosse_u: 0,
            su_du: 0,
            twin_2507: 0,
            twin_2508: 0,
            a_b_c_x_b_q_c_https_example_com: 0,
            very_long_name_very_long_name_very_long_name_very_long_name_250a: 0,
            object_250c: 0,
            underscore: 0,
            twin_2509: 0,
            pdos_of_ids: 0,
            dictionary_value: 0,
            record_of_twins_twin_sub1: 0,
            record_of_twins_twin_sub2: 0,
            record_of_twins_sub3: 0,
            record_of_twins_own: 0,
            preset_value: 0,
            position_value: 0,
            tpdo_communication_parameter_1800_inhibit_time: 0,
            tpdo_communication_parameter_1800_event_timer: 0,
            tpdo_communication_parameter_1801_inhibit_time: 0,
            tpdo_communication_parameter_1801_event_timer: 0,
            limited_unsigned16: 0,
            list_with_a_gap_element_1: 0,
            list_with_a_gap_element_2: 0,
            list_with_a_gap_element_4: 0,
            speed_value: [0; 3],
            error_register: 0,
            manufacturer_software_version: VisibleString::EMPTY,
            value_time_of_day: TimeOfDay::new(0, 0),
            value_time_difference: TimeOfDay::new(0, 0),
            value_domain: OctetString::EMPTY,
            constant_time_of_day: TimeOfDay::new(0, 0),
            constant_time_difference: TimeOfDay::new(0, 0),
            constant_domain: OctetString::EMPTY,
            limited_integer8: 0,
            formula_unsigned8: 0x00,
            switch: Boolean::new(false),
            command: 0,
            clock: TimeOfDay::new(0, 0),
            _padding: [0; 1],
        };
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                formula_unsigned64: node_id.plus_u64(0x0000_0001_0000_0000),
                cob_id_emcy: node_id.plus_u32(0x0000_0080),
                tpdo_communication_parameter_1800_cob_id_used_by_tpdo: node_id
                    .plus_u32(0x0000_0180),
                tpdo_communication_parameter_1801_cob_id_used_by_tpdo: node_id
                    .plus_u32(0x0000_0280),
                formula_unsigned24: node_id.plus_u32(0x0001_0000),
                formula_list: [node_id.plus_u32(0x0000_0200), 5],
                formula_unsigned16: node_id.plus_u16(0x0700),
                formula_integer16: node_id.plus_i16(16),
                formula_unsigned8: node_id.plus_u8(0x00),
                ..Self::DEFAULTS
            }
        }
    }
    /// What the application answers for.
    pub trait Handlers {
        /// Told what happens on the bus and to the node. Does nothing unless overridden.
        fn event(&mut self, od: &mut Dictionary, event: Event) {
            let _ = (od, event);
        }
        /// 2600h `Switch`, `BOOLEAN`, rw, default `false`
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_switch(&mut self, od: &mut Dictionary) -> Result<bool, AbortCode>;
        /// 2602h `Note`, `VISIBLE_STRING`, rw, at most 3 bytes, default `abc`
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_note(
            &mut self,
            od: &mut Dictionary,
        ) -> Result<VisibleString<3>, AbortCode>;
        /// 2604h `Clock`, `TIME_OF_DAY`, rw
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_clock(&mut self, od: &mut Dictionary) -> Result<TimeOfDay, AbortCode>;
        /// 2605h `Motto`, `VISIBLE_STRING`, const, at most 23 bytes, default `const, but answered for`
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_motto(
            &mut self,
            od: &mut Dictionary,
        ) -> Result<VisibleString<23>, AbortCode>;
        /// 2606sub1 to 2606sub2 `Switches`, `BOOLEAN`, rw
        ///
        /// * `[0]`: `Switch 1`, default `false`
        /// * `[1]`: `Switch 2`, default `true`
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_switches(
            &mut self,
            od: &mut Dictionary,
            sub: u8,
        ) -> Result<bool, AbortCode>;
        /// 6004h `Position value`, `UNSIGNED32`, ro, default `0`, PDO-mappable
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_position_value(&mut self, od: &mut Dictionary) -> Result<u32, AbortCode>;
        /// 6030sub1 to 6030sub3 `Speed value`, `INTEGER16`, ro, default `0`, PDO-mappable
        ///
        /// Called before a client reads it: gives the value, which is stored in `od` and sent.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_speed_value(
            &mut self,
            od: &mut Dictionary,
            sub: u8,
        ) -> Result<i16, AbortCode>;
        /// 1010sub1 `Store parameters`, `UNSIGNED32`, rw, default `0x0000_0001`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_store_parameters(
            &mut self,
            od: &mut Dictionary,
            sub: u8,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 2300sub1 to 2300sub3 `Limited list`, `INTEGER16`, rw
        ///
        /// * `[0]`: `Element 1`, `-10` to `10`, default `1`
        /// * `[1]`: `Element 2`, `-10` to `20`, default `2`
        /// * `[2]`: `Element 3`, `-10` to `30`, default `3`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_limited_list(
            &mut self,
            od: &mut Dictionary,
            sub: u8,
            value: i16,
        ) -> Result<(), AbortCode>;
        /// 2600h `Switch`, `BOOLEAN`, rw, default `false`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_switch(
            &mut self,
            od: &mut Dictionary,
            value: bool,
        ) -> Result<(), AbortCode>;
        /// 2601h `Command`, `UNSIGNED8`, wo, at most `3`, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_command(
            &mut self,
            od: &mut Dictionary,
            value: u8,
        ) -> Result<(), AbortCode>;
        /// 2602h `Note`, `VISIBLE_STRING`, rw, at most 3 bytes, default `abc`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_note(
            &mut self,
            od: &mut Dictionary,
            value: &[u8],
        ) -> Result<(), AbortCode>;
        /// 2604h `Clock`, `TIME_OF_DAY`, rw
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_clock(
            &mut self,
            od: &mut Dictionary,
            value: TimeOfDay,
        ) -> Result<(), AbortCode>;
        /// 2606sub1 to 2606sub2 `Switches`, `BOOLEAN`, rw
        ///
        /// * `[0]`: `Switch 1`, default `false`
        /// * `[1]`: `Switch 2`, default `true`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_switches(
            &mut self,
            od: &mut Dictionary,
            sub: u8,
            value: bool,
        ) -> Result<(), AbortCode>;
        /// 6003h `Preset value`, `UNSIGNED32`, rw, `0` to `4096`, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_preset_value(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 2603h `Program`, `DOMAIN`, rw, in parts of at most 100 bytes
        ///
        /// Called while a client reads it: copies its bytes from `offset` on into `buffer`, as many as there are and fit, and gives the length of the whole value. [`lexican_runtime::od::copy_part`] does so with bytes in memory.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_program(
            &mut self,
            od: &mut Dictionary,
            offset: usize,
            buffer: &mut [u8],
        ) -> Result<usize, AbortCode>;
        /// 2607h `Report`, `VISIBLE_STRING`, rw, in parts of at most 24 bytes, default `written while it is read`
        ///
        /// Called while a client reads it: copies its bytes from `offset` on into `buffer`, as many as there are and fit, and gives the length of the whole value. [`lexican_runtime::od::copy_part`] does so with bytes in memory.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn read_report(
            &mut self,
            od: &mut Dictionary,
            offset: usize,
            buffer: &mut [u8],
        ) -> Result<usize, AbortCode>;
        /// 2603h `Program`, `DOMAIN`, rw, in parts of at most 100 bytes
        ///
        /// Called while a client writes it: once without bytes, when it begins, then with each part in turn.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn write_program(
            &mut self,
            od: &mut Dictionary,
            part: Part<'_>,
        ) -> Result<(), AbortCode>;
        /// 2607h `Report`, `VISIBLE_STRING`, rw, in parts of at most 24 bytes, default `written while it is read`
        ///
        /// Called while a client writes it: once without bytes, when it begins, then with each part in turn.
        ///
        /// # Errors
        /// The abort code that the client is answered with.
        fn write_report(
            &mut self,
            od: &mut Dictionary,
            part: Part<'_>,
        ) -> Result<(), AbortCode>;
    }
    /// The device: its dictionary, the application behind it, and the memory that outlives power-off.
    #[derive(Clone, Debug)]
    pub struct Device<H, S = lexican_runtime::storage::NoStorage> {
        /// The dictionary.
        pub od: Dictionary,
        /// The application.
        pub handlers: H,
        /// The memory.
        pub storage: S,
    }
    impl<H> Device<H> {
        /// The device after power-on, without a memory; the node gives it its node-ID.
        #[must_use]
        pub const fn new(handlers: H) -> Self {
            Self::with_storage(handlers, lexican_runtime::storage::NoStorage)
        }
    }
    impl<H, S> Device<H, S> {
        /// The device after power-on; the node gives it its node-ID, and what is stored.
        #[must_use]
        pub const fn with_storage(handlers: H, storage: S) -> Self {
            Self {
                od: bytemuck::must_cast(resized::<SIZE>(POWER_ON)),
                handlers,
                storage,
            }
        }
    }
    impl<H: Handlers, S: lexican_runtime::storage::Storage> lexican_runtime::Device
    for Device<H, S> {
        type Buffer = [u8; 100];
        type Pdos = lexican_runtime::pdo::Pdos<2, 0, 3>;
        type Storage = S;
        type Watches = [lexican_runtime::heartbeat::Watch; 0];
        type Servers = [lexican_runtime::sdo::Channel<Self::Buffer>; 0];
        const SERVICES: ServiceSet = ServiceSet::of(&ROWS);
        const NUMBERS: NumberSet = NumberSet::of(&ROWS);
        #[inline]
        fn table(&self) -> Table<'_> {
            TABLE
        }
        #[inline]
        fn values(&self) -> &[u8] {
            bytemuck::bytes_of(&self.od)
        }
        #[inline]
        fn values_mut(&mut self) -> &mut [u8] {
            bytemuck::bytes_of_mut(&mut self.od)
        }
        #[inline]
        fn defaults(&self) -> &[u8] {
            POWER_ON
        }
        #[inline]
        fn buffer(&self) -> Self::Buffer {
            [0; 100]
        }
        #[inline]
        fn pdos(&self) -> Self::Pdos {
            Self::Pdos::EMPTY
        }
        #[inline]
        fn watches(&self) -> Self::Watches {
            [lexican_runtime::heartbeat::Watch::NOBODY; 0]
        }
        #[inline]
        fn servers(&self) -> Self::Servers {
            [lexican_runtime::sdo::Channel::IDLE; 0]
        }
        #[inline]
        fn storage(&mut self) -> Option<&mut S> {
            Some(&mut self.storage)
        }
        #[inline]
        fn event(&mut self, event: Event) {
            self.handlers.event(&mut self.od, event);
        }
        fn before_read(&mut self, address: Address) -> Result<(), AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                (0x2600, 0x00) => {
                    handlers.read_switch(od).map(|value| od.switch = value.into())
                }
                (0x2602, 0x00) => handlers.read_note(od).map(|value| od.note = value),
                (0x2604, 0x00) => handlers.read_clock(od).map(|value| od.clock = value),
                (0x2605, 0x00) => handlers.read_motto(od).map(|value| od.motto = value),
                (0x2606, sub @ 0x01..=0x02) => {
                    handlers
                        .read_switches(od, sub)
                        .map(|value| set_element(&mut od.switches, sub, value.into()))
                }
                (0x6004, 0x00) => {
                    handlers
                        .read_position_value(od)
                        .map(|value| od.position_value = value)
                }
                (0x6030, sub @ 0x01..=0x03) => {
                    handlers
                        .read_speed_value(od, sub)
                        .map(|value| set_element(&mut od.speed_value, sub, value))
                }
                _ => Ok(()),
            }
        }
        fn before_write(
            &mut self,
            address: Address,
            value: Value<'_>,
        ) -> Result<(), AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                (0x1010, sub @ 0x01) => {
                    handlers.write_store_parameters(od, sub, value.to_u32())
                }
                (0x2300, sub @ (0x01 | 0x03)) => {
                    handlers.write_limited_list(od, sub, value.to_i16())
                }
                (0x2600, 0x00) => handlers.write_switch(od, value.to_bool()),
                (0x2601, 0x00) => handlers.write_command(od, value.to_u8()),
                (0x2602, 0x00) => handlers.write_note(od, value.to_bytes()),
                (0x2604, 0x00) => handlers.write_clock(od, value.to_time()),
                (0x2606, sub @ 0x01..=0x02) => {
                    handlers.write_switches(od, sub, value.to_bool())
                }
                (0x6003, 0x00) => handlers.write_preset_value(od, value.to_u32()),
                _ => Ok(()),
            }
        }
        fn read_part(
            &mut self,
            address: Address,
            offset: usize,
            buffer: &mut [u8],
        ) -> Result<usize, AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                (0x2603, 0x00) => handlers.read_program(od, offset, buffer),
                (0x2607, 0x00) => handlers.read_report(od, offset, buffer),
                _ => Err(AbortCode::NO_DATA),
            }
        }
        fn write_part(
            &mut self,
            address: Address,
            part: Part<'_>,
        ) -> Result<(), AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                (0x2603, 0x00) => handlers.write_program(od, part),
                (0x2607, 0x00) => handlers.write_report(od, part),
                _ => Err(AbortCode::NOT_STORED),
            }
        }
    }
    /// Bytes of the values; the compiler refuses any other number.
    const SIZE: usize = 792;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };

    const TABLE: Table<'static> = Table {
        entries: &place::<422>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const WO: Access = Access::WRITE;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 143] = [
        Row::value(0x1000, 0x00, DataType::UNSIGNED32, CONST, 0),
        Row::value(0x1001, 0x00, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, error_register)),
        Row::value(0x1005, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cob_id_sync)),
        Row::value(0x1008, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 0),
        Row::value(0x1009, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 1),
        Row::value(0x100A, 0x00, DataType::VISIBLE_STRING, RO.with(Access::EXTRA), 2),
        Row::value(0x1010, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::value(0x1010, 0x01, DataType::UNSIGNED32, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, store_parameters)),
        Row::value(0x1014, 0x00, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, cob_id_emcy)),
        Row::value(0x1017, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, producer_heartbeat_time)),
        Row::value(0x1018, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::elements(0x1018, 0x01, 0x03, DataType::UNSIGNED32, CONST, 19),
        Row::value(0x1018, 0x04, DataType::UNSIGNED32, RO, offset_of!(Dictionary, identity_object_serial_number)),
        Row::value(0x1800, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x1800, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_communication_parameter_1800_cob_id_used_by_tpdo)),
        Row::value(0x1800, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_communication_parameter_1800_transmission_type)),
        Row::value(0x1800, 0x03, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_communication_parameter_1800_inhibit_time)),
        Row::value(0x1800, 0x05, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_communication_parameter_1800_event_timer)),
        Row::value(0x1801, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x1801, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_communication_parameter_1801_cob_id_used_by_tpdo)),
        Row::value(0x1801, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_communication_parameter_1801_transmission_type)),
        Row::value(0x1801, 0x03, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_communication_parameter_1801_inhibit_time)),
        Row::value(0x1801, 0x05, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_communication_parameter_1801_event_timer)),
        Row::value(0x1A00, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_mapping_parameter_number_of_mapped_objects)),
        Row::elements(0x1A00, 0x01, 0x03, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_mapping_parameter)),
        Row::value(0x2000, 0x00, DataType::BOOLEAN, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_boolean)),
        Row::value(0x2001, 0x00, DataType::INTEGER8, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_integer8)),
        Row::value(0x2002, 0x00, DataType::INTEGER16, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_integer16)),
        Row::value(0x2003, 0x00, DataType::INTEGER32, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_integer32)),
        Row::value(0x2004, 0x00, DataType::INTEGER24, RW, offset_of!(Dictionary, value_integer24)),
        Row::value(0x2005, 0x00, DataType::INTEGER40, RW, offset_of!(Dictionary, value_integer40)),
        Row::value(0x2006, 0x00, DataType::INTEGER48, RW, offset_of!(Dictionary, value_integer48)),
        Row::value(0x2007, 0x00, DataType::INTEGER56, RW, offset_of!(Dictionary, value_integer56)),
        Row::value(0x2008, 0x00, DataType::INTEGER64, RW, offset_of!(Dictionary, value_integer64)),
        Row::value(0x2009, 0x00, DataType::UNSIGNED8, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_unsigned8)),
        Row::value(0x200A, 0x00, DataType::UNSIGNED16, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_unsigned16)),
        Row::value(0x200B, 0x00, DataType::UNSIGNED32, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_unsigned32)),
        Row::value(0x200C, 0x00, DataType::UNSIGNED24, RW, offset_of!(Dictionary, value_unsigned24)),
        Row::value(0x200D, 0x00, DataType::UNSIGNED40, RW, offset_of!(Dictionary, value_unsigned40)),
        Row::value(0x200E, 0x00, DataType::UNSIGNED48, RW, offset_of!(Dictionary, value_unsigned48)),
        Row::value(0x200F, 0x00, DataType::UNSIGNED56, RW, offset_of!(Dictionary, value_unsigned56)),
        Row::value(0x2010, 0x00, DataType::UNSIGNED64, RW, offset_of!(Dictionary, value_unsigned64)),
        Row::value(0x2011, 0x00, DataType::REAL32, RW.with(Access::TPDO).with(Access::RPDO), offset_of!(Dictionary, value_real32)),
        Row::value(0x2012, 0x00, DataType::REAL64, RW, offset_of!(Dictionary, value_real64)),
        Row::value(0x2013, 0x00, DataType::VISIBLE_STRING, RW.with(Access::EXTRA), 3),
        Row::value(0x2014, 0x00, DataType::OCTET_STRING, RW.with(Access::EXTRA), 4),
        Row::value(0x2015, 0x00, DataType::UNICODE_STRING, RW.with(Access::EXTRA), 5),
        Row::value(0x2016, 0x00, DataType::TIME_OF_DAY, RW, offset_of!(Dictionary, value_time_of_day)),
        Row::value(0x2017, 0x00, DataType::TIME_DIFFERENCE, RW, offset_of!(Dictionary, value_time_difference)),
        Row::value(0x2018, 0x00, DataType::DOMAIN, RW.with(Access::EXTRA), 6),
        Row::value(0x2100, 0x00, DataType::BOOLEAN, CONST, 17),
        Row::value(0x2101, 0x00, DataType::INTEGER8, CONST, 32),
        Row::value(0x2102, 0x00, DataType::INTEGER16, CONST, 33),
        Row::value(0x2103, 0x00, DataType::INTEGER32, CONST, 35),
        Row::value(0x2104, 0x00, DataType::INTEGER24, CONST, 39),
        Row::value(0x2105, 0x00, DataType::INTEGER40, CONST, 43),
        Row::value(0x2106, 0x00, DataType::INTEGER48, CONST, 51),
        Row::value(0x2107, 0x00, DataType::INTEGER56, CONST, 59),
        Row::value(0x2108, 0x00, DataType::INTEGER64, CONST, 67),
        Row::value(0x2109, 0x00, DataType::UNSIGNED8, CONST, 75),
        Row::value(0x210A, 0x00, DataType::UNSIGNED16, CONST, 76),
        Row::value(0x210B, 0x00, DataType::UNSIGNED32, CONST, 78),
        Row::value(0x210C, 0x00, DataType::UNSIGNED24, CONST, 82),
        Row::value(0x210D, 0x00, DataType::UNSIGNED40, CONST, 86),
        Row::value(0x210E, 0x00, DataType::UNSIGNED48, CONST, 94),
        Row::value(0x210F, 0x00, DataType::UNSIGNED56, CONST, 102),
        Row::value(0x2110, 0x00, DataType::UNSIGNED64, CONST, 110),
        Row::value(0x2111, 0x00, DataType::REAL32, CONST, 118),
        Row::value(0x2112, 0x00, DataType::REAL64, CONST, 122),
        Row::value(0x2113, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 7),
        Row::value(0x2114, 0x00, DataType::OCTET_STRING, CONST.with(Access::EXTRA), 8),
        Row::value(0x2115, 0x00, DataType::UNICODE_STRING, CONST.with(Access::EXTRA), 9),
        Row::value(0x2116, 0x00, DataType::TIME_OF_DAY, RO, offset_of!(Dictionary, constant_time_of_day)),
        Row::value(0x2117, 0x00, DataType::TIME_DIFFERENCE, RO, offset_of!(Dictionary, constant_time_difference)),
        Row::value(0x2118, 0x00, DataType::DOMAIN, RO.with(Access::EXTRA), 10),
        Row::value(0x2200, 0x00, DataType::INTEGER8, RW.with(Access::EXTRA), 11),
        Row::value(0x2201, 0x00, DataType::INTEGER24, RW.with(Access::EXTRA), 12),
        Row::value(0x2202, 0x00, DataType::INTEGER40, RW.with(Access::EXTRA), 13),
        Row::value(0x2203, 0x00, DataType::UNSIGNED40, RW.with(Access::EXTRA), 14),
        Row::value(0x2204, 0x00, DataType::REAL32, RW.with(Access::EXTRA), 15),
        Row::value(0x2205, 0x00, DataType::REAL64, RW.with(Access::EXTRA), 16),
        Row::value(0x2206, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, limited_unsigned16)),
        Row::value(0x2207, 0x00, DataType::BOOLEAN, RW.with(Access::EXTRA), 17),
        Row::value(0x2300, 0x00, DataType::UNSIGNED8, CONST, 215),
        Row::value(0x2300, 0x01, DataType::INTEGER16, RW.with(Access::EXTRA).with(Access::WRITE_HANDLER), 18),
        Row::value(0x2300, 0x02, DataType::INTEGER16, RW.with(Access::EXTRA), 19),
        Row::value(0x2300, 0x03, DataType::INTEGER16, RW.with(Access::EXTRA).with(Access::WRITE_HANDLER), 20),
        Row::value(0x2301, 0x00, DataType::UNSIGNED8, CONST, 228),
        Row::elements(0x2301, 0x01, 0xFE, DataType::UNSIGNED8, RW, offset_of!(Dictionary, long_list)),
        Row::value(0x2302, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x2302, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, list_with_a_gap_element_1)),
        Row::value(0x2302, 0x02, DataType::UNSIGNED16, RW, offset_of!(Dictionary, list_with_a_gap_element_2)),
        Row::value(0x2302, 0x04, DataType::UNSIGNED16, RW, offset_of!(Dictionary, list_with_a_gap_element_4)),
        Row::value(0x2303, 0x00, DataType::UNSIGNED8, CONST, 229),
        Row::elements(0x2303, 0x01, 0x02, DataType::VISIBLE_STRING, RW.with(Access::EXTRA), 21),
        Row::value(0x2304, 0x00, DataType::UNSIGNED8, CONST, 229),
        Row::value(0x2304, 0x01, DataType::INTEGER32, CONST, 78),
        Row::value(0x2304, 0x02, DataType::INTEGER32, CONST, 230),
        Row::value(0x2305, 0x00, DataType::UNSIGNED8, CONST, 229),
        Row::elements(0x2305, 0x01, 0x02, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 23),
        Row::value(0x2400, 0x00, DataType::UNSIGNED8, RW.with(Access::NODE_ID), offset_of!(Dictionary, formula_unsigned8)),
        Row::value(0x2401, 0x00, DataType::UNSIGNED16, RW.with(Access::NODE_ID), offset_of!(Dictionary, formula_unsigned16)),
        Row::value(0x2402, 0x00, DataType::INTEGER16, RW.with(Access::NODE_ID), offset_of!(Dictionary, formula_integer16)),
        Row::value(0x2403, 0x00, DataType::UNSIGNED24, RW.with(Access::NODE_ID), offset_of!(Dictionary, formula_unsigned24)),
        Row::value(0x2404, 0x00, DataType::UNSIGNED64, RW.with(Access::NODE_ID), offset_of!(Dictionary, formula_unsigned64)),
        Row::value(0x2405, 0x00, DataType::UNSIGNED8, CONST, 229),
        Row::value(0x2405, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, formula_list)),
        Row::value(0x2405, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, formula_list) + 4),
        Row::value(0x2500, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, type_)),
        Row::value(0x2501, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, self_)),
        Row::value(0x2502, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, object_2nd_value)),
        Row::value(0x2503, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, object_2503)),
        Row::value(0x2504, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, object_2504)),
        Row::value(0x2505, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, grosse_u)),
        Row::value(0x2506, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, su_du)),
        Row::value(0x2507, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, twin_2507)),
        Row::value(0x2508, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, twin_2508)),
        Row::value(0x2509, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, a_b_c_x_b_q_c_https_example_com)),
        Row::value(0x250A, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, very_long_name_very_long_name_very_long_name_very_long_name_250a)),
        Row::value(0x250B, 0x00, DataType::UNSIGNED32, CONST, 240),
        Row::value(0x250C, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, object_250c)),
        Row::value(0x250D, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, underscore)),
        Row::value(0x250E, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, twin_2509)),
        Row::value(0x250F, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, pdos_of_ids)),
        Row::value(0x2510, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, dictionary_value)),
        Row::value(0x2520, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x2520, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, record_of_twins_twin_sub1)),
        Row::value(0x2520, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, record_of_twins_twin_sub2)),
        Row::value(0x2520, 0x03, DataType::UNSIGNED32, RW, offset_of!(Dictionary, record_of_twins_sub3)),
        Row::value(0x2520, 0x04, DataType::UNSIGNED32, RW, offset_of!(Dictionary, record_of_twins_own)),
        Row::value(0x2600, 0x00, DataType::BOOLEAN, RW.with(Access::READ_HANDLER).with(Access::WRITE_HANDLER), offset_of!(Dictionary, switch)),
        Row::value(0x2601, 0x00, DataType::UNSIGNED8, WO.with(Access::EXTRA).with(Access::WRITE_HANDLER), 25),
        Row::value(0x2602, 0x00, DataType::VISIBLE_STRING, RW.with(Access::EXTRA).with(Access::READ_HANDLER).with(Access::WRITE_HANDLER), 26),
        Row::value(0x2603, 0x00, DataType::DOMAIN, RW.with(Access::CONSTANT).with(Access::PARTS), 0),
        Row::value(0x2604, 0x00, DataType::TIME_OF_DAY, RW.with(Access::READ_HANDLER).with(Access::WRITE_HANDLER), offset_of!(Dictionary, clock)),
        Row::value(0x2605, 0x00, DataType::VISIBLE_STRING, RO.with(Access::EXTRA).with(Access::READ_HANDLER), 27),
        Row::value(0x2606, 0x00, DataType::UNSIGNED8, CONST, 229),
        Row::elements(0x2606, 0x01, 0x02, DataType::BOOLEAN, RW.with(Access::READ_HANDLER).with(Access::WRITE_HANDLER), offset_of!(Dictionary, switches)),
        Row::value(0x2607, 0x00, DataType::VISIBLE_STRING, RW.with(Access::CONSTANT).with(Access::PARTS), 0),
        Row::value(0x6003, 0x00, DataType::UNSIGNED32, RW.with(Access::EXTRA).with(Access::WRITE_HANDLER), 28),
        Row::value(0x6004, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO).with(Access::READ_HANDLER), offset_of!(Dictionary, position_value)),
        Row::value(0x6030, 0x00, DataType::UNSIGNED8, CONST, 215),
        Row::elements(0x6030, 0x01, 0x03, DataType::INTEGER16, RO.with(Access::TPDO).with(Access::READ_HANDLER), offset_of!(Dictionary, speed_value)),
    ];

    #[rustfmt::skip]
    const SEEDS: [u16; 135] = [
        34, 16, 2, 0, 0, 15, 7, 9, 3, 0, 4, 2, 3, 79, 1, 0,
        0, 38, 2, 8, 20, 10, 80, 47, 2, 2, 0, 0, 1, 4, 9, 1,
        1, 1, 115, 6, 3, 0, 1, 24, 10, 4, 10, 0, 0, 1, 34, 11,
        0, 34, 0, 1, 3, 18, 12, 0, 14, 2, 15, 65, 4, 11, 1, 21,
        4, 47, 1, 0, 1, 8, 4, 4, 50, 0, 15, 13, 148, 33, 31, 0,
        0, 57, 6, 6, 1, 223, 1, 4, 1, 1, 1, 1, 0, 7, 0, 23,
        15, 4, 0, 9, 65, 91, 0, 70, 4, 17, 149, 431, 2, 9, 195, 193,
        2, 32, 398, 3, 33, 38, 246, 2, 16, 14, 273, 316, 231, 12, 15, 10,
        26, 7, 19, 0, 0, 7, 90,
    ];

    #[rustfmt::skip]
    const EXTRAS: [Extra; 29] = [
        Extra::new(4, 10), // 1008sub0
        Extra::new(14, 3), // 1009sub0
        Extra::new(offset_of!(Dictionary, manufacturer_software_version), 32), // 100Asub0
        Extra::new(offset_of!(Dictionary, value_visible_string), 20), // 2013sub0
        Extra::new(offset_of!(Dictionary, value_octet_string), 3), // 2014sub0
        Extra::new(offset_of!(Dictionary, value_unicode_string), 10), // 2015sub0
        Extra::new(offset_of!(Dictionary, value_domain), 32), // 2018sub0
        Extra::new(130, 4), // 2113sub0
        Extra::new(134, 3), // 2114sub0
        Extra::new(137, 10), // 2115sub0
        Extra::new(offset_of!(Dictionary, constant_domain), 32), // 2118sub0
        Extra::new(offset_of!(Dictionary, limited_integer8), 147), // 2200sub0
        Extra::new(offset_of!(Dictionary, limited_integer24), 149), // 2201sub0
        Extra::new(offset_of!(Dictionary, limited_integer40), 157), // 2202sub0
        Extra::new(offset_of!(Dictionary, limited_unsigned40), 173), // 2203sub0
        Extra::new(offset_of!(Dictionary, limited_real32), 189), // 2204sub0
        Extra::new(offset_of!(Dictionary, limited_real64), 197), // 2205sub0
        Extra::new(offset_of!(Dictionary, limited_boolean), 213), // 2207sub0
        Extra::new(offset_of!(Dictionary, limited_list), 216), // 2300sub1
        Extra::new(offset_of!(Dictionary, limited_list) + 2, 220), // 2300sub2
        Extra::new(offset_of!(Dictionary, limited_list) + 4, 224), // 2300sub3
        Extra::new(offset_of!(Dictionary, list_of_texts), 6), // 2303sub1
        Extra::new(offset_of!(Dictionary, list_of_texts) + 8, 6), // 2303sub2
        Extra::new(234, 3), // 2305sub1
        Extra::new(237, 3), // 2305sub2
        Extra::new(offset_of!(Dictionary, command), 244), // 2601sub0
        Extra::new(offset_of!(Dictionary, note), 3), // 2602sub0
        Extra::new(offset_of!(Dictionary, motto), 23), // 2605sub0
        Extra::new(offset_of!(Dictionary, preset_value), 246), // 6003sub0
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 254] = [
        0x96, 0x01, 0x02, 0x00, // 1000sub0
        0x45, 0x76, 0x65, 0x72, 0x79, 0x20, 0x6B, 0x69, 0x6E, 0x64, // 1008sub0
        0x31, 0x2E, 0x30, // 1009sub0
        0x01, // 1010sub0
        0x04, // 1018sub0
        0x78, 0x56, 0x34, 0x12, // 1018sub1
        0x01, 0x00, 0x00, 0x00, // 1018sub2
        0x01, 0x00, 0x01, 0x00, // 1018sub3
        0x05, // 1800sub0
        0xFB, // 2101sub0
        0xD4, 0xFE, // 2102sub0
        0x90, 0xEE, 0xFE, 0xFF, // 2103sub0
        0x00, 0x00, 0x80, 0xFF, // 2104sub0
        0x00, 0x00, 0x00, 0x00, 0x80, 0xFF, 0xFF, 0xFF, // 2105sub0
        0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0xFF, 0xFF, // 2106sub0
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0xFF, // 2107sub0
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, // 2108sub0
        0xFF, // 2109sub0
        0xFF, 0xFF, // 210Asub0
        0xFF, 0xFF, 0xFF, 0xFF, // 210Bsub0
        0xFF, 0xFF, 0xFF, 0x00, // 210Csub0
        0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x00, // 210Dsub0
        0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, // 210Esub0
        0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, // 210Fsub0
        0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, // 2110sub0
        0xC3, 0xF5, 0x48, 0x40, // 2111sub0
        0x69, 0x57, 0x14, 0x8B, 0x0A, 0xBF, 0x05, 0x40, // 2112sub0
        0x74, 0x65, 0x78, 0x74, // 2113sub0
        0x01, 0x02, 0xFF, // 2114sub0
        0x47, 0x00, 0x72, 0x00, 0xF6, 0x00, 0xDF, 0x00, 0x65, 0x00, // 2115sub0
        0xF6, 0x0A, // limits of 2200sub0
        0x9C, 0xFF, 0xFF, 0xFF, 0x64, 0x00, 0x00, 0x00, // limits of 2201sub0
        0x18, 0xFC, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F, 0x00, 0x00, 0x00, // limits of 2202sub0
        0x00, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0x00, 0x00, 0x00, // limits of 2203sub0
        0x00, 0x00, 0x00, 0x3F, 0x00, 0x00, 0x00, 0x40, // limits of 2204sub0
        0x9C, 0x75, 0x00, 0x88, 0x3C, 0xE4, 0x37, 0xFE, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xF0, 0x7F, // limits of 2205sub0
        0x01, 0x01, // limits of 2207sub0
        0x03, // 2300sub0
        0xF6, 0xFF, 0x0A, 0x00, // limits of 2300sub1
        0xF6, 0xFF, 0x14, 0x00, // limits of 2300sub2
        0xF6, 0xFF, 0x1E, 0x00, // limits of 2300sub3
        0xFE, // 2301sub0
        0x02, // 2303sub0
        0x02, 0x00, 0x00, 0x00, // 2304sub2
        0x6F, 0x6E, 0x65, // 2305sub1
        0x74, 0x77, 0x6F, // 2305sub2
        0x00, 0x00, 0x00, 0x00, // 250Bsub0
        0x00, 0x03, // limits of 2601sub0
        0x00, 0x00, 0x00, 0x00, 0x00, 0x10, 0x00, 0x00, // limits of 6003sub0
    ];
}
