pub mod cia406 {
    //! Object dictionary of `CiA 406 encoder`, generated from `cia406.eds`. Do not edit.
    //!
    //! * Vendor: `Lexican`
    //! * Order code: `CiA406`
    //! * Description: `Encoder profile CiA 406, one channel`
    //! * 118 values of 68 objects; 216 bytes of RAM
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
        /// 6003h `Preset value`, `UNSIGNED32`, rw
        pub preset_value: u32,
        /// 6004h `Position value`, `UNSIGNED32`, ro, PDO-mappable
        pub position_value: u32,
        /// 6005sub1 `Linear encoder measuring steps`, `Position measuring step`, `UNSIGNED32`, rw
        pub linear_encoder_measuring_steps_position_measuring_step: u32,
        /// 6005sub2 `Linear encoder measuring steps`, `Speed measuring step`, `UNSIGNED32`, rw
        pub linear_encoder_measuring_steps_speed_measuring_step: u32,
        /// 6310sub1 `Cam 1 low limit`, `INTEGER32`, rw
        pub cam_1_low_limit: [i32; 1],
        /// 6311sub1 `Cam 2 low limit`, `INTEGER32`, rw
        pub cam_2_low_limit: [i32; 1],
        /// 6312sub1 `Cam 3 low limit`, `INTEGER32`, rw
        pub cam_3_low_limit: [i32; 1],
        /// 6313sub1 `Cam 4 low limit`, `INTEGER32`, rw
        pub cam_4_low_limit: [i32; 1],
        /// 6314sub1 `Cam 5 low limit`, `INTEGER32`, rw
        pub cam_5_low_limit: [i32; 1],
        /// 6315sub1 `Cam 6 low limit`, `INTEGER32`, rw
        pub cam_6_low_limit: [i32; 1],
        /// 6316sub1 `Cam 7 low limit`, `INTEGER32`, rw
        pub cam_7_low_limit: [i32; 1],
        /// 6317sub1 `Cam 8 low limit`, `INTEGER32`, rw
        pub cam_8_low_limit: [i32; 1],
        /// 6320sub1 `Cam 1 high limit`, `INTEGER32`, rw
        pub cam_1_high_limit: [i32; 1],
        /// 6321sub1 `Cam 2 high limit`, `INTEGER32`, rw
        pub cam_2_high_limit: [i32; 1],
        /// 6322sub1 `Cam 3 high limit`, `INTEGER32`, rw
        pub cam_3_high_limit: [i32; 1],
        /// 6323sub1 `Cam 4 high limit`, `INTEGER32`, rw
        pub cam_4_high_limit: [i32; 1],
        /// 6324sub1 `Cam 5 high limit`, `INTEGER32`, rw
        pub cam_5_high_limit: [i32; 1],
        /// 6325sub1 `Cam 6 high limit`, `INTEGER32`, rw
        pub cam_6_high_limit: [i32; 1],
        /// 6326sub1 `Cam 7 high limit`, `INTEGER32`, rw
        pub cam_7_high_limit: [i32; 1],
        /// 6327sub1 `Cam 8 high limit`, `INTEGER32`, rw
        pub cam_8_high_limit: [i32; 1],
        /// 6401sub1 `Work area low limit`, `INTEGER32`, rw
        pub work_area_low_limit: [i32; 1],
        /// 6402sub1 `Work area high limit`, `INTEGER32`, rw
        pub work_area_high_limit: [i32; 1],
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
        /// 6030sub1 `Speed value`, `INTEGER16`, ro, PDO-mappable
        pub speed_value: [i16; 1],
        /// 6200h `Cyclic timer`, `UNSIGNED16`, rw, default `0`
        pub cyclic_timer: u16,
        /// 6330sub1 `Cam 1 hysteresis`, `UNSIGNED16`, rw
        pub cam_1_hysteresis: [u16; 1],
        /// 6331sub1 `Cam 2 hysteresis`, `UNSIGNED16`, rw
        pub cam_2_hysteresis: [u16; 1],
        /// 6332sub1 `Cam 3 hysteresis`, `UNSIGNED16`, rw
        pub cam_3_hysteresis: [u16; 1],
        /// 6333sub1 `Cam 4 hysteresis`, `UNSIGNED16`, rw
        pub cam_4_hysteresis: [u16; 1],
        /// 6334sub1 `Cam 5 hysteresis`, `UNSIGNED16`, rw
        pub cam_5_hysteresis: [u16; 1],
        /// 6335sub1 `Cam 6 hysteresis`, `UNSIGNED16`, rw
        pub cam_6_hysteresis: [u16; 1],
        /// 6336sub1 `Cam 7 hysteresis`, `UNSIGNED16`, rw
        pub cam_7_hysteresis: [u16; 1],
        /// 6337sub1 `Cam 8 hysteresis`, `UNSIGNED16`, rw
        pub cam_8_hysteresis: [u16; 1],
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
        /// 6300sub1 `Cam state register`, `UNSIGNED8`, ro, PDO-mappable
        pub cam_state_register: [u8; 1],
        /// 6301sub1 `Cam enable register`, `UNSIGNED8`, rwr, default `0`, PDO-mappable
        pub cam_enable_register: [u8; 1],
        /// 6302sub1 `Cam polarity register`, `UNSIGNED8`, rwr, default `0`, PDO-mappable
        pub cam_polarity_register: [u8; 1],
        /// 6400sub1 `Area state register`, `UNSIGNED8`, ro, PDO-mappable
        pub area_state_register: [u8; 1],
        _padding: [u8; 3],
    }
    impl Dictionary {
        /// 1000h `Device type`, `UNSIGNED32`, ro
        pub const DEVICE_TYPE: u32 = 0x0002_0196;
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
        pub const TPDO_1_MAPPING: [u32; 1] = [0x6004_0020];
        /// 1A01sub0 `TPDO 2 mapping`, `Number of mapped objects`, `UNSIGNED8`, const
        pub const TPDO_2_MAPPING_NUMBER_OF_MAPPED_OBJECTS: u8 = 1;
        /// 1A01sub1 `TPDO 2 mapping`, `UNSIGNED32`, const
        pub const TPDO_2_MAPPING: [u32; 1] = [0x6004_0020];
        /// 6005sub0 `Linear encoder measuring steps`, `Highest sub-index supported`, `UNSIGNED8`, ro
        pub const LINEAR_ENCODER_MEASURING_STEPS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 6030sub0 `Speed value`, `Number of available channels`, `UNSIGNED8`, ro
        pub const SPEED_VALUE_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6300sub0 `Cam state register`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_STATE_REGISTER_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6301sub0 `Cam enable register`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_ENABLE_REGISTER_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6302sub0 `Cam polarity register`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_POLARITY_REGISTER_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6310sub0 `Cam 1 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_1_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6311sub0 `Cam 2 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_2_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6312sub0 `Cam 3 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_3_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6313sub0 `Cam 4 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_4_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6314sub0 `Cam 5 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_5_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6315sub0 `Cam 6 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_6_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6316sub0 `Cam 7 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_7_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6317sub0 `Cam 8 low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_8_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6320sub0 `Cam 1 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_1_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6321sub0 `Cam 2 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_2_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6322sub0 `Cam 3 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_3_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6323sub0 `Cam 4 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_4_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6324sub0 `Cam 5 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_5_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6325sub0 `Cam 6 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_6_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6326sub0 `Cam 7 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_7_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6327sub0 `Cam 8 high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_8_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6330sub0 `Cam 1 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_1_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6331sub0 `Cam 2 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_2_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6332sub0 `Cam 3 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_3_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6333sub0 `Cam 4 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_4_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6334sub0 `Cam 5 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_5_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6335sub0 `Cam 6 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_6_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6336sub0 `Cam 7 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_7_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6337sub0 `Cam 8 hysteresis`, `Number of available channels`, `UNSIGNED8`, ro
        pub const CAM_8_HYSTERESIS_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6400sub0 `Area state register`, `Number of available channels`, `UNSIGNED8`, ro
        pub const AREA_STATE_REGISTER_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6401sub0 `Work area low limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const WORK_AREA_LOW_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
        /// 6402sub0 `Work area high limit`, `Number of available channels`, `UNSIGNED8`, ro
        pub const WORK_AREA_HIGH_LIMIT_NUMBER_OF_AVAILABLE_CHANNELS: u8 = 1;
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
            preset_value: 0,
            position_value: 0,
            linear_encoder_measuring_steps_position_measuring_step: 0,
            linear_encoder_measuring_steps_speed_measuring_step: 0,
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
            work_area_low_limit: [0],
            work_area_high_limit: [0],
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
            speed_value: [0],
            cyclic_timer: 0,
            cam_1_hysteresis: [0],
            cam_2_hysteresis: [0],
            cam_3_hysteresis: [0],
            cam_4_hysteresis: [0],
            cam_5_hysteresis: [0],
            cam_6_hysteresis: [0],
            cam_7_hysteresis: [0],
            cam_8_hysteresis: [0],
            operating_status: 0,
            number_of_distinguishable_revolutions: 0,
            alarms: 0,
            supported_alarms: 0,
            warnings: 0,
            supported_warnings: 0,
            error_register: 0,
            predefined_error_field_number_of_errors: 0,
            life_time_factor: 0,
            cam_state_register: [0],
            cam_enable_register: [0],
            cam_polarity_register: [0],
            area_state_register: [0],
            _padding: [0; 3],
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
    const SIZE: usize = 216;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };

    const TABLE: Table<'static> = Table {
        entries: &place::<123>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 116] = [
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
        Row::value(0x6003, 0x00, DataType::UNSIGNED32, RW, offset_of!(Dictionary, preset_value)),
        Row::value(0x6004, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO), offset_of!(Dictionary, position_value)),
        Row::value(0x6005, 0x00, DataType::UNSIGNED8, CONST, 33),
        Row::value(0x6005, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, linear_encoder_measuring_steps_position_measuring_step)),
        Row::value(0x6005, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, linear_encoder_measuring_steps_speed_measuring_step)),
        Row::value(0x6030, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6030, 0x01, DataType::INTEGER16, RO.with(Access::TPDO), offset_of!(Dictionary, speed_value)),
        Row::value(0x6200, 0x00, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cyclic_timer)),
        Row::value(0x6300, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6300, 0x01, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, cam_state_register)),
        Row::value(0x6301, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6301, 0x01, DataType::UNSIGNED8, RW.with(Access::TPDO), offset_of!(Dictionary, cam_enable_register)),
        Row::value(0x6302, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6302, 0x01, DataType::UNSIGNED8, RW.with(Access::TPDO), offset_of!(Dictionary, cam_polarity_register)),
        Row::value(0x6310, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6310, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_1_low_limit)),
        Row::value(0x6311, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6311, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_2_low_limit)),
        Row::value(0x6312, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6312, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_3_low_limit)),
        Row::value(0x6313, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6313, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_4_low_limit)),
        Row::value(0x6314, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6314, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_5_low_limit)),
        Row::value(0x6315, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6315, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_6_low_limit)),
        Row::value(0x6316, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6316, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_7_low_limit)),
        Row::value(0x6317, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6317, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_8_low_limit)),
        Row::value(0x6320, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6320, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_1_high_limit)),
        Row::value(0x6321, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6321, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_2_high_limit)),
        Row::value(0x6322, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6322, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_3_high_limit)),
        Row::value(0x6323, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6323, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_4_high_limit)),
        Row::value(0x6324, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6324, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_5_high_limit)),
        Row::value(0x6325, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6325, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_6_high_limit)),
        Row::value(0x6326, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6326, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_7_high_limit)),
        Row::value(0x6327, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6327, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, cam_8_high_limit)),
        Row::value(0x6330, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6330, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_1_hysteresis)),
        Row::value(0x6331, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6331, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_2_hysteresis)),
        Row::value(0x6332, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6332, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_3_hysteresis)),
        Row::value(0x6333, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6333, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_4_hysteresis)),
        Row::value(0x6334, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6334, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_5_hysteresis)),
        Row::value(0x6335, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6335, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_6_hysteresis)),
        Row::value(0x6336, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6336, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_7_hysteresis)),
        Row::value(0x6337, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6337, 0x01, DataType::UNSIGNED16, RW, offset_of!(Dictionary, cam_8_hysteresis)),
        Row::value(0x6400, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6400, 0x01, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, area_state_register)),
        Row::value(0x6401, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6401, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, work_area_low_limit)),
        Row::value(0x6402, 0x00, DataType::UNSIGNED8, CONST, 22),
        Row::value(0x6402, 0x01, DataType::INTEGER32, RW, offset_of!(Dictionary, work_area_high_limit)),
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
    const SEEDS: [u16; 40] = [
        11, 0, 0, 3, 20, 4, 5, 5, 20, 6, 1, 1, 8, 1, 0, 1,
        2, 0, 26, 2, 67, 0, 2, 0, 4, 0, 1, 3, 54, 26, 29, 81,
        42, 133, 2, 93, 50, 229, 2, 95,
    ];

    #[rustfmt::skip]
    const EXTRAS: [Extra; 3] = [
        Extra::new(4, 15), // 1008sub0
        Extra::new(19, 3), // 1009sub0
        Extra::new(19, 3), // 100Asub0
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 34] = [
        0x96, 0x01, 0x02, 0x00, // 1000sub0
        0x43, 0x69, 0x41, 0x20, 0x34, 0x30, 0x36, 0x20, 0x65, 0x6E, 0x63, 0x6F, 0x64, 0x65, 0x72, // 1008sub0
        0x31, 0x2E, 0x30, // 1009sub0
        0x01, // 1010sub0
        0x04, // 1018sub0
        0x00, 0x00, 0x00, 0x00, // 1018sub1
        0x03, // 1800sub0
        0x20, 0x00, 0x04, 0x60, // 1A00sub1
        0x02, // 6005sub0
    ];
}
