pub mod wdga_configured {
    //! Object dictionary of `WDGA`, generated from `wdga.dcf`. Do not edit.
    //!
    //! * Vendor: `Wachendorff Automation`
    //! * Order code: `WDGA`
    //! * Description: `Absolute multiturn encoder WDGA, configured`
    //! * Configured for node-ID 1
    //! * 228 values of 93 objects; 600 bytes of RAM
    use core::mem::offset_of;
    use lexican_runtime::{AbortCode, Address, Event, NodeId, bytemuck};
    use lexican_runtime::od::{
        Access, DataType, Extra, NumberSet, Row, ServiceSet, Table, Value, VisibleString,
        place, resized, written,
    };
    /// The values of the dictionary: first those that are not 0 after power-on, and of both kinds the widest first.
    #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
    #[bytemuck(crate = "::lexican_runtime::bytemuck")]
    #[repr(C)]
    pub struct Dictionary {
        /// 1005h `COB-ID SYNC message`, `UNSIGNED32`, rw, default `0x0000_0080`
        pub cob_id_sync_message: u32,
        /// 1010sub1 to 1010sub4 `Store parameters`, `UNSIGNED32`, rw, default `0x0000_0001`
        ///
        /// * `[0]`: `Save all parameters`
        /// * `[1]`: `Save communication parameters`
        /// * `[2]`: `Save application parameters`
        /// * `[3]`: `Save manufacturer parameters`
        pub store_parameters: [u32; 4],
        /// 1011sub1 to 1011sub4 `Restore default parameters`, `UNSIGNED32`, rw, default `0x0000_0001`
        ///
        /// * `[0]`: `Restore all parameters`
        /// * `[1]`: `Restore communication parameters`
        /// * `[2]`: `Restore application parameters`
        /// * `[3]`: `Restore manufacturer parameters`
        pub restore_default_parameters: [u32; 4],
        /// 1014h `COB-ID emergency message`, `UNSIGNED32`, rw, default `$NODEID+0x80`
        pub cob_id_emergency_message: u32,
        /// 1800sub1 `TPDO 1 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x40000180`
        pub tpdo_1_communication_cob_id: u32,
        /// 1801sub1 `TPDO 2 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x40000280`
        pub tpdo_2_communication_cob_id: u32,
        /// 1802sub1 `TPDO 3 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x40000380`
        pub tpdo_3_communication_cob_id: u32,
        /// 1803sub1 `TPDO 4 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x40000480`
        pub tpdo_4_communication_cob_id: u32,
        /// 1A00sub1 to 1A00sub8 `TPDO 1 mapping`, `UNSIGNED32`, rw
        ///
        /// * `[0]`: `Mapped object 1`, default `0x6004_0020`
        /// * `[1]`: `Mapped object 2`, default `0x0000_0000`
        /// * `[2]`: `Mapped object 3`, default `0x0000_0000`
        /// * `[3]`: `Mapped object 4`, default `0x0000_0000`
        /// * `[4]`: `Mapped object 5`, default `0x0000_0000`
        /// * `[5]`: `Mapped object 6`, default `0x0000_0000`
        /// * `[6]`: `Mapped object 7`, default `0x0000_0000`
        /// * `[7]`: `Mapped object 8`, default `0x0000_0000`
        pub tpdo_1_mapping: [u32; 8],
        /// 1A01sub1 to 1A01sub8 `TPDO 2 mapping`, `UNSIGNED32`, rw
        ///
        /// * `[0]`: `Mapped object 1`, default `0x6004_0020`
        /// * `[1]`: `Mapped object 2`, default `0x0000_0000`
        /// * `[2]`: `Mapped object 3`, default `0x0000_0000`
        /// * `[3]`: `Mapped object 4`, default `0x0000_0000`
        /// * `[4]`: `Mapped object 5`, default `0x0000_0000`
        /// * `[5]`: `Mapped object 6`, default `0x0000_0000`
        /// * `[6]`: `Mapped object 7`, default `0x0000_0000`
        /// * `[7]`: `Mapped object 8`, default `0x0000_0000`
        pub tpdo_2_mapping: [u32; 8],
        /// 1A02sub1 to 1A02sub8 `TPDO 3 mapping`, `UNSIGNED32`, rw
        ///
        /// * `[0]`: `Mapped object 1`, default `0x6008_0040`
        /// * `[1]`: `Mapped object 2`, default `0x0000_0000`
        /// * `[2]`: `Mapped object 3`, default `0x0000_0000`
        /// * `[3]`: `Mapped object 4`, default `0x0000_0000`
        /// * `[4]`: `Mapped object 5`, default `0x0000_0000`
        /// * `[5]`: `Mapped object 6`, default `0x0000_0000`
        /// * `[6]`: `Mapped object 7`, default `0x0000_0000`
        /// * `[7]`: `Mapped object 8`, default `0x0000_0000`
        pub tpdo_3_mapping: [u32; 8],
        /// 2105sub2 `Integration value`, `Speed integration time`, `UNSIGNED32`, rw, default `1000`
        pub integration_value_speed_integration_time: u32,
        /// 2120sub1 to 2120sub8 `Customer EEPROM area`, `UNSIGNED32`, rw, default `4_294_967_295`
        pub customer_eeprom_area: [u32; 8],
        /// 6001h `Measuring units per revolution`, `UNSIGNED32`, rw, at least `1`, default `16384`
        pub measuring_units_per_revolution: u32,
        /// 6402sub1 `Work area high limit`, `INTEGER32`, rw, default `16384`
        pub work_area_high_limit: [i32; 1],
        /// 1017h `Producer heartbeat time`, `UNSIGNED16` in ms, rw, configured as `1000`
        pub producer_heartbeat_time: u16,
        /// 1800sub5 `TPDO 1 communication`, `Event timer`, `UNSIGNED16` in ms, rw, configured as `100`
        pub tpdo_1_communication_event_timer: u16,
        /// 2106sub1 to 2106sub2 `Speed scaling`, `UNSIGNED16`, rw, default `1`
        ///
        /// * `[0]`: `Speed multiplier`
        /// * `[1]`: `Speed divisor`
        pub speed_scaling: [u16; 2],
        /// 2107h `Frequency limit`, `UNSIGNED16`, rw, `1` to `65535`, default `65535`
        pub frequency_limit: u16,
        /// 2500sub2 `Temperature`, `Upper limit`, `INTEGER16`, rwr, `-40` to `100`, default `100`, PDO-mappable
        pub temperature_upper_limit: i16,
        /// 2500sub3 `Temperature`, `Lower limit`, `INTEGER16`, rwr, `-40` to `100`, default `-40`, PDO-mappable
        pub temperature_lower_limit: i16,
        /// 6000h `Operating parameters`, `UNSIGNED16`, rw, default `4`
        pub operating_parameters: u16,
        /// 6200h `Cyclic timer`, `UNSIGNED16`, rw, default `1`
        pub cyclic_timer: u16,
        /// 1800sub2 `TPDO 1 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_1_communication_transmission_type: u8,
        /// 1801sub2 `TPDO 2 communication`, `Transmission type`, `UNSIGNED8`, rw, default `1`
        pub tpdo_2_communication_transmission_type: u8,
        /// 1802sub2 `TPDO 3 communication`, `Transmission type`, `UNSIGNED8`, rw, default `1`
        pub tpdo_3_communication_transmission_type: u8,
        /// 1803sub2 `TPDO 4 communication`, `Transmission type`, `UNSIGNED8`, rw, default `1`
        pub tpdo_4_communication_transmission_type: u8,
        /// 1A00sub0 `TPDO 1 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `1`
        pub tpdo_1_mapping_number_of_mapped_objects: u8,
        /// 1A01sub0 `TPDO 2 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `1`
        pub tpdo_2_mapping_number_of_mapped_objects: u8,
        /// 1A02sub0 `TPDO 3 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `1`
        pub tpdo_3_mapping_number_of_mapped_objects: u8,
        /// 2100h `Baud rate`, `UNSIGNED8`, rw, `0` to `9`, default `9`
        pub baud_rate: u8,
        /// 2101h `Node-ID`, `UNSIGNED8`, rw, `1` to `127`, default `127`
        pub node_id: u8,
        /// 2105sub1 `Integration value`, `Position filter`, `UNSIGNED8`, rw, `1` to `4`, default `1`
        pub integration_value_position_filter: u8,
        /// 2504sub0 `Warning history`, `Highest sub-index supported`, `UNSIGNED8`, rw, default `5`
        pub warning_history_highest_sub_index_supported: u8,
        _gap: [u8; 7],
        /// 6008h `High precision position value`, `UNSIGNED64`, ro, PDO-mappable
        pub high_precision_position_value: u64,
        /// 6009h `High precision preset value`, `UNSIGNED64`, rw, default `0`
        pub high_precision_preset_value: u64,
        /// 1002h `Manufacturer status register`, `UNSIGNED32`, ro, default `0x0000_0000`, PDO-mappable
        pub manufacturer_status_register: u32,
        /// 1003sub1 to 1003sub5 `Predefined error field`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub predefined_error_field: [u32; 5],
        /// 1016sub1 `Consumer heartbeat time`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub consumer_heartbeat_time: [u32; 1],
        /// 1018sub4 `Identity`, `Serial number`, `UNSIGNED32`, const
        pub identity_serial_number: u32,
        /// 1020sub1 to 1020sub2 `Verify configuration`, `UNSIGNED32`, rw, default `0x0000_0000`
        ///
        /// * `[0]`: `Configuration date`
        /// * `[1]`: `Configuration time`
        pub verify_configuration: [u32; 2],
        /// 1A03sub1 to 1A03sub8 `TPDO 4 mapping`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub tpdo_4_mapping: [u32; 8],
        /// 1F80h `NMT start-up behaviour`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub nmt_start_up_behaviour: u32,
        /// 2502sub1 to 2502sub5 `Error history`, `UNSIGNED32`, ro
        pub error_history: [u32; 5],
        /// 6002h `Total measuring range`, `UNSIGNED32`, rw
        pub total_measuring_range: u32,
        /// 6003h `Preset value`, `UNSIGNED32`, rw, default `0`
        pub preset_value: u32,
        /// 6004h `Position value`, `UNSIGNED32`, ro, PDO-mappable
        pub position_value: u32,
        /// 6310sub1 `Cam 1 low limit`, `INTEGER32`, rw, default `0`
        pub cam_1_low_limit: [i32; 1],
        /// 6311sub1 `Cam 2 low limit`, `INTEGER32`, rw, default `0`
        pub cam_2_low_limit: [i32; 1],
        /// 6312sub1 `Cam 3 low limit`, `INTEGER32`, rw, default `0`
        pub cam_3_low_limit: [i32; 1],
        /// 6313sub1 `Cam 4 low limit`, `INTEGER32`, rw, default `0`
        pub cam_4_low_limit: [i32; 1],
        /// 6314sub1 `Cam 5 low limit`, `INTEGER32`, rw, default `0`
        pub cam_5_low_limit: [i32; 1],
        /// 6315sub1 `Cam 6 low limit`, `INTEGER32`, rw, default `0`
        pub cam_6_low_limit: [i32; 1],
        /// 6316sub1 `Cam 7 low limit`, `INTEGER32`, rw, default `0`
        pub cam_7_low_limit: [i32; 1],
        /// 6317sub1 `Cam 8 low limit`, `INTEGER32`, rw, default `0`
        pub cam_8_low_limit: [i32; 1],
        /// 6320sub1 `Cam 1 high limit`, `INTEGER32`, rw, default `0`
        pub cam_1_high_limit: [i32; 1],
        /// 6321sub1 `Cam 2 high limit`, `INTEGER32`, rw, default `0`
        pub cam_2_high_limit: [i32; 1],
        /// 6322sub1 `Cam 3 high limit`, `INTEGER32`, rw, default `0`
        pub cam_3_high_limit: [i32; 1],
        /// 6323sub1 `Cam 4 high limit`, `INTEGER32`, rw, default `0`
        pub cam_4_high_limit: [i32; 1],
        /// 6324sub1 `Cam 5 high limit`, `INTEGER32`, rw, default `0`
        pub cam_5_high_limit: [i32; 1],
        /// 6325sub1 `Cam 6 high limit`, `INTEGER32`, rw, default `0`
        pub cam_6_high_limit: [i32; 1],
        /// 6326sub1 `Cam 7 high limit`, `INTEGER32`, rw, default `0`
        pub cam_7_high_limit: [i32; 1],
        /// 6327sub1 `Cam 8 high limit`, `INTEGER32`, rw, default `0`
        pub cam_8_high_limit: [i32; 1],
        /// 6330sub1 `Cam 1 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_1_hysteresis: [u32; 1],
        /// 6331sub1 `Cam 2 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_2_hysteresis: [u32; 1],
        /// 6332sub1 `Cam 3 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_3_hysteresis: [u32; 1],
        /// 6333sub1 `Cam 4 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_4_hysteresis: [u32; 1],
        /// 6334sub1 `Cam 5 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_5_hysteresis: [u32; 1],
        /// 6335sub1 `Cam 6 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_6_hysteresis: [u32; 1],
        /// 6336sub1 `Cam 7 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_7_hysteresis: [u32; 1],
        /// 6337sub1 `Cam 8 hysteresis`, `UNSIGNED32`, rw, default `0`
        pub cam_8_hysteresis: [u32; 1],
        /// 6401sub1 `Work area low limit`, `INTEGER32`, rw, default `0`
        pub work_area_low_limit: [i32; 1],
        /// 6509h `Offset value`, `INTEGER32`, ro, default `0`
        pub offset_value: i32,
        /// 650Asub2 `Module identification`, `Minimum position`, `INTEGER32`, const
        pub module_identification_minimum_position: i32,
        /// 650Asub3 `Module identification`, `Maximum position`, `INTEGER32`, const
        pub module_identification_maximum_position: i32,
        /// 650Bsub1 `Serial number`, `UNSIGNED32`, const
        pub serial_number: [u32; 1],
        /// 100Ch `Guard time`, `UNSIGNED16` in ms, rw, default `0`
        pub guard_time: u16,
        /// 1015h `Inhibit time emergency message`, `UNSIGNED16` in multiples of 100 µs, rw, default `0`
        pub inhibit_time_emergency_message: u16,
        /// 1801sub5 `TPDO 2 communication`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        pub tpdo_2_communication_event_timer: u16,
        /// 1802sub5 `TPDO 3 communication`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        pub tpdo_3_communication_event_timer: u16,
        /// 1803sub5 `TPDO 4 communication`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        pub tpdo_4_communication_event_timer: u16,
        /// 2500sub1 `Temperature`, `Current`, `INTEGER16`, ro, PDO-mappable
        pub temperature_current: i16,
        /// 2500sub4 `Temperature`, `Maximum`, `INTEGER16`, ro, PDO-mappable
        pub temperature_maximum: i16,
        /// 2500sub5 `Temperature`, `Minimum`, `INTEGER16`, ro, PDO-mappable
        pub temperature_minimum: i16,
        /// 2503sub1 to 2503sub5 `Alarm history`, `UNSIGNED16`, ro
        pub alarm_history: [u16; 5],
        /// 2504sub1 to 2504sub5 `Warning history`, `UNSIGNED16`, ro
        pub warning_history: [u16; 5],
        /// 6030sub1 `Speed value`, `INTEGER16`, ro, PDO-mappable
        pub speed_value: [i16; 1],
        /// 6040sub1 `Acceleration value`, `INTEGER16`, ro, PDO-mappable
        pub acceleration_value: [i16; 1],
        /// 6050sub1 `Jerk value`, `INTEGER16`, ro, PDO-mappable
        pub jerk_value: [i16; 1],
        /// 6500h `Operating status`, `UNSIGNED16`, ro
        pub operating_status: u16,
        /// 6503h `Alarms`, `UNSIGNED16`, ro, default `0`, PDO-mappable
        pub alarms: u16,
        /// 6505h `Warnings`, `UNSIGNED16`, ro, default `0`, PDO-mappable
        pub warnings: u16,
        /// 1001h `Error register`, `UNSIGNED8`, ro, default `0`, PDO-mappable
        pub error_register: u8,
        /// 1003sub0 `Predefined error field`, `Number of errors`, `UNSIGNED8`, rw, default `0`
        pub predefined_error_field_number_of_errors: u8,
        /// 1009h `Manufacturer hardware version`, `VISIBLE_STRING`, const, at most 32 bytes
        pub manufacturer_hardware_version: VisibleString<32>,
        /// 100Ah `Manufacturer software version`, `VISIBLE_STRING`, const, at most 32 bytes
        pub manufacturer_software_version: VisibleString<32>,
        /// 100Dh `Life time factor`, `UNSIGNED8`, rw, default `0`
        pub life_time_factor: u8,
        /// 1029sub1 to 1029sub2 `Error behaviour`, `UNSIGNED8`, rw, `0` to `2`, default `0`
        ///
        /// * `[0]`: `Communication error`
        /// * `[1]`: `Encoder error`
        pub error_behaviour: [u8; 2],
        /// 1A03sub0 `TPDO 4 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `0`
        pub tpdo_4_mapping_number_of_mapped_objects: u8,
        /// 2103h `Bus-off auto-reset`, `UNSIGNED8`, rw, default `0`
        pub bus_off_auto_reset: u8,
        /// 6300sub1 `Cam state register`, `UNSIGNED8`, ro, default `0`, PDO-mappable
        pub cam_state_register: [u8; 1],
        /// 6301sub1 `Cam enable register`, `UNSIGNED8`, rw, default `0`
        pub cam_enable_register: [u8; 1],
        /// 6302sub1 `Cam polarity register`, `UNSIGNED8`, rw, default `0`
        pub cam_polarity_register: [u8; 1],
        /// 6400sub1 `Area state register`, `UNSIGNED8`, ro, PDO-mappable
        pub area_state_register: [u8; 1],
        _padding: [u8; 1],
    }
    impl Dictionary {
        /// 1000h `Device type`, `UNSIGNED32`, const
        pub const DEVICE_TYPE: u32 = 0x0002_0196;
        /// 1008h `Manufacturer device name`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_DEVICE_NAME: &'static str = "WDGA-MT-CO";
        /// 1010sub0 `Store parameters`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const STORE_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1011sub0 `Restore default parameters`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const RESTORE_DEFAULT_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1016sub0 `Consumer heartbeat time`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CONSUMER_HEARTBEAT_TIME_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 1018sub0 `Identity`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const IDENTITY_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1018sub1 `Identity`, `Vendor-ID`, `UNSIGNED32`, const
        pub const IDENTITY_VENDOR_ID: u32 = 0x0100_021F;
        /// 1018sub2 `Identity`, `Product code`, `UNSIGNED32`, const
        pub const IDENTITY_PRODUCT_CODE: u32 = 0x5744_4741;
        /// 1018sub3 `Identity`, `Revision number`, `UNSIGNED32`, const
        pub const IDENTITY_REVISION_NUMBER: u32 = 0x0306_0208;
        /// 1020sub0 `Verify configuration`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const VERIFY_CONFIGURATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1029sub0 `Error behaviour`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const ERROR_BEHAVIOUR_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1800sub0 `TPDO 1 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_1_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 1801sub0 `TPDO 2 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_2_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 1802sub0 `TPDO 3 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_3_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 1803sub0 `TPDO 4 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_4_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 2105sub0 `Integration value`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const INTEGRATION_VALUE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 2106sub0 `Speed scaling`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SPEED_SCALING_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 2120sub0 `Customer EEPROM area`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CUSTOMER_EEPROM_AREA_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 8;
        /// 2500sub0 `Temperature`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TEMPERATURE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 2502sub0 `Error history`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const ERROR_HISTORY_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 2503sub0 `Alarm history`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const ALARM_HISTORY_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 6030sub0 `Speed value`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const SPEED_VALUE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6040sub0 `Acceleration value`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const ACCELERATION_VALUE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6050sub0 `Jerk value`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const JERK_VALUE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6300sub0 `Cam state register`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const CAM_STATE_REGISTER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6301sub0 `Cam enable register`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const CAM_ENABLE_REGISTER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6302sub0 `Cam polarity register`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const CAM_POLARITY_REGISTER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6310sub0 `Cam 1 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_1_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6311sub0 `Cam 2 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_2_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6312sub0 `Cam 3 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_3_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6313sub0 `Cam 4 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_4_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6314sub0 `Cam 5 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_5_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6315sub0 `Cam 6 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_6_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6316sub0 `Cam 7 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_7_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6317sub0 `Cam 8 low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_8_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6320sub0 `Cam 1 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_1_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6321sub0 `Cam 2 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_2_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6322sub0 `Cam 3 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_3_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6323sub0 `Cam 4 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_4_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6324sub0 `Cam 5 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_5_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6325sub0 `Cam 6 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_6_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6326sub0 `Cam 7 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_7_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6327sub0 `Cam 8 high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_8_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6330sub0 `Cam 1 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_1_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6331sub0 `Cam 2 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_2_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6332sub0 `Cam 3 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_3_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6333sub0 `Cam 4 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_4_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6334sub0 `Cam 5 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_5_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6335sub0 `Cam 6 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_6_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6336sub0 `Cam 7 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_7_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6337sub0 `Cam 8 hysteresis`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const CAM_8_HYSTERESIS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6400sub0 `Area state register`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const AREA_STATE_REGISTER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6401sub0 `Work area low limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const WORK_AREA_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6402sub0 `Work area high limit`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const WORK_AREA_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6501h `Singleturn resolution`, `UNSIGNED32`, const
        pub const SINGLETURN_RESOLUTION: u32 = 16384;
        /// 6502h `Number of distinguishable revolutions`, `UNSIGNED16`, const
        pub const NUMBER_OF_DISTINGUISHABLE_REVOLUTIONS: u16 = 65535;
        /// 6504h `Supported alarms`, `UNSIGNED16`, const
        pub const SUPPORTED_ALARMS: u16 = 1;
        /// 6506h `Supported warnings`, `UNSIGNED16`, const
        pub const SUPPORTED_WARNINGS: u16 = 28673;
        /// 6507h `Profile and software version`, `UNSIGNED32`, const
        pub const PROFILE_AND_SOFTWARE_VERSION: u32 = 17_105_666;
        /// 6508h `Operating time`, `UNSIGNED32`, const
        pub const OPERATING_TIME: u32 = 4_294_967_295;
        /// 650Asub0 `Module identification`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const MODULE_IDENTIFICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// 650Asub1 `Module identification`, `Offset value`, `INTEGER32`, const
        pub const MODULE_IDENTIFICATION_OFFSET_VALUE: i32 = 0;
        /// 650Bsub0 `Serial number`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SERIAL_NUMBER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6510h `Number of high precision revolutions`, `UNSIGNED40`, const
        pub const NUMBER_OF_HIGH_PRECISION_REVOLUTIONS: u64 = 549_755_813_888;
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            cob_id_sync_message: 0x0000_0080,
            store_parameters: [0x0000_0001; 4],
            restore_default_parameters: [0x0000_0001; 4],
            cob_id_emergency_message: 0x0000_0080,
            tpdo_1_communication_cob_id: 0x4000_0180,
            tpdo_2_communication_cob_id: 0x4000_0280,
            tpdo_3_communication_cob_id: 0x4000_0380,
            tpdo_4_communication_cob_id: 0x4000_0480,
            tpdo_1_mapping: [
                0x6004_0020, 0x0000_0000, 0x0000_0000, 0x0000_0000, 0x0000_0000,
                0x0000_0000, 0x0000_0000, 0x0000_0000,
            ],
            tpdo_2_mapping: [
                0x6004_0020, 0x0000_0000, 0x0000_0000, 0x0000_0000, 0x0000_0000,
                0x0000_0000, 0x0000_0000, 0x0000_0000,
            ],
            tpdo_3_mapping: [
                0x6008_0040, 0x0000_0000, 0x0000_0000, 0x0000_0000, 0x0000_0000,
                0x0000_0000, 0x0000_0000, 0x0000_0000,
            ],
            integration_value_speed_integration_time: 1000,
            customer_eeprom_area: [4_294_967_295; 8],
            measuring_units_per_revolution: 16384,
            work_area_high_limit: [16384],
            producer_heartbeat_time: 1000,
            tpdo_1_communication_event_timer: 100,
            speed_scaling: [1, 1],
            frequency_limit: 65535,
            temperature_upper_limit: 100,
            temperature_lower_limit: -40,
            operating_parameters: 4,
            cyclic_timer: 1,
            tpdo_1_communication_transmission_type: 254,
            tpdo_2_communication_transmission_type: 1,
            tpdo_3_communication_transmission_type: 1,
            tpdo_4_communication_transmission_type: 1,
            tpdo_1_mapping_number_of_mapped_objects: 1,
            tpdo_2_mapping_number_of_mapped_objects: 1,
            tpdo_3_mapping_number_of_mapped_objects: 1,
            baud_rate: 9,
            node_id: 127,
            integration_value_position_filter: 1,
            warning_history_highest_sub_index_supported: 5,
            _gap: [0; 7],
            high_precision_position_value: 0,
            high_precision_preset_value: 0,
            manufacturer_status_register: 0x0000_0000,
            predefined_error_field: [0x0000_0000; 5],
            consumer_heartbeat_time: [0x0000_0000],
            identity_serial_number: 0,
            verify_configuration: [0x0000_0000, 0x0000_0000],
            tpdo_4_mapping: [0x0000_0000; 8],
            nmt_start_up_behaviour: 0x0000_0000,
            error_history: [0; 5],
            total_measuring_range: 0,
            preset_value: 0,
            position_value: 0,
            cam_1_low_limit: [0],
            cam_2_low_limit: [0],
            cam_3_low_limit: [0],
            cam_4_low_limit: [0],
            cam_5_low_limit: [0],
            cam_6_low_limit: [0],
            cam_7_low_limit: [0],
            cam_8_low_limit: [0],
            cam_1_high_limit: [0],
            cam_2_high_limit: [0],
            cam_3_high_limit: [0],
            cam_4_high_limit: [0],
            cam_5_high_limit: [0],
            cam_6_high_limit: [0],
            cam_7_high_limit: [0],
            cam_8_high_limit: [0],
            cam_1_hysteresis: [0],
            cam_2_hysteresis: [0],
            cam_3_hysteresis: [0],
            cam_4_hysteresis: [0],
            cam_5_hysteresis: [0],
            cam_6_hysteresis: [0],
            cam_7_hysteresis: [0],
            cam_8_hysteresis: [0],
            work_area_low_limit: [0],
            offset_value: 0,
            module_identification_minimum_position: 0,
            module_identification_maximum_position: 0,
            serial_number: [0],
            guard_time: 0,
            inhibit_time_emergency_message: 0,
            tpdo_2_communication_event_timer: 0,
            tpdo_3_communication_event_timer: 0,
            tpdo_4_communication_event_timer: 0,
            temperature_current: 0,
            temperature_maximum: 0,
            temperature_minimum: 0,
            alarm_history: [0; 5],
            warning_history: [0; 5],
            speed_value: [0],
            acceleration_value: [0],
            jerk_value: [0],
            operating_status: 0,
            alarms: 0,
            warnings: 0,
            error_register: 0,
            predefined_error_field_number_of_errors: 0,
            manufacturer_hardware_version: VisibleString::EMPTY,
            manufacturer_software_version: VisibleString::EMPTY,
            life_time_factor: 0,
            error_behaviour: [0, 0],
            tpdo_4_mapping_number_of_mapped_objects: 0,
            bus_off_auto_reset: 0,
            cam_state_register: [0],
            cam_enable_register: [0],
            cam_polarity_register: [0],
            area_state_register: [0],
            _padding: [0; 1],
        };
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                cob_id_emergency_message: node_id.plus_u32(0x0000_0080),
                tpdo_1_communication_cob_id: node_id.plus_u32(0x4000_0180),
                tpdo_2_communication_cob_id: node_id.plus_u32(0x4000_0280),
                tpdo_3_communication_cob_id: node_id.plus_u32(0x4000_0380),
                tpdo_4_communication_cob_id: node_id.plus_u32(0x4000_0480),
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
    }
    impl Handlers for () {}
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
        type Buffer = [u8; 32];
        type Pdos = lexican_runtime::pdo::Pdos<4, 0, 32>;
        type Storage = S;
        type Watches = [lexican_runtime::heartbeat::Watch; 1];
        type Servers = [lexican_runtime::sdo::Channel<Self::Buffer>; 0];
        const SERVICES: ServiceSet = ServiceSet::of(&ROWS).with(ServiceSet::LSS);
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
            [0; 32]
        }
        #[inline]
        fn pdos(&self) -> Self::Pdos {
            Self::Pdos::EMPTY
        }
        #[inline]
        fn watches(&self) -> Self::Watches {
            [lexican_runtime::heartbeat::Watch::NOBODY; 1]
        }
        #[inline]
        fn servers(&self) -> Self::Servers {
            [lexican_runtime::sdo::Channel::IDLE; 0]
        }
        #[inline]
        fn bit_rates(&self) -> lexican_runtime::lss::BitRates {
            lexican_runtime::lss::BitRates(0x01DF)
        }
        #[inline]
        fn storage(&mut self) -> Option<&mut S> {
            Some(&mut self.storage)
        }
        #[inline]
        fn event(&mut self, event: Event) {
            self.handlers.event(&mut self.od, event);
        }
        fn before_read(&mut self, _: Address) -> Result<(), AbortCode> {
            Ok(())
        }
        fn before_write(&mut self, _: Address, _: Value<'_>) -> Result<(), AbortCode> {
            Ok(())
        }
    }
    /// Bytes of the values; the compiler refuses any other number.
    const SIZE: usize = 600;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };

    const TABLE: Table<'static> = Table {
        entries: &place::<238>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 165] = [
        Row::value(0x1000, 0x00, DataType::UNSIGNED32, CONST, 0),
        Row::value(0x1001, 0x00, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, error_register)),
        Row::value(0x1002, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO), offset_of!(Dictionary, manufacturer_status_register)),
        Row::value(0x1003, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, predefined_error_field_number_of_errors)),
        Row::elements(0x1003, 0x01, 0x05, DataType::UNSIGNED32, RO.with(Access::COUNTED), offset_of!(Dictionary, predefined_error_field)),
        Row::value(0x1005, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cob_id_sync_message)),
        Row::value(0x1008, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 0),
        Row::value(0x1009, 0x00, DataType::VISIBLE_STRING, RO.with(Access::EXTRA), 1),
        Row::value(0x100A, 0x00, DataType::VISIBLE_STRING, RO.with(Access::EXTRA), 2),
        Row::value(0x100C, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, guard_time)),
        Row::value(0x100D, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, life_time_factor)),
        Row::value(0x1010, 0x00, DataType::UNSIGNED8, CONST, 14),
        Row::elements(0x1010, 0x01, 0x04, DataType::UNSIGNED32, RW, offset_of!(Dictionary, store_parameters)),
        Row::value(0x1011, 0x00, DataType::UNSIGNED8, CONST, 14),
        Row::elements(0x1011, 0x01, 0x04, DataType::UNSIGNED32, RW, offset_of!(Dictionary, restore_default_parameters)),
        Row::value(0x1014, 0x00, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, cob_id_emergency_message)),
        Row::value(0x1015, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, inhibit_time_emergency_message)),
        Row::value(0x1016, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x1016, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, consumer_heartbeat_time)),
        Row::value(0x1017, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, producer_heartbeat_time)),
        Row::value(0x1018, 0x00, DataType::UNSIGNED8, CONST, 14),
        Row::elements(0x1018, 0x01, 0x03, DataType::UNSIGNED32, CONST, 16),
        Row::value(0x1018, 0x04, DataType::UNSIGNED32, RO, offset_of!(Dictionary, identity_serial_number)),
        Row::value(0x1020, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::elements(0x1020, 0x01, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, verify_configuration)),
        Row::value(0x1029, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::elements(0x1029, 0x01, 0x02, DataType::UNSIGNED8, RW.with(Access::EXTRA), 3),
        Row::value(0x1800, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x1800, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_1_communication_cob_id)),
        Row::value(0x1800, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_1_communication_transmission_type)),
        Row::value(0x1800, 0x05, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_1_communication_event_timer)),
        Row::value(0x1801, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x1801, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_2_communication_cob_id)),
        Row::value(0x1801, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_2_communication_transmission_type)),
        Row::value(0x1801, 0x05, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_2_communication_event_timer)),
        Row::value(0x1802, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x1802, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_3_communication_cob_id)),
        Row::value(0x1802, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_3_communication_transmission_type)),
        Row::value(0x1802, 0x05, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_3_communication_event_timer)),
        Row::value(0x1803, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x1803, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_4_communication_cob_id)),
        Row::value(0x1803, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_4_communication_transmission_type)),
        Row::value(0x1803, 0x05, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_4_communication_event_timer)),
        Row::value(0x1A00, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_1_mapping_number_of_mapped_objects)),
        Row::elements(0x1A00, 0x01, 0x08, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_1_mapping)),
        Row::value(0x1A01, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_2_mapping_number_of_mapped_objects)),
        Row::elements(0x1A01, 0x01, 0x08, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_2_mapping)),
        Row::value(0x1A02, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_3_mapping_number_of_mapped_objects)),
        Row::elements(0x1A02, 0x01, 0x08, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_3_mapping)),
        Row::value(0x1A03, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_4_mapping_number_of_mapped_objects)),
        Row::elements(0x1A03, 0x01, 0x08, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_4_mapping)),
        Row::value(0x1F80, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, nmt_start_up_behaviour)),
        Row::value(0x2100, 0x00, DataType::UNSIGNED8, RW.with(Access::EXTRA), 5),
        Row::value(0x2101, 0x00, DataType::UNSIGNED8, RW.with(Access::EXTRA), 6),
        Row::value(0x2103, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, bus_off_auto_reset)),
        Row::value(0x2105, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::value(0x2105, 0x01, DataType::UNSIGNED8, RW.with(Access::EXTRA), 7),
        Row::value(0x2105, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, integration_value_speed_integration_time)),
        Row::value(0x2106, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::elements(0x2106, 0x01, 0x02, DataType::UNSIGNED16, RW, offset_of!(Dictionary, speed_scaling)),
        Row::value(0x2107, 0x00, DataType::UNSIGNED16, RW.with(Access::EXTRA), 8),
        Row::value(0x2120, 0x00, DataType::UNSIGNED8, CONST, 42),
        Row::elements(0x2120, 0x01, 0x08, DataType::UNSIGNED32, RW, offset_of!(Dictionary, customer_eeprom_area)),
        Row::value(0x2500, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::value(0x2500, 0x01, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, temperature_current)),
        Row::elements(0x2500, 0x02, 0x03, DataType::INTEGER16, RW.with(Access::TPDO).with(Access::EXTRA), 9),
        Row::value(0x2500, 0x04, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, temperature_maximum)),
        Row::value(0x2500, 0x05, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, temperature_minimum)),
        Row::value(0x2502, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::elements(0x2502, 0x01, 0x05, DataType::UNSIGNED32, RO, offset_of!(Dictionary, error_history)),
        Row::value(0x2503, 0x00, DataType::UNSIGNED8, CONST, 31),
        Row::elements(0x2503, 0x01, 0x05, DataType::UNSIGNED16, RO, offset_of!(Dictionary, alarm_history)),
        Row::value(0x2504, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, warning_history_highest_sub_index_supported)),
        Row::elements(0x2504, 0x01, 0x05, DataType::UNSIGNED16, RO, offset_of!(Dictionary, warning_history)),
        Row::value(0x6000, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, operating_parameters)),
        Row::value(0x6001, 0x00, DataType::UNSIGNED32, RW.with(Access::EXTRA), 11),
        Row::value(0x6002, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, total_measuring_range)),
        Row::value(0x6003, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, preset_value)),
        Row::value(0x6004, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO), offset_of!(Dictionary, position_value)),
        Row::value(0x6008, 0x00, DataType::UNSIGNED64, RO.with(Access::TPDO), offset_of!(Dictionary, high_precision_position_value)),
        Row::value(0x6009, 0x00, DataType::UNSIGNED64, RW, offset_of!(Dictionary, high_precision_preset_value)),
        Row::value(0x6030, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6030, 0x01, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, speed_value)),
        Row::value(0x6040, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6040, 0x01, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, acceleration_value)),
        Row::value(0x6050, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6050, 0x01, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, jerk_value)),
        Row::value(0x6200, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cyclic_timer)),
        Row::value(0x6300, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6300, 0x01, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, cam_state_register)),
        Row::value(0x6301, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6301, 0x01, DataType::UNSIGNED8, RW, offset_of!(Dictionary, cam_enable_register)),
        Row::value(0x6302, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6302, 0x01, DataType::UNSIGNED8, RW, offset_of!(Dictionary, cam_polarity_register)),
        Row::value(0x6310, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6310, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_1_low_limit)),
        Row::value(0x6311, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6311, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_2_low_limit)),
        Row::value(0x6312, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6312, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_3_low_limit)),
        Row::value(0x6313, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6313, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_4_low_limit)),
        Row::value(0x6314, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6314, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_5_low_limit)),
        Row::value(0x6315, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6315, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_6_low_limit)),
        Row::value(0x6316, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6316, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_7_low_limit)),
        Row::value(0x6317, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6317, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_8_low_limit)),
        Row::value(0x6320, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6320, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_1_high_limit)),
        Row::value(0x6321, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6321, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_2_high_limit)),
        Row::value(0x6322, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6322, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_3_high_limit)),
        Row::value(0x6323, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6323, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_4_high_limit)),
        Row::value(0x6324, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6324, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_5_high_limit)),
        Row::value(0x6325, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6325, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_6_high_limit)),
        Row::value(0x6326, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6326, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_7_high_limit)),
        Row::value(0x6327, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6327, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_8_high_limit)),
        Row::value(0x6330, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6330, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_1_hysteresis)),
        Row::value(0x6331, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6331, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_2_hysteresis)),
        Row::value(0x6332, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6332, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_3_hysteresis)),
        Row::value(0x6333, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6333, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_4_hysteresis)),
        Row::value(0x6334, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6334, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_5_hysteresis)),
        Row::value(0x6335, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6335, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_6_hysteresis)),
        Row::value(0x6336, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6336, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_7_hysteresis)),
        Row::value(0x6337, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6337, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cam_8_hysteresis)),
        Row::value(0x6400, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6400, 0x01, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, area_state_register)),
        Row::value(0x6401, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6401, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, work_area_low_limit)),
        Row::value(0x6402, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x6402, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, work_area_high_limit)),
        Row::value(0x6500, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, operating_status)),
        Row::value(0x6501, 0x00, DataType::UNSIGNED32, CONST, 55),
        Row::value(0x6502, 0x00, DataType::UNSIGNED16, CONST, 59),
        Row::value(0x6503, 0x00, DataType::UNSIGNED16, RO.with(Access::TPDO), offset_of!(Dictionary, alarms)),
        Row::value(0x6504, 0x00, DataType::UNSIGNED16, CONST, 61),
        Row::value(0x6505, 0x00, DataType::UNSIGNED16, RO.with(Access::TPDO), offset_of!(Dictionary, warnings)),
        Row::value(0x6506, 0x00, DataType::UNSIGNED16, CONST, 63),
        Row::value(0x6507, 0x00, DataType::UNSIGNED32, CONST, 65),
        Row::value(0x6508, 0x00, DataType::UNSIGNED32, CONST, 69),
        Row::value(0x6509, 0x00, DataType::INTEGER32, RO, offset_of!(Dictionary, offset_value)),
        Row::value(0x650A, 0x00, DataType::UNSIGNED8, CONST, 73),
        Row::value(0x650A, 0x01, DataType::INTEGER32, CONST, 74),
        Row::value(0x650A, 0x02, DataType::INTEGER32, RO, offset_of!(Dictionary, module_identification_minimum_position)),
        Row::value(0x650A, 0x03, DataType::INTEGER32, RO, offset_of!(Dictionary, module_identification_maximum_position)),
        Row::value(0x650B, 0x00, DataType::UNSIGNED8, CONST, 15),
        Row::value(0x650B, 0x01, DataType::UNSIGNED32, RO, offset_of!(Dictionary, serial_number)),
        Row::value(0x6510, 0x00, DataType::UNSIGNED40, CONST, 78),
    ];

    #[rustfmt::skip]
    const SEEDS: [u16; 76] = [
        0, 11, 1, 2, 12, 0, 25, 1, 0, 3, 39, 2, 10, 39, 0, 6,
        36, 30, 2, 4, 4, 0, 1, 1, 9, 8, 9, 33, 5, 16, 6, 12,
        4, 17, 27, 0, 0, 0, 3, 1, 22, 37, 35, 8, 0, 60, 11, 24,
        0, 20, 9, 9, 0, 1, 65, 88, 26, 134, 3, 0, 147, 220, 84, 271,
        6, 0, 164, 51, 0, 5, 66, 8, 115, 2, 93, 99,
    ];

    #[rustfmt::skip]
    const EXTRAS: [Extra; 12] = [
        Extra::new(4, 10), // 1008sub0
        Extra::new(offset_of!(Dictionary, manufacturer_hardware_version), 32), // 1009sub0
        Extra::new(offset_of!(Dictionary, manufacturer_software_version), 32), // 100Asub0
        Extra::new(offset_of!(Dictionary, error_behaviour), 29), // 1029sub1
        Extra::new(offset_of!(Dictionary, error_behaviour) + 1, 29), // 1029sub2
        Extra::new(offset_of!(Dictionary, baud_rate), 32), // 2100sub0
        Extra::new(offset_of!(Dictionary, node_id), 34), // 2101sub0
        Extra::new(offset_of!(Dictionary, integration_value_position_filter), 36), // 2105sub1
        Extra::new(offset_of!(Dictionary, frequency_limit), 38), // 2107sub0
        Extra::new(offset_of!(Dictionary, temperature_upper_limit), 43), // 2500sub2
        Extra::new(offset_of!(Dictionary, temperature_lower_limit), 43), // 2500sub3
        Extra::new(offset_of!(Dictionary, measuring_units_per_revolution), 47), // 6001sub0
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 86] = [
        0x96, 0x01, 0x02, 0x00, // 1000sub0
        0x57, 0x44, 0x47, 0x41, 0x2D, 0x4D, 0x54, 0x2D, 0x43, 0x4F, // 1008sub0
        0x04, // 1010sub0
        0x01, // 1016sub0
        0x1F, 0x02, 0x00, 0x01, // 1018sub1
        0x41, 0x47, 0x44, 0x57, // 1018sub2
        0x08, 0x02, 0x06, 0x03, // 1018sub3
        0x02, // 1020sub0
        0x00, 0x02, // limits of 1029sub1
        0x05, // 1800sub0
        0x00, 0x09, // limits of 2100sub0
        0x01, 0x7F, // limits of 2101sub0
        0x01, 0x04, // limits of 2105sub1
        0x01, 0x00, 0xFF, 0xFF, // limits of 2107sub0
        0x08, // 2120sub0
        0xD8, 0xFF, 0x64, 0x00, // limits of 2500sub2
        0x01, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, // limits of 6001sub0
        0x00, 0x40, 0x00, 0x00, // 6501sub0
        0xFF, 0xFF, // 6502sub0
        0x01, 0x00, // 6504sub0
        0x01, 0x70, // 6506sub0
        0x02, 0x03, 0x05, 0x01, // 6507sub0
        0xFF, 0xFF, 0xFF, 0xFF, // 6508sub0
        0x03, // 650Asub0
        0x00, 0x00, 0x00, 0x00, // 650Asub1
        0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, // 6510sub0
    ];
}
