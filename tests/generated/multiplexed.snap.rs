pub mod multiplexed {
    //! Object dictionary of `Multiplexed`, generated from `multiplexed.eds`. Do not edit.
    //!
    //! * Vendor: `Lexican`
    //! * Order code: `MPDO-1`
    //! * Description: `Multiplexed PDOs`
    //! * 45 values of 19 objects; 96 bytes of RAM
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
        /// 1FD0sub1 to 1FD0sub2 `Object dispatching list 1`, `UNSIGNED64`, rw
        ///
        /// * `[0]`: `Dispatch 1`, default `99_642_143_366_447_111`
        /// * `[1]`: `Dispatch 2`, default `153_685_359_312_503_047`
        pub object_dispatching_list_1: [u64; 2],
        /// 1400sub1 `RPDO 1 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x200`
        pub rpdo_1_communication_cob_id: u32,
        /// 1401sub1 `RPDO 2 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x300`
        pub rpdo_2_communication_cob_id: u32,
        /// 1800sub1 `TPDO 1 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x180`
        pub tpdo_1_communication_cob_id: u32,
        /// 1801sub1 `TPDO 2 communication`, `COB-ID`, `UNSIGNED32`, rw, default `$NODEID+0x280`
        pub tpdo_2_communication_cob_id: u32,
        /// 1FA0sub1 to 1FA0sub2 `Object scanner list 1`, `UNSIGNED32`, rw
        ///
        /// * `[0]`: `Scan 1`, default `0x0160_0400`
        /// * `[1]`: `Scan 2`, default `0x0000_0000`
        pub object_scanner_list_1: [u32; 2],
        /// 1FA1sub1 `Object scanner list 2`, `UNSIGNED32`, rw, default `0x0321_0001`
        pub object_scanner_list_2: [u32; 1],
        /// 6004h `Position value`, `UNSIGNED32`, ro, default `287_454_020`, PDO-mappable
        pub position_value: u32,
        /// 2100sub3 `Readings`, `Third`, `UNSIGNED16`, ro, default `41891`, PDO-mappable
        pub readings_third: u16,
        /// 1400sub2 `RPDO 1 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub rpdo_1_communication_transmission_type: u8,
        /// 1401sub2 `RPDO 2 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub rpdo_2_communication_transmission_type: u8,
        /// 1600sub0 `RPDO 1 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `254`
        pub rpdo_1_mapping_number_of_mapped_objects: u8,
        /// 1601sub0 `RPDO 2 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `255`
        pub rpdo_2_mapping_number_of_mapped_objects: u8,
        /// 1800sub2 `TPDO 1 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_1_communication_transmission_type: u8,
        /// 1801sub2 `TPDO 2 communication`, `Transmission type`, `UNSIGNED8`, rw, default `254`
        pub tpdo_2_communication_transmission_type: u8,
        /// 1A00sub0 `TPDO 1 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `254`
        pub tpdo_1_mapping_number_of_mapped_objects: u8,
        /// 1A01sub0 `TPDO 2 mapping`, `Number of mapped objects`, `UNSIGNED8`, rw, default `255`
        pub tpdo_2_mapping_number_of_mapped_objects: u8,
        /// 2100sub1 `Readings`, `First`, `UNSIGNED8`, ro, default `161`, PDO-mappable
        pub readings_first: u8,
        /// 2100sub4 `Readings`, `Fourth`, `UNSIGNED8`, ro, default `164`, PDO-mappable
        pub readings_fourth: u8,
        /// 2300h `Not mappable`, `UNSIGNED8`, rw, default `35`
        pub not_mappable: u8,
        _gap: [u8; 3],
        /// 1018sub4 `Identity`, `Serial number`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub identity_serial_number: u32,
        /// 1600sub1 `RPDO 1 mapping`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub rpdo_1_mapping: [u32; 1],
        /// 1601sub1 `RPDO 2 mapping`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub rpdo_2_mapping: [u32; 1],
        /// 1A00sub1 `TPDO 1 mapping`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub tpdo_1_mapping: [u32; 1],
        /// 1A01sub1 `TPDO 2 mapping`, `UNSIGNED32`, rw, default `0x0000_0000`
        pub tpdo_2_mapping: [u32; 1],
        /// 6200h `Set point`, `UNSIGNED32`, rww, default `0`, PDO-mappable
        pub set_point: u32,
        /// 1001h `Error register`, `UNSIGNED8`, ro, default `0`
        pub error_register: u8,
        /// 2200sub5 `Settings`, `Fifth`, `UNSIGNED8`, rww, default `0`, PDO-mappable
        pub settings_fifth: u8,
        /// 2200sub6 `Settings`, `Sixth`, `UNSIGNED8`, rww, default `0`, PDO-mappable
        pub settings_sixth: u8,
        _padding: [u8; 5],
    }
    impl Dictionary {
        /// 1000h `Device type`, `UNSIGNED32`, ro
        pub const DEVICE_TYPE: u32 = 0x0000_0000;
        /// 1018sub0 `Identity`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const IDENTITY_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 1018sub1 `Identity`, `Vendor-ID`, `UNSIGNED32`, ro
        pub const IDENTITY_VENDOR_ID: u32 = 0x1234_5678;
        /// 1018sub2 `Identity`, `Product code`, `UNSIGNED32`, ro
        pub const IDENTITY_PRODUCT_CODE: u32 = 0x0000_0001;
        /// 1018sub3 `Identity`, `Revision number`, `UNSIGNED32`, ro
        pub const IDENTITY_REVISION_NUMBER: u32 = 0x0001_0001;
        /// 1400sub0 `RPDO 1 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const RPDO_1_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1401sub0 `RPDO 2 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const RPDO_2_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1800sub0 `TPDO 1 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_1_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1801sub0 `TPDO 2 communication`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const TPDO_2_COMMUNICATION_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1FA0sub0 `Object scanner list 1`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const OBJECT_SCANNER_LIST_1_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1FA1sub0 `Object scanner list 2`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const OBJECT_SCANNER_LIST_2_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 1;
        /// 1FD0sub0 `Object dispatching list 1`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const OBJECT_DISPATCHING_LIST_1_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 2100sub0 `Readings`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const READINGS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 4;
        /// 2200sub0 `Settings`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SETTINGS_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 6;
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            object_dispatching_list_1: [99_642_143_366_447_111, 153_685_359_312_503_047],
            rpdo_1_communication_cob_id: 0x0000_0200,
            rpdo_2_communication_cob_id: 0x0000_0300,
            tpdo_1_communication_cob_id: 0x0000_0180,
            tpdo_2_communication_cob_id: 0x0000_0280,
            object_scanner_list_1: [0x0160_0400, 0x0000_0000],
            object_scanner_list_2: [0x0321_0001],
            position_value: 287_454_020,
            readings_third: 41891,
            rpdo_1_communication_transmission_type: 254,
            rpdo_2_communication_transmission_type: 254,
            rpdo_1_mapping_number_of_mapped_objects: 254,
            rpdo_2_mapping_number_of_mapped_objects: 255,
            tpdo_1_communication_transmission_type: 254,
            tpdo_2_communication_transmission_type: 254,
            tpdo_1_mapping_number_of_mapped_objects: 254,
            tpdo_2_mapping_number_of_mapped_objects: 255,
            readings_first: 161,
            readings_fourth: 164,
            not_mappable: 35,
            _gap: [0; 3],
            identity_serial_number: 0x0000_0000,
            rpdo_1_mapping: [0x0000_0000],
            rpdo_2_mapping: [0x0000_0000],
            tpdo_1_mapping: [0x0000_0000],
            tpdo_2_mapping: [0x0000_0000],
            set_point: 0,
            error_register: 0,
            settings_fifth: 0,
            settings_sixth: 0,
            _padding: [0; 5],
        };
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                rpdo_1_communication_cob_id: node_id.plus_u32(0x0000_0200),
                rpdo_2_communication_cob_id: node_id.plus_u32(0x0000_0300),
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
    /// The device: its dictionary, and the application behind it.
    #[derive(Clone, Debug)]
    pub struct Device<H> {
        /// The dictionary.
        pub od: Dictionary,
        /// The application.
        pub handlers: H,
    }
    impl<H> Device<H> {
        /// The device after power-on; the node gives it its node-ID.
        #[must_use]
        pub const fn new(handlers: H) -> Self {
            Self {
                od: bytemuck::must_cast(resized::<SIZE>(POWER_ON)),
                handlers,
            }
        }
    }
    impl<H: Handlers> lexican_runtime::Device for Device<H> {
        type Buffer = [u8; 8];
        type Pdos = lexican_runtime::pdo::Pdos<2, 2, 4>;
        type Storage = lexican_runtime::storage::NoStorage;
        type Watches = [lexican_runtime::heartbeat::Watch; 0];
        type Servers = [lexican_runtime::sdo::Channel<Self::Buffer>; 0];
        const SERVICES: ServiceSet = ServiceSet::of(&ROWS).with(ServiceSet::MPDO);
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
    const SIZE: usize = 96;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };

    const TABLE: Table<'static> = Table {
        entries: &place::<47>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 41] = [
        Row::value(0x1000, 0x00, DataType::UNSIGNED32, CONST, 0),
        Row::value(0x1001, 0x00, DataType::UNSIGNED8, RO, offset_of!(Dictionary, error_register)),
        Row::value(0x1018, 0x00, DataType::UNSIGNED8, CONST, 4),
        Row::elements(0x1018, 0x01, 0x03, DataType::UNSIGNED32, CONST, 5),
        Row::value(0x1018, 0x04, DataType::UNSIGNED32, RO, offset_of!(Dictionary, identity_serial_number)),
        Row::value(0x1400, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::value(0x1400, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, rpdo_1_communication_cob_id)),
        Row::value(0x1400, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, rpdo_1_communication_transmission_type)),
        Row::value(0x1401, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::value(0x1401, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, rpdo_2_communication_cob_id)),
        Row::value(0x1401, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, rpdo_2_communication_transmission_type)),
        Row::value(0x1600, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, rpdo_1_mapping_number_of_mapped_objects)),
        Row::value(0x1600, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, rpdo_1_mapping)),
        Row::value(0x1601, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, rpdo_2_mapping_number_of_mapped_objects)),
        Row::value(0x1601, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, rpdo_2_mapping)),
        Row::value(0x1800, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::value(0x1800, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_1_communication_cob_id)),
        Row::value(0x1800, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_1_communication_transmission_type)),
        Row::value(0x1801, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::value(0x1801, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, tpdo_2_communication_cob_id)),
        Row::value(0x1801, 0x02, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_2_communication_transmission_type)),
        Row::value(0x1A00, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_1_mapping_number_of_mapped_objects)),
        Row::value(0x1A00, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_1_mapping)),
        Row::value(0x1A01, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, tpdo_2_mapping_number_of_mapped_objects)),
        Row::value(0x1A01, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, tpdo_2_mapping)),
        Row::value(0x1FA0, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::elements(0x1FA0, 0x01, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, object_scanner_list_1)),
        Row::value(0x1FA1, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x1FA1, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, object_scanner_list_2)),
        Row::value(0x1FD0, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::elements(0x1FD0, 0x01, 0x02, DataType::UNSIGNED64, RW, offset_of!(Dictionary, object_dispatching_list_1)),
        Row::value(0x2100, 0x00, DataType::UNSIGNED8, CONST, 4),
        Row::value(0x2100, 0x01, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, readings_first)),
        Row::value(0x2100, 0x03, DataType::UNSIGNED16, RO.with(Access::TPDO), offset_of!(Dictionary, readings_third)),
        Row::value(0x2100, 0x04, DataType::UNSIGNED8, RO.with(Access::TPDO), offset_of!(Dictionary, readings_fourth)),
        Row::value(0x2200, 0x00, DataType::UNSIGNED8, CONST, 19),
        Row::value(0x2200, 0x05, DataType::UNSIGNED8, RW.with(Access::RPDO), offset_of!(Dictionary, settings_fifth)),
        Row::value(0x2200, 0x06, DataType::UNSIGNED8, RW.with(Access::RPDO), offset_of!(Dictionary, settings_sixth)),
        Row::value(0x2300, 0x00, DataType::UNSIGNED8, RW, offset_of!(Dictionary, not_mappable)),
        Row::value(0x6004, 0x00, DataType::UNSIGNED32, RO.with(Access::TPDO), offset_of!(Dictionary, position_value)),
        Row::value(0x6200, 0x00, DataType::UNSIGNED32, RW.with(Access::RPDO), offset_of!(Dictionary, set_point)),
    ];

    #[rustfmt::skip]
    const SEEDS: [u16; 15] = [
        3, 20, 0, 7, 7, 14, 3, 53, 7, 0, 9, 27, 1, 19, 286,
    ];

    const EXTRAS: [Extra; 0] = [];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 20] = [
        0x00, 0x00, 0x00, 0x00, // 1000sub0
        0x04, // 1018sub0
        0x78, 0x56, 0x34, 0x12, // 1018sub1
        0x01, 0x00, 0x00, 0x00, // 1018sub2
        0x01, 0x00, 0x01, 0x00, // 1018sub3
        0x02, // 1400sub0
        0x01, // 1FA1sub0
        0x06, // 2200sub0
    ];
}
