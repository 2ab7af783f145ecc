pub mod cia406_multi {
    //! Object dictionary of `CiA 406 encoder`, generated from `cia406-multi.eds`. Do not edit.
    //!
    //! * Vendor: `Lexican`
    //! * Order code: `CiA406`
    //! * Description: `Encoder profile CiA 406, multi-sensor device, 254 channels`
    //! * 8469 values of 68 objects; 26020 bytes of RAM
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
        /// 1010sub1 `Store parameters`, `UNSIGNED32`, rw, default `0x0000_0001`
        pub store_parameters: [u32; 1],
        /// 1014h `COB-ID emergency message`, `UNSIGNED32`, rw, default `$NODEID+0x80`
        pub cob_id_emergency_message: u32,
        /// 1800sub1 `TPDO 1 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x180`
        pub tpdo_1_communication_cob_id: u32,
        /// 1801sub1 `TPDO 2 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x280`
        pub tpdo_2_communication_cob_id: u32,
        /// 1800sub2 `TPDO 1 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_1_communication_transmission_type: u8,
        /// 1801sub2 `TPDO 2 communication`, `Transmission type`, `UNSIGNED8`, rw, default `1`
        pub tpdo_2_communication_transmission_type: u8,
        _gap: [u8; 2],
        /// 1002h `Manufacturer status register`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub manufacturer_status_register: u32,
        /// 1003sub1 `Predefined error field`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub predefined_error_field: [u32; 1],
        /// 1018sub4 `Identity`, `Serial number`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub identity_serial_number: u32,
        /// 6001h `Measuring units per revolution`, `UNSIGNED32`, rw
        pub measuring_units_per_revolution: u32,
        /// 6002h `Total measuring range`, `UNSIGNED32`, rw
        pub total_measuring_range: u32,
        /// 6005sub1 `Linear encoder measuring steps`, `Position measuring step`, `UNSIGNED32`, rw
        pub linear_encoder_measuring_steps_position_measuring_step: u32,
        /// 6005sub2 `Linear encoder measuring steps`, `Speed measuring step`, `UNSIGNED32`, rw
        pub linear_encoder_measuring_steps_speed_measuring_step: u32,
        /// 6010sub1 to 6010subFE `Preset values of multi-sensor devices`, `UNSIGNED32`, rw
        pub preset_values_of_multi_sensor_devices: [u32; 254],
        /// 6020sub1 to 6020subFE `Position values of multi-sensor devices`, `INTEGER32`, ro, PDO-mappable
        pub position_values_of_multi_sensor_devices: [i32; 254],
        /// 6310sub1 to 6310subFE `Cam 1 low limit`, `INTEGER32`, rw
        pub cam_1_low_limit: [i32; 254],
        /// 6311sub1 to 6311subFE `Cam 2 low limit`, `INTEGER32`, rw
        pub cam_2_low_limit: [i32; 254],
        /// 6312sub1 to 6312subFE `Cam 3 low limit`, `INTEGER32`, rw
        pub cam_3_low_limit: [i32; 254],
        /// 6313sub1 to 6313subFE `Cam 4 low limit`, `INTEGER32`, rw
        pub cam_4_low_limit: [i32; 254],
        /// 6314sub1 to 6314subFE `Cam 5 low limit`, `INTEGER32`, rw
        pub cam_5_low_limit: [i32; 254],
        /// 6315sub1 to 6315subFE `Cam 6 low limit`, `INTEGER32`, rw
        pub cam_6_low_limit: [i32; 254],
        /// 6316sub1 to 6316subFE `Cam 7 low limit`, `INTEGER32`, rw
        pub cam_7_low_limit: [i32; 254],
        /// 6317sub1 to 6317subFE `Cam 8 low limit`, `INTEGER32`, rw
        pub cam_8_low_limit: [i32; 254],
        /// 6320sub1 to 6320subFE `Cam 1 high limit`, `INTEGER32`, rw
        pub cam_1_high_limit: [i32; 254],
        /// 6321sub1 to 6321subFE `Cam 2 high limit`, `INTEGER32`, rw
        pub cam_2_high_limit: [i32; 254],
        /// 6322sub1 to 6322subFE `Cam 3 high limit`, `INTEGER32`, rw
        pub cam_3_high_limit: [i32; 254],
        /// 6323sub1 to 6323subFE `Cam 4 high limit`, `INTEGER32`, rw
        pub cam_4_high_limit: [i32; 254],
        /// 6324sub1 to 6324subFE `Cam 5 high limit`, `INTEGER32`, rw
        pub cam_5_high_limit: [i32; 254],
        /// 6325sub1 to 6325subFE `Cam 6 high limit`, `INTEGER32`, rw
        pub cam_6_high_limit: [i32; 254],
        /// 6326sub1 to 6326subFE `Cam 7 high limit`, `INTEGER32`, rw
        pub cam_7_high_limit: [i32; 254],
        /// 6327sub1 to 6327subFE `Cam 8 high limit`, `INTEGER32`, rw
        pub cam_8_high_limit: [i32; 254],
        /// 6401sub1 to 6401subFE `Work area low limit`, `INTEGER32`, rw
        pub work_area_low_limit: [i32; 254],
        /// 6402sub1 to 6402subFE `Work area high limit`, `INTEGER32`, rw
        pub work_area_high_limit: [i32; 254],
        /// 6501h `Singleturn resolution`, `UNSIGNED32`, ro
        pub singleturn_resolution: u32,
        /// 6507h `Profile and software version`, `UNSIGNED32`, ro
        pub profile_and_software_version: u32,
        /// 6508h `Operating time`, `UNSIGNED32`, ro
        pub operating_time: u32,
        /// 6509h `Offset value`, `INTEGER32`, ro
        pub offset_value: i32,
        /// 650Asub1 to 650Asub3 `Module identification`, `INTEGER32`, ro
        ///
        /// * `[0]`: `Offset value`, default `0`
        /// * `[1]`: `Minimum position`
        /// * `[2]`: `Maximum position`
        pub module_identification: [i32; 3],
        /// 650Bh `Serial number`, `UNSIGNED32`, ro
        pub serial_number: u32,
        /// 100Ch `Guard time`, `UNSIGNED16` in ms, rw, default `0`
        pub guard_time: u16,
        /// 1017h `Producer heartbeat time`, `UNSIGNED16` in ms, rw, default `0`
        pub producer_heartbeat_time: u16,
        /// 1800sub3 `TPDO 1 communication`, `Inhibit time`, `UNSIGNED16` in multiples of 100 µs, rw, default `0`
        pub tpdo_1_communication_inhibit_time: u16,
        /// 1801sub3 `TPDO 2 communication`, `Inhibit time`, `UNSIGNED16` in multiples of 100 µs, rw, default `0`
        pub tpdo_2_communication_inhibit_time: u16,
        /// 6000h `Operating parameters`, `UNSIGNED16`, rw
        pub operating_parameters: u16,
        /// 6030sub1 to 6030subFE `Speed value`, `INTEGER16`, ro, PDO-mappable
        pub speed_value: [i16; 254],
        /// 6200h `Cyclic timer`, `UNSIGNED16`, rw, default `0`
        pub cyclic_timer: u16,
        /// 6330sub1 to 6330subFE `Cam 1 hysteresis`, `UNSIGNED16`, rw
        pub cam_1_hysteresis: [u16; 254],
        /// 6331sub1 to 6331subFE `Cam 2 hysteresis`, `UNSIGNED16`, rw
        pub cam_2_hysteresis: [u16; 254],
        /// 6332sub1 to 6332subFE `Cam 3 hysteresis`, `UNSIGNED16`, rw
        pub cam_3_hysteresis: [u16; 254],
        /// 6333sub1 to 6333subFE `Cam 4 hysteresis`, `UNSIGNED16`, rw
        pub cam_4_hysteresis: [u16; 254],
        /// 6334sub1 to 6334subFE `Cam 5 hysteresis`, `UNSIGNED16`, rw
        pub cam_5_hysteresis: [u16; 254],
        /// 6335sub1 to 6335subFE `Cam 6 hysteresis`, `UNSIGNED16`, rw
        pub cam_6_hysteresis: [u16; 254],
        /// 6336sub1 to 6336subFE `Cam 7 hysteresis`, `UNSIGNED16`, rw
        pub cam_7_hysteresis: [u16; 254],
        /// 6337sub1 to 6337subFE `Cam 8 hysteresis`, `UNSIGNED16`, rw
        pub cam_8_hysteresis: [u16; 254],
        /// 6500h `Operating status`, `UNSIGNED16`, ro
        pub operating_status: u16,
        /// 6502h `Number of distinguishable revolutions`, `UNSIGNED16`, ro
        pub number_of_distinguishable_revolutions: u16,
        /// 6503h `Alarms`, `UNSIGNED16`, ro
        pub alarms: u16,
        /// 6504h `Supported alarms`, `UNSIGNED16`, ro
        pub supported_alarms: u16,
        /// 6505h `Warnings`, `UNSIGNED16`, ro
        pub warnings: u16,
        /// 6506h `Supported warnings`, `UNSIGNED16`, ro
        pub supported_warnings: u16,
        /// 1001h `Error register`, `UNSIGNED8`, ro, default `0`
        pub error_register: u8,
        /// 1003sub0 `Predefined error field`, `Number of errors`, `UNSIGNED8`, rw, default `0`
        pub predefined_error_field_number_of_errors: u8,
        /// 100Dh `Life time factor`, `UNSIGNED8`, rw, default `0`
        pub life_time_factor: u8,
        /// 6300sub1 to 6300subFE `Cam state register`, `UNSIGNED8`, ro, PDO-mappable
        pub cam_state_register: [u8; 254],
        /// 6301sub1 to 6301subFE `Cam enable register`, `UNSIGNED8`, rwr, default `0`, PDO-mappable
        pub cam_enable_register: [u8; 254],
        /// 6302sub1 to 6302subFE `Cam polarity register`, `UNSIGNED8`, rwr, default `0`, PDO-mappable
        pub cam_polarity_register: [u8; 254],
        /// 6400sub1 to 6400subFE `Area state register`, `UNSIGNED8`, ro, PDO-mappable
        pub area_state_register: [u8; 254],
        _padding: [u8; 1],
    }
    impl Dictionary {
        /// 1000h `Device type`, `UNSIGNED32`, ro
        pub const DEVICE_TYPE: u32 = 0x000A_0196;
        /// 1008h `Manufacturer device name`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_DEVICE_NAME: &'static str = "CiA 406 encoder";
        /// 1009h `Manufacturer hardware version`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_HARDWARE_VERSION: &'static str = "1.0";
        /// 100Ah `Manufacturer software version`, `VISIBLE_STRING`, const
        pub const MANUFACTURER_SOFTWARE_VERSION: &'static str = "1.0";
        /// 1010sub0 `Store parameters`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const STORE_PARAMETERS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 1018sub0 `Identity`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const IDENTITY_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1018sub1 `Identity`, `Vendor-ID`, `UNSIGNED32`, ro
        pub const IDENTITY_VENDOR_ID: u32 = 0x0000_0000;
        /// 1018sub2 `Identity`, `Product code`, `UNSIGNED32`, ro
        pub const IDENTITY_PRODUCT_CODE: u32 = 0x0000_0000;
        /// 1018sub3 `Identity`, `Revision number`, `UNSIGNED32`, ro
        pub const IDENTITY_REVISION_NUMBER: u32 = 0x0000_0000;
        /// 1800sub0 `TPDO 1 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_1_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// 1801sub0 `TPDO 2 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_2_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// 1A00sub0 `TPDO 1 mapping`, `Number of mapped objects`, `UNSIGNED8`, const
        pub const TPDO_1_MAPPING_NUMBER_OF_MAPPED_OBJECTS: u8 = 1;
        /// 1A00sub1 `TPDO 1 mapping`, `UNSIGNED32`, const
        pub const TPDO_1_MAPPING: [u32; 1] = [0x6020_0120];
        /// 1A01sub0 `TPDO 2 mapping`, `Number of mapped objects`, `UNSIGNED8`, const
        pub const TPDO_2_MAPPING_NUMBER_OF_MAPPED_OBJECTS: u8 = 1;
        /// 1A01sub1 `TPDO 2 mapping`, `UNSIGNED32`, const
        pub const TPDO_2_MAPPING: [u32; 1] = [0x6020_0120];
        /// 6005sub0 `Linear encoder measuring steps`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const LINEAR_ENCODER_MEASURING_STEPS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 6010sub0 `Preset values of multi-sensor devices`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const PRESET_VALUES_OF_MULTI_SENSOR_DEVICES_NR_OF_OBJECTS: u8 = 254;
        /// 6020sub0 `Position values of multi-sensor devices`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const POSITION_VALUES_OF_MULTI_SENSOR_DEVICES_NR_OF_OBJECTS: u8 = 254;
        /// 6030sub0 `Speed value`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const SPEED_VALUE_NR_OF_OBJECTS: u8 = 254;
        /// 6300sub0 `Cam state register`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_STATE_REGISTER_NR_OF_OBJECTS: u8 = 254;
        /// 6301sub0 `Cam enable register`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_ENABLE_REGISTER_NR_OF_OBJECTS: u8 = 254;
        /// 6302sub0 `Cam polarity register`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_POLARITY_REGISTER_NR_OF_OBJECTS: u8 = 254;
        /// 6310sub0 `Cam 1 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_1_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6311sub0 `Cam 2 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_2_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6312sub0 `Cam 3 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_3_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6313sub0 `Cam 4 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_4_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6314sub0 `Cam 5 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_5_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6315sub0 `Cam 6 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_6_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6316sub0 `Cam 7 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_7_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6317sub0 `Cam 8 low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_8_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6320sub0 `Cam 1 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_1_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6321sub0 `Cam 2 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_2_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6322sub0 `Cam 3 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_3_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6323sub0 `Cam 4 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_4_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6324sub0 `Cam 5 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_5_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6325sub0 `Cam 6 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_6_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6326sub0 `Cam 7 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_7_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6327sub0 `Cam 8 high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_8_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6330sub0 `Cam 1 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_1_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6331sub0 `Cam 2 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_2_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6332sub0 `Cam 3 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_3_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6333sub0 `Cam 4 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_4_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6334sub0 `Cam 5 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_5_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6335sub0 `Cam 6 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_6_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6336sub0 `Cam 7 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_7_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6337sub0 `Cam 8 hysteresis`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const CAM_8_HYSTERESIS_NR_OF_OBJECTS: u8 = 254;
        /// 6400sub0 `Area state register`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const AREA_STATE_REGISTER_NR_OF_OBJECTS: u8 = 254;
        /// 6401sub0 `Work area low limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const WORK_AREA_LOW_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 6402sub0 `Work area high limit`, `NrOfObjects`, `UNSIGNED8`, ro
        pub const WORK_AREA_HIGH_LIMIT_NR_OF_OBJECTS: u8 = 254;
        /// 650Asub0 `Module identification`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const MODULE_IDENTIFICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            cob_id_sync_message: 0x0000_0080,
            store_parameters: [0x0000_0001],
            cob_id_emergency_message: 0x0000_0080,
            tpdo_1_communication_cob_id: 0x0000_0180,
            tpdo_2_communication_cob_id: 0x0000_0280,
            tpdo_1_communication_transmission_type: 254,
            tpdo_2_communication_transmission_type: 1,
            _gap: [0; 2],
            manufacturer_status_register: 0x0000_0000,
            predefined_error_field: [0x0000_0000],
            identity_serial_number: 0x0000_0000,
            measuring_units_per_revolution: 0,
            total_measuring_range: 0,
            linear_encoder_measuring_steps_position_measuring_step: 0,
            linear_encoder_measuring_steps_speed_measuring_step: 0,
            preset_values_of_multi_sensor_devices: [0; 254],
            position_values_of_multi_sensor_devices: [0; 254],
            cam_1_low_limit: [0; 254],
            cam_2_low_limit: [0; 254],
            cam_3_low_limit: [0; 254],
            cam_4_low_limit: [0; 254],
            cam_5_low_limit: [0; 254],
            cam_6_low_limit: [0; 254],
            cam_7_low_limit: [0; 254],
            cam_8_low_limit: [0; 254],
            cam_1_high_limit: [0; 254],
            cam_2_high_limit: [0; 254],
            cam_3_high_limit: [0; 254],
            cam_4_high_limit: [0; 254],
            cam_5_high_limit: [0; 254],
            cam_6_high_limit: [0; 254],
            cam_7_high_limit: [0; 254],
            cam_8_high_limit: [0; 254],
            work_area_low_limit: [0; 254],
            work_area_high_limit: [0; 254],
            singleturn_resolution: 0,
            profile_and_software_version: 0,
            operating_time: 0,
            offset_value: 0,
            module_identification: [0, 0, 0],
            serial_number: 0,
            guard_time: 0,
            producer_heartbeat_time: 0,
            tpdo_1_communication_inhibit_time: 0,
            tpdo_2_communication_inhibit_time: 0,
            operating_parameters: 0,
            speed_value: [0; 254],
            cyclic_timer: 0,
            cam_1_hysteresis: [0; 254],
            cam_2_hysteresis: [0; 254],
            cam_3_hysteresis: [0; 254],
            cam_4_hysteresis: [0; 254],
            cam_5_hysteresis: [0; 254],
            cam_6_hysteresis: [0; 254],
            cam_7_hysteresis: [0; 254],
            cam_8_hysteresis: [0; 254],
            operating_status: 0,
            number_of_distinguishable_revolutions: 0,
            alarms: 0,
            supported_alarms: 0,
            warnings: 0,
            supported_warnings: 0,
            error_register: 0,
            predefined_error_field_number_of_errors: 0,
            life_time_factor: 0,
            cam_state_register: [0; 254],
            cam_enable_register: [0; 254],
            cam_polarity_register: [0; 254],
            area_state_register: [0; 254],
            _padding: [0; 1],
        };
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                cob_id_emergency_message: node_id.plus_u32(0x0000_0080),
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
        type Buffer = [u8; 8];
        type Pdos = lexican_runtime::pdo::Pdos<2, 0, 2>;
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
    const SIZE: usize = 26020;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };

    const TABLE: Table<'static> = Table {
        entries: &place::<8822>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 118] = [
        Row::value(0x1000, 0x00, DataType::UNSIGNED32, CONST, 0),
        Row::value(0x1001, 0x00, DataType::UNSIGNED8, RO, offset_of!(Dictionary, error_register)),
        Row::value(0x1002, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, manufacturer_status_register)),
        Row::value(0x1003, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, predefined_error_field_number_of_errors)),
        Row::value(0x1003, 0x01, DataType::UNSIGNED32, RO.with(Access::COUNTED), offset_of!(Dictionary, predefined_error_field)),
        Row::value(0x1005, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, cob_id_sync_message)),
        Row::value(0x1008, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 0),
        Row::value(0x1009, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 1),
        Row::value(0x100A, 0x00, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 2),
        Row::value(0x100C, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, guard_time)),
        Row::value(0x100D, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, life_time_factor)),
        Row::value(0x1010, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x1010, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, store_parameters)),
        Row::value(0x1014, 0x00, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, cob_id_emergency_message)),
        Row::value(0x1017, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, producer_heartbeat_time)),
        Row::value(0x1018, 0x00, DataType::UNSIGNED8, CONST, 23),
        Row::value(0x1018, 0x01, DataType::UNSIGNED32, CONST, 24),
        Row::value(0x1018, 0x02, DataType::UNSIGNED32, CONST, 24),
        Row::value(0x1018, 0x03, DataType::UNSIGNED32, CONST, 24),
        Row::value(0x1018, 0x04, DataType::UNSIGNED32, RO, offset_of!(Dictionary, identity_serial_number)),
        Row::value(0x1800, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::value(0x1800, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_1_communication_cob_id)),
        Row::value(0x1800, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_1_communication_transmission_type)),
        Row::value(0x1800, 0x03, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_1_communication_inhibit_time)),
        Row::value(0x1801, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::value(0x1801, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_2_communication_cob_id)),
        Row::value(0x1801, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_2_communication_transmission_type)),
        Row::value(0x1801, 0x03, DataType::UNSIGNED16, RW, offset_of!(Dictionary, tpdo_2_communication_inhibit_time)),
        Row::value(0x1A00, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x1A00, 0x01, DataType::UNSIGNED32, CONST, 29),
        Row::value(0x1A01, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x1A01, 0x01, DataType::UNSIGNED32, CONST, 29),
        Row::value(0x6000, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, operating_parameters)),
        Row::value(0x6001, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, measuring_units_per_revolution)),
        Row::value(0x6002, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, total_measuring_range)),
        Row::value(0x6005, 0x00, DataType::UNSIGNED8, CONST, 33),
        Row::value(0x6005, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, linear_encoder_measuring_steps_position_measuring_step)),
        Row::value(0x6005, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, linear_encoder_measuring_steps_speed_measuring_step)),
        Row::value(0x6010, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6010, 0x01, 0xFE, DataType::UNSIGNED32, RW, offset_of!(Dictionary, preset_values_of_multi_sensor_devices)),
        Row::value(0x6020, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6020, 0x01, 0xFE, DataType::INTEGER32, RO.with(Access::TPDO), offset_of!(Dictionary, position_values_of_multi_sensor_devices)),
        Row::value(0x6030, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6030, 0x01, 0xFE, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, speed_value)),
        Row::value(0x6200, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cyclic_timer)),
        Row::value(0x6300, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6300, 0x01, 0xFE, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, cam_state_register)),
        Row::value(0x6301, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6301, 0x01, 0xFE, DataType::UNSIGNED8, RW.with(Access::TPDO), offset_of!(Dictionary, cam_enable_register)),
        Row::value(0x6302, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6302, 0x01, 0xFE, DataType::UNSIGNED8, RW.with(Access::TPDO), offset_of!(Dictionary, cam_polarity_register)),
        Row::value(0x6310, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6310, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_1_low_limit)),
        Row::value(0x6311, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6311, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_2_low_limit)),
        Row::value(0x6312, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6312, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_3_low_limit)),
        Row::value(0x6313, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6313, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_4_low_limit)),
        Row::value(0x6314, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6314, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_5_low_limit)),
        Row::value(0x6315, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6315, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_6_low_limit)),
        Row::value(0x6316, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6316, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_7_low_limit)),
        Row::value(0x6317, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6317, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_8_low_limit)),
        Row::value(0x6320, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6320, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_1_high_limit)),
        Row::value(0x6321, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6321, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_2_high_limit)),
        Row::value(0x6322, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6322, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_3_high_limit)),
        Row::value(0x6323, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6323, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_4_high_limit)),
        Row::value(0x6324, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6324, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_5_high_limit)),
        Row::value(0x6325, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6325, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_6_high_limit)),
        Row::value(0x6326, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6326, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_7_high_limit)),
        Row::value(0x6327, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6327, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_8_high_limit)),
        Row::value(0x6330, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6330, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_1_hysteresis)),
        Row::value(0x6331, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6331, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_2_hysteresis)),
        Row::value(0x6332, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6332, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_3_hysteresis)),
        Row::value(0x6333, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6333, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_4_hysteresis)),
        Row::value(0x6334, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6334, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_5_hysteresis)),
        Row::value(0x6335, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6335, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_6_hysteresis)),
        Row::value(0x6336, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6336, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_7_hysteresis)),
        Row::value(0x6337, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6337, 0x01, 0xFE, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_8_hysteresis)),
        Row::value(0x6400, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6400, 0x01, 0xFE, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, area_state_register)),
        Row::value(0x6401, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6401, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, work_area_low_limit)),
        Row::value(0x6402, 0x00, DataType::UNSIGNED8, CONST, 34),
        Row::elements(0x6402, 0x01, 0xFE, DataType::INTEGER32, RW, offset_of!(Dictionary, work_area_high_limit)),
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
        Row::value(0x650A, 0x00, DataType::UNSIGNED8, CONST, 28),
        Row::elements(0x650A, 0x01, 0x03, DataType::INTEGER32, RO, offset_of!(Dictionary, module_identification)),
        Row::value(0x650B, 0x00, DataType::UNSIGNED32, RO, offset_of!(Dictionary, serial_number)),
    ];

    #[rustfmt::skip]
    const SEEDS: [u16; 2823] = [
        1, 2, 0, 3, 5, 8, 18, 18, 2, 0, 15, 0, 24, 0, 6, 1,
        0, 18, 1, 3, 5, 13, 13, 1, 1, 0, 14, 7, 4, 19, 31, 4,
        0, 0, 13, 10, 30, 1, 0, 0, 31, 0, 55, 18, 25, 16, 0, 0,
        0, 2, 2, 15, 12, 23, 116, 0, 8, 11, 49, 10, 0, 0, 0, 3,
        5, 15, 14, 22, 4, 0, 0, 0, 2, 2, 25, 21, 0, 18, 1, 2,
        9, 8, 8, 0, 7, 0, 11, 2, 0, 11, 13, 7, 0, 0, 0, 19,
        2, 6, 0, 0, 26, 1, 0, 16, 55, 13, 0, 2, 0, 11, 1, 1,
        6, 8, 34, 0, 2, 10, 17, 41, 0, 0, 0, 86, 1, 3, 5, 53,
        11, 0, 0, 0, 32, 15, 0, 1, 1, 43, 1, 0, 10, 30, 4, 3,
        0, 0, 0, 1, 1, 8, 60, 21, 0, 0, 0, 34, 72, 0, 1, 6,
        0, 1, 13, 18, 35, 14, 0, 0, 0, 7, 2, 1, 2, 15, 5, 4,
        0, 8, 8, 6, 1, 0, 33, 37, 4, 9, 3, 102, 20, 0, 0, 5,
        24, 30, 0, 6, 79, 19, 0, 0, 49, 15, 16, 3, 0, 18, 34, 3,
        4, 45, 11, 3, 0, 0, 0, 5, 18, 0, 6, 0, 83, 0, 5, 5,
        3, 0, 0, 0, 2, 13, 3, 0, 1, 64, 0, 1, 0, 12, 0, 3,
        0, 1, 11, 61, 2, 0, 7, 6, 0, 1, 0, 28, 17, 115, 2, 7,
        53, 33, 16, 0, 123, 7, 0, 0, 1, 55, 6, 3, 0, 1, 10, 0,
        9, 1, 4, 8, 39, 0, 1, 2, 36, 3, 0, 12, 21, 0, 0, 0,
        14, 39, 17, 0, 1, 22, 14, 5, 3, 33, 11, 0, 0, 2, 4, 37,
        54, 0, 1, 0, 0, 3, 0, 13, 0, 2, 0, 0, 53, 29, 2, 0,
        23, 0, 0, 0, 0, 14, 64, 53, 1, 12, 0, 0, 13, 0, 19, 11,
        49, 0, 0, 85, 13, 49, 0, 23, 37, 0, 3, 0, 104, 2, 25, 2,
        5, 11, 0, 4, 2, 1, 31, 0, 7, 0, 18, 1, 2, 1, 71, 3,
        0, 25, 1, 11, 0, 5, 0, 1, 1, 0, 14, 0, 56, 1, 0, 1,
        0, 14, 3, 2, 1, 1, 1, 0, 20, 0, 23, 3, 5, 1, 0, 6,
        6, 8, 11, 9, 5, 0, 12, 1, 7, 9, 42, 0, 11, 0, 0, 12,
        0, 28, 37, 10, 2, 0, 1, 14, 36, 1, 3, 2, 0, 55, 0, 7,
        129, 6, 7, 1, 10, 0, 0, 1, 8, 7, 24, 71, 0, 35, 15, 198,
        0, 1, 2, 0, 44, 0, 1, 183, 5, 1, 0, 3, 0, 0, 1, 12,
        5, 0, 72, 0, 0, 1, 6, 3, 2, 5, 0, 2, 0, 4, 67, 0,
        2, 0, 27, 40, 41, 2, 0, 1, 0, 1, 0, 2, 0, 3, 12, 1,
        2, 0, 5, 2, 0, 8, 13, 60, 0, 13, 3, 7, 3, 1, 0, 0,
        20, 1, 0, 39, 13, 16, 0, 11, 0, 35, 1, 26, 23, 5, 160, 0,
        0, 5, 86, 5, 1, 1, 0, 1, 3, 4, 5, 6, 7, 0, 0, 0,
        40, 8, 0, 0, 0, 54, 1, 1, 0, 16, 34, 1, 2, 0, 1, 3,
        1, 3, 39, 27, 0, 1, 0, 16, 10, 11, 0, 0, 17, 0, 0, 16,
        8, 13, 0, 6, 0, 10, 20, 0, 22, 4, 16, 1, 2, 3, 35, 68,
        5, 0, 0, 0, 32, 6, 1, 39, 4, 0, 0, 0, 0, 19, 0, 9,
        1, 20, 1, 4, 6, 31, 17, 0, 0, 0, 3, 3, 2, 0, 20, 13,
        1, 0, 5, 16, 16, 1, 0, 22, 23, 2, 0, 41, 4, 36, 0, 0,
        5, 39, 2, 0, 2, 7, 16, 8, 1, 15, 0, 11, 0, 0, 0, 51,
        14, 0, 16, 31, 22, 2, 1, 0, 6, 24, 0, 1, 2, 110, 25, 4,
        0, 76, 1, 0, 1, 0, 28, 2, 3, 16, 19, 4, 4, 0, 18, 43,
        45, 0, 6, 6, 94, 1, 3, 2, 89, 0, 1, 1, 5, 3, 24, 0,
        2, 61, 5, 18, 0, 72, 27, 0, 0, 9, 27, 94, 4, 0, 24, 13,
        0, 1, 0, 3, 26, 144, 0, 21, 1, 0, 6, 0, 11, 10, 25, 1,
        1, 36, 2, 0, 1, 0, 301, 17, 0, 1, 18, 1, 65, 0, 0, 37,
        20, 7, 0, 24, 25, 0, 7, 1, 26, 34, 1, 0, 1, 3, 7, 5,
        5, 108, 3, 0, 0, 2, 17, 3, 9, 0, 1, 11, 0, 0, 1, 32,
        32, 48, 0, 1, 21, 33, 68, 5, 17, 14, 0, 0, 2, 41, 137, 14,
        1, 1, 13, 0, 30, 0, 48, 7, 0, 11, 0, 27, 15, 87, 0, 66,
        6, 0, 2, 1, 31, 46, 40, 0, 2, 65, 0, 93, 0, 29, 13, 0,
        2, 1, 5, 14, 41, 0, 55, 3, 0, 16, 1, 15, 50, 11, 0, 0,
        29, 26, 60, 2, 31, 1, 0, 3, 1, 5, 8, 48, 0, 1, 2, 0,
        98, 0, 5, 12, 2, 7, 0, 10, 3, 27, 0, 33, 14, 0, 2, 1,
        1, 16, 33, 1, 1, 13, 0, 13, 1, 8, 36, 9, 2, 1, 3, 4,
        47, 0, 24, 3, 0, 86, 0, 2, 23, 20, 0, 0, 10, 0, 27, 1,
        13, 5, 0, 22, 0, 40, 8, 2, 0, 2, 0, 0, 8, 2, 1, 26,
        21, 1, 0, 11, 0, 20, 0, 10, 2, 0, 19, 2, 22, 40, 2, 7,
        1, 15, 0, 13, 1, 0, 5, 25, 0, 1, 46, 1, 59, 2, 1, 0,
        0, 5, 1, 70, 107, 13, 43, 2, 1, 0, 119, 1, 29, 2, 7, 26,
        0, 2, 72, 49, 28, 1, 2, 0, 0, 1, 8, 81, 21, 3, 1, 16,
        0, 16, 4, 7, 16, 12, 16, 1, 0, 15, 39, 34, 4, 9, 0, 14,
        10, 1, 47, 6, 85, 1, 2, 0, 7, 2, 1, 1, 0, 3, 0, 1,
        3, 24, 97, 1, 6, 0, 9, 45, 1, 8, 20, 1, 0, 4, 0, 50,
        5, 3, 1, 0, 52, 0, 6, 8, 26, 14, 1, 2, 0, 17, 9, 1,
        0, 7, 9, 0, 6, 23, 73, 13, 1, 2, 0, 4, 7, 1, 19, 34,
        9, 0, 2, 0, 1, 1, 0, 6, 24, 14, 2, 4, 84, 146, 2, 0,
        1, 0, 41, 30, 9, 19, 12, 12, 13, 1, 0, 40, 69, 0, 6, 6,
        63, 25, 2, 37, 29, 2, 0, 5, 0, 18, 2, 0, 30, 5, 13, 0,
        1, 92, 5, 3, 0, 2, 0, 21, 18, 2, 10, 85, 21, 0, 8, 13,
        62, 115, 1, 3, 6, 83, 4, 18, 49, 13, 13, 0, 2, 22, 22, 55,
        20, 0, 122, 9, 1, 2, 58, 8, 0, 0, 2, 2, 19, 3, 13, 0,
        2, 23, 2, 5, 35, 9, 73, 2, 9, 0, 11, 94, 2, 0, 28, 71,
        0, 1, 31, 2, 1, 9, 63, 54, 1, 0, 1, 34, 14, 10, 0, 3,
        12, 91, 36, 23, 26, 44, 0, 0, 1, 65, 28, 52, 0, 23, 16, 18,
        5, 1, 4, 30, 0, 0, 1, 13, 158, 29, 24, 66, 2, 0, 3, 1,
        3, 59, 65, 0, 16, 10, 11, 77, 0, 16, 0, 0, 0, 1, 14, 34,
        10, 27, 74, 29, 0, 7, 1, 10, 6, 7, 3, 0, 1, 6, 121, 0,
        41, 5, 0, 2, 1, 80, 20, 22, 0, 7, 17, 0, 15, 0, 36, 47,
        0, 1, 0, 16, 11, 76, 0, 4, 24, 0, 23, 1, 14, 82, 41, 0,
        0, 26, 16, 101, 6, 58, 13, 0, 0, 1, 45, 5, 43, 1, 34, 1,
        0, 69, 0, 21, 50, 3, 3, 0, 1, 13, 3, 1, 14, 51, 0, 0,
        1, 66, 11, 58, 7, 26, 2, 0, 144, 1, 26, 15, 8, 2, 1, 19,
        30, 145, 0, 75, 4, 0, 10, 1, 9, 89, 41, 3, 5, 5, 0, 7,
        1, 63, 2, 0, 36, 1, 240, 8, 48, 0, 15, 13, 0, 42, 1, 15,
        56, 8, 6, 0, 43, 0, 136, 0, 109, 3, 0, 28, 0, 15, 13, 134,
        1, 9, 31, 0, 5, 1, 0, 34, 4, 30, 1, 19, 48, 29, 3, 1,
        2, 0, 19, 0, 43, 14, 2, 38, 1, 14, 0, 135, 1, 73, 97, 7,
        49, 0, 1, 2, 171, 2, 24, 4, 0, 18, 0, 3, 2, 18, 26, 1,
        2, 0, 5, 0, 16, 6, 5, 63, 0, 4, 1, 35, 4, 2, 11, 0,
        5, 0, 11, 9, 33, 56, 0, 23, 0, 122, 26, 2, 3, 0, 17, 0,
        4, 0, 185, 80, 2, 33, 0, 1, 35, 4, 140, 0, 41, 0, 76, 0,
        62, 14, 4, 2, 0, 19, 3, 24, 81, 37, 16, 1, 6, 0, 6, 26,
        9, 2, 17, 22, 1, 0, 11, 77, 112, 6, 2, 0, 93, 5, 20, 8,
        2, 21, 1, 3, 0, 133, 17, 54, 37, 10, 4, 0, 9, 22, 153, 66,
        0, 17, 0, 0, 22, 4, 145, 4, 6, 0, 1, 8, 197, 41, 9, 6,
        24, 14, 42, 29, 59, 20, 42, 0, 25, 6, 35, 34, 1, 0, 11, 79,
        0, 0, 5, 13, 19, 3, 2, 0, 18, 11, 2, 62, 22, 11, 0, 1,
        0, 15, 129, 2, 29, 17, 4, 36, 99, 125, 29, 14, 0, 2, 0, 5,
        10, 35, 21, 6, 2, 0, 2, 18, 3, 65, 0, 22, 20, 120, 5, 1,
        0, 17, 0, 0, 2, 0, 1, 4, 1, 55, 106, 1, 0, 1, 33, 0,
        36, 2, 3, 0, 53, 17, 36, 76, 113, 41, 0, 5, 22, 23, 200, 1,
        17, 6, 25, 7, 0, 36, 0, 15, 0, 7, 37, 192, 41, 24, 9, 35,
        37, 0, 0, 55, 101, 6, 0, 23, 2, 90, 5, 252, 13, 3, 0, 7,
        0, 69, 0, 47, 5, 9, 6, 0, 11, 2, 116, 28, 0, 0, 0, 5,
        19, 0, 23, 1, 0, 0, 0, 1, 2, 37, 53, 3, 0, 61, 42, 80,
        0, 29, 49, 0, 2, 0, 38, 71, 40, 0, 127, 83, 0, 22, 0, 137,
        5, 8, 8, 0, 43, 8, 74, 2, 30, 42, 0, 13, 0, 32, 16, 33,
        6, 0, 96, 0, 12, 3, 219, 1, 0, 0, 0, 16, 7, 0, 8, 5,
        17, 0, 83, 1, 24, 158, 134, 0, 6, 27, 2, 41, 8, 79, 0, 0,
        22, 2, 53, 148, 200, 40, 7, 57, 0, 3, 1, 0, 13, 1, 0, 2,
        274, 28, 135, 2, 14, 21, 0, 88, 2, 31, 145, 103, 5, 65, 20, 0,
        1, 0, 198, 5, 0, 0, 1, 22, 22, 71, 0, 27, 2, 0, 10, 0,
        66, 145, 0, 0, 3, 59, 0, 104, 0, 12, 7, 0, 108, 0, 6, 10,
        74, 0, 8, 0, 0, 33, 1, 33, 38, 0, 30, 1, 27, 13, 3, 9,
        131, 1, 0, 1, 1, 42, 74, 62, 1, 0, 3, 0, 62, 12, 15, 96,
        4, 15, 1, 37, 2, 1, 2, 0, 3, 0, 2, 1, 2, 9, 26, 13,
        0, 10, 0, 11, 2, 58, 95, 3, 31, 0, 0, 49, 204, 1, 53, 5,
        0, 41, 2, 19, 28, 4, 64, 3, 4, 0, 79, 0, 6, 2, 0, 0,
        3, 4, 9, 54, 40, 1, 4, 0, 264, 17, 40, 265, 7, 4, 1, 0,
        0, 88, 2, 2, 2, 0, 1, 10, 42, 157, 78, 27, 2, 27, 3, 3,
        9, 3, 24, 2, 25, 0, 6, 6, 58, 122, 1, 1, 0, 48, 41, 6,
        20, 4, 24, 1, 1, 0, 3, 152, 0, 2, 16, 233, 3, 2, 1, 141,
        2, 0, 1, 0, 87, 38, 9, 206, 25, 4, 0, 0, 0, 103, 16, 13,
        10, 3, 278, 7, 7, 62, 3, 10, 0, 4, 0, 73, 12, 12, 3, 6,
        38, 3, 1, 1, 0, 12, 2, 2, 0, 197, 2, 26, 36, 5, 11, 1,
        2, 0, 50, 584, 0, 4, 12, 73, 0, 299, 9, 13, 2, 1, 2, 0,
        193, 2, 2, 13, 428, 9, 0, 3, 0, 13, 1, 0, 8, 14, 70, 0,
        8, 93, 40, 11, 0, 2, 0, 173, 195, 65, 18, 67, 29, 7, 5, 23,
        176, 65, 4, 2, 2, 71, 2, 21, 47, 10, 6, 0, 20, 15, 11, 100,
        9, 76, 6, 11, 7, 0, 60, 13, 78, 2, 0, 38, 133, 44, 9, 0,
        36, 12, 0, 3, 120, 6, 216, 0, 57, 60, 118, 46, 34, 69, 28, 0,
        1, 2, 93, 321, 4, 0, 27, 71, 76, 13, 1, 16, 47, 0, 1, 11,
        22, 132, 22, 94, 19, 30, 0, 14, 2, 14, 118, 171, 24, 29, 36, 22,
        59, 1, 43, 85, 0, 1, 1, 45, 18, 15, 28, 61, 33, 0, 12, 1,
        43, 206, 60, 3, 0, 37, 20, 46, 1, 8, 379, 0, 2, 8, 106, 43,
        51, 1, 45, 309, 16, 10, 6, 67, 34, 0, 1, 1, 3, 2, 131, 2,
        69, 193, 0, 16, 1, 66, 174, 123, 2, 37, 6, 1, 8, 6, 68, 15,
        0, 1, 6, 114, 134, 30, 24, 72, 28, 0, 29, 2, 47, 48, 8, 6,
        2, 36, 45, 139, 1, 34, 22, 14, 17, 1, 175, 86, 240, 69, 99, 67,
        0, 54, 1, 16, 28, 0, 2, 1, 214, 9, 81, 7, 15, 76, 0, 4,
        2, 18, 159, 23, 0, 25, 47, 0, 40, 1, 55, 25, 0, 319, 2, 132,
        17, 20, 18, 10, 63, 0, 31, 2, 242, 160, 0, 26, 11, 1, 41, 230,
        24, 68, 27, 0, 14, 1, 179, 26, 194, 1, 4, 3, 0, 59, 3, 6,
        38, 114, 34, 1, 142, 28, 33, 8, 58, 9, 0, 65, 8, 26, 55, 26,
        43, 2, 1, 0, 10, 3, 13, 84, 1, 0, 1, 36, 3, 13, 0, 40,
        14, 0, 181, 1, 27, 10, 5, 262, 0, 0, 0, 4, 1, 74, 22, 0,
        172, 0, 6, 1, 446, 22, 0, 10, 0, 199, 12, 20, 171, 16, 121, 2,
        2, 0, 76, 7, 14, 0, 0, 83, 0, 1, 0, 164, 6, 0, 15, 0,
        27, 17, 4, 26, 4, 102, 1, 42, 44, 18, 8, 18, 3, 0, 132, 43,
        20, 6, 124, 145, 2, 36, 0, 2, 32, 47, 5, 21, 77, 1, 18, 8,
        8, 214, 1, 4, 0, 120, 14, 59, 42, 6, 12, 4, 14, 0, 224, 1,
        6, 2, 4, 107, 0, 7, 424, 150, 376, 9, 23, 0, 83, 0, 0, 23,
        5, 0, 0, 2, 30, 3, 42, 70, 16, 0, 110, 12, 9, 134, 85, 16,
        1, 25, 0, 0, 154, 1, 34, 25, 54, 65, 9, 11, 47, 325, 3, 15,
        0, 64, 35, 48, 244, 59, 13, 0, 3, 0, 14, 34, 3, 2, 9, 63,
        15, 2, 51, 90, 4, 1, 2, 0, 0, 87, 7, 15, 54, 11, 6, 1,
        1, 155, 26, 0, 23, 8, 44, 52, 69, 244, 76, 60, 5, 1, 5, 71,
        425, 1, 82, 8, 2, 50, 9, 12, 57, 27, 1, 23, 28, 343, 18, 66,
        49, 56, 12, 0, 39, 18, 158, 150, 4, 89, 2, 134, 94, 0, 51, 134,
        131, 7, 0, 0, 13, 18, 12, 0, 69, 17, 55, 0, 5, 139, 13, 0,
        97, 54, 26, 73, 1, 76, 28, 0, 2, 1, 29, 5, 73, 0, 1, 40,
        9, 11, 3, 66, 53, 0, 1, 2, 38, 36, 319, 34, 80, 233, 0, 0,
        9, 6, 208, 222, 66, 0, 52, 65, 49, 0, 88, 297, 0, 1, 1, 138,
        67, 84, 10, 8, 82, 14, 3, 2, 70, 36, 18, 0, 1, 31, 19, 55,
        0, 39, 425, 0, 15, 0, 227, 247, 531, 12, 32, 27, 4, 1, 76, 95,
        54, 0, 1, 9, 10, 19, 38, 1, 50, 1, 0, 145, 1, 134, 242, 656,
        2, 2, 102, 34, 3, 14, 76, 43, 0, 2, 23, 92, 29, 69, 28, 101,
        32, 0, 0, 3, 5, 444, 0, 6, 1, 94, 9, 12, 1, 25, 24, 0,
        39, 2, 145, 86, 207, 2, 200, 245, 0, 190, 1, 273, 12, 0, 58, 1,
        42, 58, 228, 6, 87, 42, 0, 70, 16, 7, 137, 74, 2, 1, 221, 5,
        295, 9, 129, 60, 0, 9, 0, 90, 11, 12, 6, 4, 10, 0, 68, 1,
        1, 237, 1, 26, 0, 120, 10, 375, 5, 112, 0, 0, 15, 7, 16, 135,
        34, 9, 2, 101, 0, 178, 11, 29, 54, 31, 149, 1, 270, 6, 65, 6,
        2, 27, 0, 42, 1, 596, 27, 30, 488, 0, 18, 0, 151, 3, 62, 14,
        0, 101, 1, 768, 8, 33, 1,
    ];

    #[rustfmt::skip]
    const EXTRAS: [Extra; 3] = [
        Extra::new(4, 15), // 1008sub0
        Extra::new(19, 3), // 1009sub0
        Extra::new(19, 3), // 100Asub0
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 35] = [
        0x96, 0x01, 0x0A, 0x00, // 1000sub0
        0x43, 0x69, 0x41, 0x20, 0x34, 0x30, 0x36, 0x20, 0x65, 0x6E, 0x63, 0x6F, 0x64, 0x65, 0x72, // 1008sub0
        0x31, 0x2E, 0x30, // 1009sub0
        0x01, // 1010sub0
        0x04, // 1018sub0
        0x00, 0x00, 0x00, 0x00, // 1018sub1
        0x03, // 1800sub0
        0x20, 0x01, 0x20, 0x60, // 1A00sub1
        0x02, // 6005sub0
        0xFE, // 6010sub0
    ];
}
