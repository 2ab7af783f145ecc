pub mod wv58mr_handled {
    //! Object dictionary of `WV58MR`, generated from `wv58mr.eds`. Do not edit.
    //!
    //! * Vendor: `SIKO GmbH`
    //! * Order code: `WV58MR`
    //! * Description: `Redundant absolute encoder WV58MR, 12 bit multiturn`
    //! * 102 values of 52 objects; 248 bytes of RAM
    use core::mem::offset_of;
    use lexican_runtime::{AbortCode, Address, Event, NodeId, bytemuck};
    use lexican_runtime::od::{
        Access, DataType, Extra, NumberSet, Row, ServiceSet, Table, Value, place,
        resized, written,
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
        /// 1018sub4 `Identity`, `Serial number`, `UNSIGNED32`, ro, default `0x0000_0001`
        pub identity_serial_number: u32,
        /// 1200sub1 `SDO server`, `COB-ID client to server`, `UNSIGNED32`, ro, default `$NODEID+0x600`
        pub sdo_server_cob_id_client_to_server: u32,
        /// 1200sub2 `SDO server`, `COB-ID server to client`, `UNSIGNED32`, ro, default `$NODEID+0x580`
        pub sdo_server_cob_id_server_to_client: u32,
        /// 1800sub1 `TPDO 1 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x180`
        pub tpdo_1_communication_cob_id: u32,
        /// 1801sub1 `TPDO 2 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x280`
        pub tpdo_2_communication_cob_id: u32,
        /// 1A00sub1 to 1A00sub2 `TPDO 1 mapping`, `UNSIGNED32`, ro
        ///
        /// * `[0]`: `Mapped object 1`, default `0x6004_0020`
        /// * `[1]`: `Mapped object 2`, default `0x6030_0110`
        pub tpdo_1_mapping: [u32; 2],
        /// 1A01sub1 to 1A01sub2 `TPDO 2 mapping`, `UNSIGNED32`, ro
        ///
        /// * `[0]`: `Mapped object 1`, default `0x6004_0020`
        /// * `[1]`: `Mapped object 2`, default `0x6030_0110`
        pub tpdo_2_mapping: [u32; 2],
        /// 6001h `Measuring units per revolution`, `UNSIGNED32`, rw, `1` to `65535`, default `16384`
        pub measuring_units_per_revolution: u32,
        /// 6002h `Total measuring range`, `UNSIGNED32`, rw, default `67_108_864`
        pub total_measuring_range: u32,
        /// 6501h `Singleturn resolution`, `UNSIGNED32`, ro, default `16384`
        pub singleturn_resolution: u32,
        /// 6507h `Profile and software version`, `UNSIGNED32`, ro, default `16_777_986`
        pub profile_and_software_version: u32,
        /// 6508h `Operating time`, `UNSIGNED32`, ro, default `4_294_967_295`
        pub operating_time: u32,
        /// 650Asub1 to 650Asub3 `Module identification`, `INTEGER32`, ro
        ///
        /// * `[0]`: `Offset value`, default `0`
        /// * `[1]`: `Minimum position`, default `0`
        /// * `[2]`: `Maximum position`, default `67_108_863`
        pub module_identification: [i32; 3],
        /// 650Eh `Device functionality`, `UNSIGNED32`, ro, default `2`
        pub device_functionality: u32,
        /// 6000h `Operating parameters`, `UNSIGNED16`, rw, default `4`
        pub operating_parameters: u16,
        /// 6031sub2 `Speed parameters`, `Speed integration time`, `UNSIGNED16`, ro, default `100`
        pub speed_parameters_speed_integration_time: u16,
        /// 6031sub3 `Speed parameters`, `Speed multiplier`, `UNSIGNED16`, rw, default `1`
        pub speed_parameters_speed_multiplier: u16,
        /// 6031sub4 `Speed parameters`, `Speed divisor`, `UNSIGNED16`, rw, default `1`
        pub speed_parameters_speed_divisor: u16,
        /// 6500h `Operating status`, `UNSIGNED16`, ro, default `4`
        pub operating_status: u16,
        /// 6502h `Number of distinguishable revolutions`, `UNSIGNED16`, ro, default `4096`
        pub number_of_distinguishable_revolutions: u16,
        /// 6504h `Supported alarms`, `UNSIGNED16`, ro, default `12289`
        pub supported_alarms: u16,
        /// 6506h `Supported warnings`, `UNSIGNED16`, ro, default `1`
        pub supported_warnings: u16,
        /// 1800sub2 `TPDO 1 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_1_communication_transmission_type: u8,
        /// 1801sub2 `TPDO 2 communication`, `Transmission type`, `UNSIGNED8`, rw, default `1`
        pub tpdo_2_communication_transmission_type: u8,
        /// 5F0Asub1 to 5F0Asub2 `Node-ID and baud rate`, `UNSIGNED8`, rw
        ///
        /// * `[0]`: `Node-ID`, `1` to `127`, default `1`
        /// * `[1]`: `Baud rate`, `1` to `7`, default `5`
        pub node_id_and_baud_rate: [u8; 2],
        /// 6031sub1 `Speed parameters`, `Speed source selector`, `UNSIGNED8`, rw, default `2`
        pub speed_parameters_speed_source_selector: u8,
        /// 650Dh `Absolute accuracy`, `UNSIGNED8`, ro, default `8`
        pub absolute_accuracy: u8,
        _gap: [u8; 2],
        /// 1002h `Manufacturer status register`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub manufacturer_status_register: u32,
        /// 1003sub1 to 1003sub8 `Predefined error field`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub predefined_error_field: [u32; 8],
        /// 2001h `Application offset`, `INTEGER32`, rw, `-67_108_864` to `67_108_863`, default `0`
        pub application_offset: i32,
        /// 5000h `CAN bus error diagnosis`, `UNSIGNED32`, ro, default `0`
        pub can_bus_error_diagnosis: u32,
        /// 6003h `Preset value`, `UNSIGNED32`, rw, `0` to `268_431_359`, default `0`
        pub preset_value: u32,
        /// 6004h `Position value`, `UNSIGNED32`, ro, default `0`, PDO-mappable
        pub position_value: u32,
        /// 600Ch `Position raw value`, `UNSIGNED32`, ro, default `0`, PDO-mappable
        pub position_raw_value: u32,
        /// 6401sub1 to 6401sub2 `Work area low limit`, `INTEGER32`, rw, `0` to `268_431_359`, default `0`
        pub work_area_low_limit: [i32; 2],
        /// 6402sub1 to 6402sub2 `Work area high limit`, `INTEGER32`, rw, `0` to `268_431_359`, default `0`
        pub work_area_high_limit: [i32; 2],
        /// 6509h `Offset value`, `INTEGER32`, ro, default `0`
        pub offset_value: i32,
        /// 650Bh `Encoder serial number`, `UNSIGNED32`, ro, default `0`
        pub encoder_serial_number: u32,
        /// 100Ch `Guard time`, `UNSIGNED16` in ms, rw, default `0`
        pub guard_time: u16,
        /// 1017h `Producer heartbeat time`, `UNSIGNED16` in ms, rw, default `0`
        pub producer_heartbeat_time: u16,
        /// 1800sub3 `TPDO 1 communication`, `Inhibit time`, `UNSIGNED16` in multiples of 100 µs, ro, default `0`
        pub tpdo_1_communication_inhibit_time: u16,
        /// 1800sub5 `TPDO 1 communication`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        pub tpdo_1_communication_event_timer: u16,
        /// 1801sub3 `TPDO 2 communication`, `Inhibit time`, `UNSIGNED16` in multiples of 100 µs, ro, default `0`
        pub tpdo_2_communication_inhibit_time: u16,
        /// 1801sub5 `TPDO 2 communication`, `Event timer`, `UNSIGNED16` in ms, ro, default `0`
        pub tpdo_2_communication_event_timer: u16,
        /// 2003h `Limit speed low`, `INTEGER16`, rw, `-32768` to `32767`, default `0`
        pub limit_speed_low: i16,
        /// 2004h `Limit speed high`, `INTEGER16`, rw, `-32768` to `32767`, default `0`
        pub limit_speed_high: i16,
        /// 6030sub1 `Speed value`, `INTEGER16`, ro, default `0`, PDO-mappable
        pub speed_value: [i16; 1],
        /// 6200h `Cycle timer`, `UNSIGNED16`, rw, default `0`
        pub cycle_timer: u16,
        /// 6503h `Alarms`, `UNSIGNED16`, ro, default `0`
        pub alarms: u16,
        /// 6505h `Warnings`, `UNSIGNED16`, ro, default `0`
        pub warnings: u16,
        /// 1001h `Error register`, `UNSIGNED8`, ro, default `0`
        pub error_register: u8,
        /// 1003sub0 `Predefined error field`, `Number of errors`, `UNSIGNED8`, rw, default `0`
        pub predefined_error_field_number_of_errors: u8,
        /// 100Dh `Life time factor`, `UNSIGNED8`, rw, default `0`
        pub life_time_factor: u8,
        /// 2002h `Calibrate encoder value`, `UNSIGNED8`, wo, default `0`
        pub calibrate_encoder_value: u8,
        /// 6400sub1 to 6400sub2 `Area state register`, `UNSIGNED8`, ro, default `0`
        pub area_state_register: [u8; 2],
        _padding: [u8; 2],
    }
    impl Dictionary {
        /// 1000h `Device type`, `UNSIGNED32`, ro
        pub const DEVICE_TYPE: u32 = 0x0002_0196;
        /// 1008h `Manufacturer device name`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_DEVICE_NAME: &'static str = "WV58MR";
        /// 1009h `Manufacturer hardware version`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_HARDWARE_VERSION: &'static str = "V001";
        /// 100Ah `Manufacturer software version`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_SOFTWARE_VERSION: &'static str = "V100";
        /// 1010sub0 `Store parameters`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const STORE_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1011sub0 `Restore default parameters`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const RESTORE_DEFAULT_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1018sub0 `Identity`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const IDENTITY_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1018sub1 `Identity`, `Vendor-ID`, `UNSIGNED32`, ro
        pub const IDENTITY_VENDOR_ID: u32 = 0x0000_0195;
        /// 1018sub2 `Identity`, `Product code`, `UNSIGNED32`, ro
        pub const IDENTITY_PRODUCT_CODE: u32 = 0xFFFF_FFFF;
        /// 1018sub3 `Identity`, `Revision number`, `UNSIGNED32`, ro
        pub const IDENTITY_REVISION_NUMBER: u32 = 0xFFFF_FFFF;
        /// 1200sub0 `SDO server`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SDO_SERVER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1800sub0 `TPDO 1 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_1_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 1801sub0 `TPDO 2 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_2_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 5;
        /// 1A00sub0 `TPDO 1 mapping`, `Number of mapped objects`, `UNSIGNED8`, const
        pub const TPDO_1_MAPPING_NUMBER_OF_MAPPED_OBJECTS: u8 = 2;
        /// 1A01sub0 `TPDO 2 mapping`, `Number of mapped objects`, `UNSIGNED8`, const
        pub const TPDO_2_MAPPING_NUMBER_OF_MAPPED_OBJECTS: u8 = 2;
        /// 5F0Asub0 `Node-ID and baud rate`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const NODE_ID_AND_BAUD_RATE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 6030sub0 `Speed value`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const SPEED_VALUE_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 6031sub0 `Speed parameters`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const SPEED_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 6400sub0 `Area state register`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const AREA_STATE_REGISTER_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 6401sub0 `Work area low limit`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const WORK_AREA_LOW_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 6402sub0 `Work area high limit`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const WORK_AREA_HIGH_LIMIT_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 650Asub0 `Module identification`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const MODULE_IDENTIFICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            cob_id_sync_message: 0x0000_0080,
            store_parameters: [0x0000_0001; 4],
            restore_default_parameters: [0x0000_0001; 4],
            cob_id_emergency_message: 0x0000_0080,
            identity_serial_number: 0x0000_0001,
            sdo_server_cob_id_client_to_server: 0x0000_0600,
            sdo_server_cob_id_server_to_client: 0x0000_0580,
            tpdo_1_communication_cob_id: 0x0000_0180,
            tpdo_2_communication_cob_id: 0x0000_0280,
            tpdo_1_mapping: [0x6004_0020, 0x6030_0110],
            tpdo_2_mapping: [0x6004_0020, 0x6030_0110],
            measuring_units_per_revolution: 16384,
            total_measuring_range: 67_108_864,
            singleturn_resolution: 16384,
            profile_and_software_version: 16_777_986,
            operating_time: 4_294_967_295,
            module_identification: [0, 0, 67_108_863],
            device_functionality: 2,
            operating_parameters: 4,
            speed_parameters_speed_integration_time: 100,
            speed_parameters_speed_multiplier: 1,
            speed_parameters_speed_divisor: 1,
            operating_status: 4,
            number_of_distinguishable_revolutions: 4096,
            supported_alarms: 12289,
            supported_warnings: 1,
            tpdo_1_communication_transmission_type: 254,
            tpdo_2_communication_transmission_type: 1,
            node_id_and_baud_rate: [1, 5],
            speed_parameters_speed_source_selector: 2,
            absolute_accuracy: 8,
            _gap: [0; 2],
            manufacturer_status_register: 0x0000_0000,
            predefined_error_field: [0x0000_0000; 8],
            application_offset: 0,
            can_bus_error_diagnosis: 0,
            preset_value: 0,
            position_value: 0,
            position_raw_value: 0,
            work_area_low_limit: [0, 0],
            work_area_high_limit: [0, 0],
            offset_value: 0,
            encoder_serial_number: 0,
            guard_time: 0,
            producer_heartbeat_time: 0,
            tpdo_1_communication_inhibit_time: 0,
            tpdo_1_communication_event_timer: 0,
            tpdo_2_communication_inhibit_time: 0,
            tpdo_2_communication_event_timer: 0,
            limit_speed_low: 0,
            limit_speed_high: 0,
            speed_value: [0],
            cycle_timer: 0,
            alarms: 0,
            warnings: 0,
            error_register: 0,
            predefined_error_field_number_of_errors: 0,
            life_time_factor: 0,
            calibrate_encoder_value: 0,
            area_state_register: [0, 0],
            _padding: [0; 2],
        };
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                cob_id_emergency_message: node_id.plus_u32(0x0000_0080),
                sdo_server_cob_id_client_to_server: node_id.plus_u32(0x0000_0600),
                sdo_server_cob_id_server_to_client: node_id.plus_u32(0x0000_0580),
                tpdo_1_communication_cob_id: node_id.plus_u32(0x0000_0180),
                tpdo_2_communication_cob_id: node_id.plus_u32(0x0000_0280),
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
        /// 1005h `COB-ID SYNC message`, `UNSIGNED32`, rw, default `0x0000_0080`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_cob_id_sync_message(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 100Ch `Guard time`, `UNSIGNED16` in ms, rw, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_guard_time(
            &mut self,
            od: &mut Dictionary,
            value: u16,
        ) -> Result<(), AbortCode>;
        /// 100Dh `Life time factor`, `UNSIGNED8`, rw, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_life_time_factor(
            &mut self,
            od: &mut Dictionary,
            value: u8,
        ) -> Result<(), AbortCode>;
        /// 1014h `COB-ID emergency message`, `UNSIGNED32`, rw, default `$NODEID+0x80`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_cob_id_emergency_message(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 1017h `Producer heartbeat time`, `UNSIGNED16` in ms, rw, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_producer_heartbeat_time(
            &mut self,
            od: &mut Dictionary,
            value: u16,
        ) -> Result<(), AbortCode>;
        /// 1800sub1 `TPDO 1 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x180`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_tpdo_1_communication_cob_id(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 1800sub2 `TPDO 1 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_tpdo_1_communication_transmission_type(
            &mut self,
            od: &mut Dictionary,
            value: u8,
        ) -> Result<(), AbortCode>;
        /// 1800sub5 `TPDO 1 communication`, `Event timer`, `UNSIGNED16` in ms, rw, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_tpdo_1_communication_event_timer(
            &mut self,
            od: &mut Dictionary,
            value: u16,
        ) -> Result<(), AbortCode>;
        /// 1801sub1 `TPDO 2 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x280`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_tpdo_2_communication_cob_id(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 1801sub2 `TPDO 2 communication`, `Transmission type`, `UNSIGNED8`, rw, default `1`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_tpdo_2_communication_transmission_type(
            &mut self,
            od: &mut Dictionary,
            value: u8,
        ) -> Result<(), AbortCode>;
        /// 2001h `Application offset`, `INTEGER32`, rw, `-67_108_864` to `67_108_863`, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_application_offset(
            &mut self,
            od: &mut Dictionary,
            value: i32,
        ) -> Result<(), AbortCode>;
        /// 2003h `Limit speed low`, `INTEGER16`, rw, `-32768` to `32767`, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_limit_speed_low(
            &mut self,
            od: &mut Dictionary,
            value: i16,
        ) -> Result<(), AbortCode>;
        /// 2004h `Limit speed high`, `INTEGER16`, rw, `-32768` to `32767`, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_limit_speed_high(
            &mut self,
            od: &mut Dictionary,
            value: i16,
        ) -> Result<(), AbortCode>;
        /// 6000h `Operating parameters`, `UNSIGNED16`, rw, default `4`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_operating_parameters(
            &mut self,
            od: &mut Dictionary,
            value: u16,
        ) -> Result<(), AbortCode>;
        /// 6001h `Measuring units per revolution`, `UNSIGNED32`, rw, `1` to `65535`, default `16384`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_measuring_units_per_revolution(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 6002h `Total measuring range`, `UNSIGNED32`, rw, default `67_108_864`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_total_measuring_range(
            &mut self,
            od: &mut Dictionary,
            value: u32,
        ) -> Result<(), AbortCode>;
        /// 6003h `Preset value`, `UNSIGNED32`, rw, `0` to `268_431_359`, default `0`
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
        /// 6031sub1 `Speed parameters`, `Speed source selector`, `UNSIGNED8`, rw, default `2`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_speed_parameters_speed_source_selector(
            &mut self,
            od: &mut Dictionary,
            value: u8,
        ) -> Result<(), AbortCode>;
        /// 6031sub3 `Speed parameters`, `Speed multiplier`, `UNSIGNED16`, rw, default `1`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_speed_parameters_speed_multiplier(
            &mut self,
            od: &mut Dictionary,
            value: u16,
        ) -> Result<(), AbortCode>;
        /// 6031sub4 `Speed parameters`, `Speed divisor`, `UNSIGNED16`, rw, default `1`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_speed_parameters_speed_divisor(
            &mut self,
            od: &mut Dictionary,
            value: u16,
        ) -> Result<(), AbortCode>;
        /// 6200h `Cycle timer`, `UNSIGNED16`, rw, default `0`
        ///
        /// Called before a client's value, which is within the limits, is stored in `od`.
        ///
        /// # Errors
        /// The abort code that the client is answered with; then nothing is stored.
        fn write_cycle_timer(
            &mut self,
            od: &mut Dictionary,
            value: u16,
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
        type Buffer = [u8; 8];
        type Pdos = lexican_runtime::pdo::Pdos<2, 0, 4>;
        type Storage = S;
        type Watches = [lexican_runtime::heartbeat::Watch; 0];
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
            [0; 8]
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
        fn bit_rates(&self) -> lexican_runtime::lss::BitRates {
            lexican_runtime::lss::BitRates(0x00DF)
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
        fn before_write(
            &mut self,
            address: Address,
            value: Value<'_>,
        ) -> Result<(), AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                (0x1005, 0x00) => handlers.write_cob_id_sync_message(od, value.to_u32()),
                (0x100C, 0x00) => handlers.write_guard_time(od, value.to_u16()),
                (0x100D, 0x00) => handlers.write_life_time_factor(od, value.to_u8()),
                (0x1014, 0x00) => {
                    handlers.write_cob_id_emergency_message(od, value.to_u32())
                }
                (0x1017, 0x00) => {
                    handlers.write_producer_heartbeat_time(od, value.to_u16())
                }
                (0x1800, 0x01) => {
                    handlers.write_tpdo_1_communication_cob_id(od, value.to_u32())
                }
                (0x1800, 0x02) => {
                    handlers
                        .write_tpdo_1_communication_transmission_type(od, value.to_u8())
                }
                (0x1800, 0x05) => {
                    handlers.write_tpdo_1_communication_event_timer(od, value.to_u16())
                }
                (0x1801, 0x01) => {
                    handlers.write_tpdo_2_communication_cob_id(od, value.to_u32())
                }
                (0x1801, 0x02) => {
                    handlers
                        .write_tpdo_2_communication_transmission_type(od, value.to_u8())
                }
                (0x2001, 0x00) => handlers.write_application_offset(od, value.to_i32()),
                (0x2003, 0x00) => handlers.write_limit_speed_low(od, value.to_i16()),
                (0x2004, 0x00) => handlers.write_limit_speed_high(od, value.to_i16()),
                (0x6000, 0x00) => handlers.write_operating_parameters(od, value.to_u16()),
                (0x6001, 0x00) => {
                    handlers.write_measuring_units_per_revolution(od, value.to_u32())
                }
                _ => self.before_write_1(address, value),
            }
        }
    }
    /// Bytes of the values; the compiler refuses any other number.
    const SIZE: usize = 248;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };
    impl<H: Handlers, S: lexican_runtime::storage::Storage> Device<H, S> {
        fn before_write_1(
            &mut self,
            address: Address,
            value: Value<'_>,
        ) -> Result<(), AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                (0x6002, 0x00) => {
                    handlers.write_total_measuring_range(od, value.to_u32())
                }
                (0x6003, 0x00) => handlers.write_preset_value(od, value.to_u32()),
                (0x6031, 0x01) => {
                    handlers
                        .write_speed_parameters_speed_source_selector(od, value.to_u8())
                }
                (0x6031, 0x03) => {
                    handlers.write_speed_parameters_speed_multiplier(od, value.to_u16())
                }
                (0x6031, 0x04) => {
                    handlers.write_speed_parameters_speed_divisor(od, value.to_u16())
                }
                (0x6200, 0x00) => handlers.write_cycle_timer(od, value.to_u16()),
                _ => Ok(()),
            }
        }
    }

    const TABLE: Table<'static> = Table {
        entries: &place::<107>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const WO: Access = Access::WRITE;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 80] = [
        Row::value(0x1000, 0x00, DataType::UNSIGNED32, CONST, 0),
        Row::value(0x1001, 0x00, DataType::UNSIGNED8, RO, offset_of!(Dictionary, error_register)),
        Row::value(0x1002, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, manufacturer_status_register)),
        Row::value(0x1003, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, predefined_error_field_number_of_errors)),
        Row::elements(0x1003, 0x01, 0x08, DataType::UNSIGNED32, RO.with(Access::COUNTED), offset_of!(Dictionary, predefined_error_field)),
        Row::value(0x1005, 0x00, DataType::UNSIGNED32, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, cob_id_sync_message)),
        Row::value(0x1008, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 0),
        Row::value(0x1009, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 1),
        Row::value(0x100A, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 2),
        Row::value(0x100C, 0x00, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, guard_time)),
        Row::value(0x100D, 0x00, DataType::UNSIGNED8, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, life_time_factor)),
        Row::value(0x1010, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::elements(0x1010, 0x01, 0x04, DataType::UNSIGNED32, RW, offset_of!(Dictionary, store_parameters)),
        Row::value(0x1011, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::elements(0x1011, 0x01, 0x04, DataType::UNSIGNED32, RW, offset_of!(Dictionary, restore_default_parameters)),
        Row::value(0x1014, 0x00, DataType::UNSIGNED32, RW.with(Access::WRITE_HANDLER).with(Access::NODE_ID), offset_of!(Dictionary, cob_id_emergency_message)),
        Row::value(0x1017, 0x00, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, producer_heartbeat_time)),
        Row::value(0x1018, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::elements(0x1018, 0x01, 0x02, DataType::UNSIGNED32, CONST, 19),
        Row::value(0x1018, 0x03, DataType::UNSIGNED32, CONST, 23),
        Row::value(0x1018, 0x04, DataType::UNSIGNED32, RO, offset_of!(Dictionary, identity_serial_number)),
        Row::value(0x1200, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::value(0x1200, 0x01, DataType::UNSIGNED32, RO.with(Access::NODE_ID), offset_of!(Dictionary, sdo_server_cob_id_client_to_server)),
        Row::value(0x1200, 0x02, DataType::UNSIGNED32, RO.with(Access::NODE_ID), offset_of!(Dictionary, sdo_server_cob_id_server_to_client)),
        Row::value(0x1800, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::value(0x1800, 0x01, DataType::UNSIGNED32, RW.with(Access::WRITE_HANDLER).with(Access::NODE_ID), offset_of!(Dictionary, tpdo_1_communication_cob_id)),
        Row::value(0x1800, 0x02, DataType::UNSIGNED8, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, tpdo_1_communication_transmission_type)),
        Row::value(0x1800, 0x03, DataType::UNSIGNED16, RO, offset_of!(Dictionary, tpdo_1_communication_inhibit_time)),
        Row::value(0x1800, 0x05, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, tpdo_1_communication_event_timer)),
        Row::value(0x1801, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::value(0x1801, 0x01, DataType::UNSIGNED32, RW.with(Access::WRITE_HANDLER).with(Access::NODE_ID), offset_of!(Dictionary, tpdo_2_communication_cob_id)),
        Row::value(0x1801, 0x02, DataType::UNSIGNED8, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, tpdo_2_communication_transmission_type)),
        Row::value(0x1801, 0x03, DataType::UNSIGNED16, RO, offset_of!(Dictionary, tpdo_2_communication_inhibit_time)),
        Row::value(0x1801, 0x05, DataType::UNSIGNED16, RO, offset_of!(Dictionary, tpdo_2_communication_event_timer)),
        Row::value(0x1A00, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::elements(0x1A00, 0x01, 0x02, DataType::UNSIGNED32, RO, offset_of!(Dictionary, tpdo_1_mapping)),
        Row::value(0x1A01, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::elements(0x1A01, 0x01, 0x02, DataType::UNSIGNED32, RO, offset_of!(Dictionary, tpdo_2_mapping)),
        Row::value(0x2001, 0x00, DataType::INTEGER32, RW.with(Access::EXTRA).with(Access::WRITE_HANDLER), 3),
        Row::value(0x2002, 0x00, DataType::UNSIGNED8, WO, offset_of!(Dictionary, calibrate_encoder_value)),
        Row::value(0x2003, 0x00, DataType::INTEGER16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, limit_speed_low)),
        Row::value(0x2004, 0x00, DataType::INTEGER16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, limit_speed_high)),
        Row::value(0x5000, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, can_bus_error_diagnosis)),
        Row::value(0x5F0A, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::elements(0x5F0A, 0x01, 0x02, DataType::UNSIGNED8, RW.with(Access::EXTRA), 4),
        Row::value(0x6000, 0x00, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, operating_parameters)),
        Row::value(0x6001, 0x00, DataType::UNSIGNED32, RW.with(Access::EXTRA).with(Access::WRITE_HANDLER), 6),
        Row::value(0x6002, 0x00, DataType::UNSIGNED32, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, total_measuring_range)),
        Row::value(0x6003, 0x00, DataType::UNSIGNED32, RW.with(Access::EXTRA).with(Access::WRITE_HANDLER), 7),
        Row::value(0x6004, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO), offset_of!(Dictionary, position_value)),
        Row::value(0x600C, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO), offset_of!(Dictionary, position_raw_value)),
        Row::value(0x6030, 0x00, DataType::UNSIGNED8, CONST, 57),
        Row::value(0x6030, 0x01, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, speed_value)),
        Row::value(0x6031, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x6031, 0x01, DataType::UNSIGNED8, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, speed_parameters_speed_source_selector)),
        Row::value(0x6031, 0x02, DataType::UNSIGNED16, RO, offset_of!(Dictionary, speed_parameters_speed_integration_time)),
        Row::value(0x6031, 0x03, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, speed_parameters_speed_multiplier)),
        Row::value(0x6031, 0x04, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, speed_parameters_speed_divisor)),
        Row::value(0x6200, 0x00, DataType::UNSIGNED16, RW.with(Access::WRITE_HANDLER), offset_of!(Dictionary, cycle_timer)),
        Row::value(0x6400, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::elements(0x6400, 0x01, 0x02, DataType::UNSIGNED8, RO, offset_of!(Dictionary, area_state_register)),
        Row::value(0x6401, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::elements(0x6401, 0x01, 0x02, DataType::INTEGER32, RW.with(Access::EXTRA), 8),
        Row::value(0x6402, 0x00, DataType::UNSIGNED8, CONST, 27),
        Row::elements(0x6402, 0x01, 0x02, DataType::INTEGER32, RW.with(Access::EXTRA), 10),
        Row::value(0x6500, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, operating_status)),
        Row::value(0x6501, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, singleturn_resolution)),
        Row::value(0x6502, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, number_of_distinguishable_revolutions)),
        Row::value(0x6503, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, alarms)),
        Row::value(0x6504, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, supported_alarms)),
        Row::value(0x6505, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, warnings)),
        Row::value(0x6506, 0x00, DataType::UNSIGNED16, RO, offset_of!(Dictionary, supported_warnings)),
        Row::value(0x6507, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, profile_and_software_version)),
        Row::value(0x6508, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, operating_time)),
        Row::value(0x6509, 0x00, DataType::INTEGER32, RO, offset_of!(Dictionary, offset_value)),
        Row::value(0x650A, 0x00, DataType::UNSIGNED8, CONST, 58),
        Row::elements(0x650A, 0x01, 0x03, DataType::INTEGER32, RO, offset_of!(Dictionary, module_identification)),
        Row::value(0x650B, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, encoder_serial_number)),
        Row::value(0x650D, 0x00, DataType::UNSIGNED8, RO, offset_of!(Dictionary, absolute_accuracy)),
        Row::value(0x650E, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, device_functionality)),
    ];

    #[rustfmt::skip]
    const SEEDS: [u16; 34] = [
        1, 0, 2, 1, 9, 6, 1, 1, 1, 3, 11, 8, 7, 55, 0, 33,
        0, 25, 3, 1, 3, 0, 8, 20, 39, 14, 20, 4, 13, 0, 18, 53,
        15, 194,
    ];

    #[rustfmt::skip]
    const EXTRAS: [Extra; 12] = [
        Extra::new(4, 6), // 1008sub0
        Extra::new(10, 4), // 1009sub0
        Extra::new(14, 4), // 100Asub0
        Extra::new(offset_of!(Dictionary, application_offset), 29), // 2001sub0
        Extra::new(offset_of!(Dictionary, node_id_and_baud_rate), 37), // 5F0Asub1
        Extra::new(offset_of!(Dictionary, node_id_and_baud_rate) + 1, 39), // 5F0Asub2
        Extra::new(offset_of!(Dictionary, measuring_units_per_revolution), 41), // 6001sub0
        Extra::new(offset_of!(Dictionary, preset_value), 49), // 6003sub0
        Extra::new(offset_of!(Dictionary, work_area_low_limit), 49), // 6401sub1
        Extra::new(offset_of!(Dictionary, work_area_low_limit) + 4, 49), // 6401sub2
        Extra::new(offset_of!(Dictionary, work_area_high_limit), 49), // 6402sub1
        Extra::new(offset_of!(Dictionary, work_area_high_limit) + 4, 49), // 6402sub2
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 59] = [
        0x96, 0x01, 0x02, 0x00, // 1000sub0
        0x57, 0x56, 0x35, 0x38, 0x4D, 0x52, // 1008sub0
        0x56, 0x30, 0x30, 0x31, // 1009sub0
        0x56, 0x31, 0x30, 0x30, // 100Asub0
        0x04, // 1010sub0
        0x95, 0x01, 0x00, 0x00, // 1018sub1
        0xFF, 0xFF, 0xFF, 0xFF, // 1018sub2
        0x02, // 1200sub0
        0x05, // 1800sub0
        0x00, 0x00, 0x00, 0xFC, 0xFF, 0xFF, 0xFF, 0x03, // limits of 2001sub0
        0x01, 0x7F, // limits of 5F0Asub1
        0x01, 0x07, // limits of 5F0Asub2
        0x01, 0x00, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, // limits of 6001sub0
        0x00, 0x00, 0x00, 0x00, 0xFF, 0xEF, 0xFF, 0x0F, // limits of 6003sub0
        0x01, // 6030sub0
        0x03, // 650Asub0
    ];
}
