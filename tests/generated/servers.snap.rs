pub mod servers {
    //! Object dictionary of `Servers`, generated from `servers.eds`. Do not edit.
    //!
    //! * Vendor: `Lexican`
    //! * Order code: `SDO-3`
    //! * Description: `Several SDO servers`
    //! * 19 values of 7 objects; 68 bytes of RAM
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
        /// 1200sub1 `SDO server 1`, `COB-ID client to server`, `UNSIGNED32`, ro, default `$NODEID+0x600`
        pub sdo_server_1_cob_id_client_to_server: u32,
        /// 1200sub2 `SDO server 1`, `COB-ID server to client`, `UNSIGNED32`, ro, default `$NODEID+0x580`
        pub sdo_server_1_cob_id_server_to_client: u32,
        /// 1201sub1 `SDO server 2`, `COB-ID client to server`, `UNSIGNED32`, rw, default `$NODEID+0x680`
        pub sdo_server_2_cob_id_client_to_server: u32,
        /// 1201sub2 `SDO server 2`, `COB-ID server to client`, `UNSIGNED32`, rw, default `$NODEID+0x6A0`
        pub sdo_server_2_cob_id_server_to_client: u32,
        /// 1203sub1 `SDO server 4`, `COB-ID client to server`, `UNSIGNED32`, rw, default `0x8000_0000`
        pub sdo_server_4_cob_id_client_to_server: u32,
        /// 1203sub2 `SDO server 4`, `COB-ID server to client`, `UNSIGNED32`, rw, default `0x8000_0000`
        pub sdo_server_4_cob_id_server_to_client: u32,
        /// 1201sub3 `SDO server 2`, `Node-ID of the client`, `UNSIGNED8`, rw, default `1`
        pub sdo_server_2_node_id_of_the_client: u8,
        /// 1203sub3 `SDO server 4`, `Node-ID of the client`, `UNSIGNED8`, rw, default `1`
        pub sdo_server_4_node_id_of_the_client: u8,
        /// 2000h `Note`, `VISIBLE_STRING`, rw, at most 29 bytes, default `A note that anybody may write`
        pub note: VisibleString<29>,
        _gap: [u8; 3],
        /// 1018sub4 `Identity`, `Serial number`, `UNSIGNED32`, ro, default `0x0000_0000`
        pub identity_serial_number: u32,
        /// 1001h `Error register`, `UNSIGNED8`, ro, default `0`
        pub error_register: u8,
        _padding: [u8; 3],
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
        /// 1200sub0 `SDO server 1`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SDO_SERVER_1_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 2;
        /// 1201sub0 `SDO server 2`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SDO_SERVER_2_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// 1203sub0 `SDO server 4`, `Highest sub-index supported`, `UNSIGNED8`, const
        pub const SDO_SERVER_4_HIGHEST_SUB_INDEX_SUPPORTED: u8 = 3;
        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            sdo_server_1_cob_id_client_to_server: 0x0000_0600,
            sdo_server_1_cob_id_server_to_client: 0x0000_0580,
            sdo_server_2_cob_id_client_to_server: 0x0000_0680,
            sdo_server_2_cob_id_server_to_client: 0x0000_06A0,
            sdo_server_4_cob_id_client_to_server: 0x8000_0000,
            sdo_server_4_cob_id_server_to_client: 0x8000_0000,
            sdo_server_2_node_id_of_the_client: 1,
            sdo_server_4_node_id_of_the_client: 1,
            note: VisibleString::new(b"A note that anybody may write"),
            _gap: [0; 3],
            identity_serial_number: 0x0000_0000,
            error_register: 0,
            _padding: [0; 3],
        };
        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                sdo_server_1_cob_id_client_to_server: node_id.plus_u32(0x0000_0600),
                sdo_server_1_cob_id_server_to_client: node_id.plus_u32(0x0000_0580),
                sdo_server_2_cob_id_client_to_server: node_id.plus_u32(0x0000_0680),
                sdo_server_2_cob_id_server_to_client: node_id.plus_u32(0x0000_06A0),
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
        type Buffer = [u8; 29];
        type Pdos = lexican_runtime::pdo::Pdos<0, 0, 0>;
        type Storage = lexican_runtime::storage::NoStorage;
        type Watches = [lexican_runtime::heartbeat::Watch; 0];
        type Servers = [lexican_runtime::sdo::Channel<Self::Buffer>; 2];
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
            [0; 29]
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
            [lexican_runtime::sdo::Channel::IDLE; 2]
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
    const SIZE: usize = 68;
    /// The values after power-on, up to the last byte that is not 0.
    const POWER_ON: &[u8] = {
        const fn all() -> [u8; SIZE] {
            bytemuck::must_cast(Dictionary::DEFAULTS)
        }
        &resized::<{ written(&all()) }>(&all())
    };

    const TABLE: Table<'static> = Table {
        entries: &place::<20>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const RW: Access = Access::READ.with(Access::WRITE);
    const CONST: Access = Access::READ.with(Access::CONSTANT);

    #[rustfmt::skip]
    const ROWS: [Row; 17] = [
        Row::value(0x1000, 0x00, DataType::UNSIGNED32, CONST, 0),
        Row::value(0x1001, 0x00, DataType::UNSIGNED8, RO, offset_of!(Dictionary, error_register)),
        Row::value(0x1018, 0x00, DataType::UNSIGNED8, CONST, 4),
        Row::elements(0x1018, 0x01, 0x03, DataType::UNSIGNED32, CONST, 5),
        Row::value(0x1018, 0x04, DataType::UNSIGNED32, RO, offset_of!(Dictionary, identity_serial_number)),
        Row::value(0x1200, 0x00, DataType::UNSIGNED8, CONST, 17),
        Row::value(0x1200, 0x01, DataType::UNSIGNED32, RO.with(Access::NODE_ID), offset_of!(Dictionary, sdo_server_1_cob_id_client_to_server)),
        Row::value(0x1200, 0x02, DataType::UNSIGNED32, RO.with(Access::NODE_ID), offset_of!(Dictionary, sdo_server_1_cob_id_server_to_client)),
        Row::value(0x1201, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x1201, 0x01, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, sdo_server_2_cob_id_client_to_server)),
        Row::value(0x1201, 0x02, DataType::UNSIGNED32, RW.with(Access::NODE_ID), offset_of!(Dictionary, sdo_server_2_cob_id_server_to_client)),
        Row::value(0x1201, 0x03, DataType::UNSIGNED8, RW, offset_of!(Dictionary, sdo_server_2_node_id_of_the_client)),
        Row::value(0x1203, 0x00, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x1203, 0x01, DataType::UNSIGNED32, RW, offset_of!(Dictionary, sdo_server_4_cob_id_client_to_server)),
        Row::value(0x1203, 0x02, DataType::UNSIGNED32, RW, offset_of!(Dictionary, sdo_server_4_cob_id_server_to_client)),
        Row::value(0x1203, 0x03, DataType::UNSIGNED8, RW, offset_of!(Dictionary, sdo_server_4_node_id_of_the_client)),
        Row::value(0x2000, 0x00, DataType::VISIBLE_STRING, RW.with(Access::EXTRA), 0),
    ];

    #[rustfmt::skip]
    const SEEDS: [u16; 7] = [
        6, 0, 29, 19, 23, 5, 0,
    ];

    #[rustfmt::skip]
    const EXTRAS: [Extra; 1] = [
        Extra::new(offset_of!(Dictionary, note), 29), // 2000sub0
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 19] = [
        0x00, 0x00, 0x00, 0x00, // 1000sub0
        0x04, // 1018sub0
        0x78, 0x56, 0x34, 0x12, // 1018sub1
        0x01, 0x00, 0x00, 0x00, // 1018sub2
        0x01, 0x00, 0x01, 0x00, // 1018sub3
        0x02, // 1200sub0
        0x03, // 1201sub0
    ];
}
