//! A device as the generator writes it, by hand: one object of each kind.

use lexican_runtime::AbortCode;

use device::{Device, Dictionary, Handlers};

/// An application that does nothing: what is written is stored, what is read is what is stored.
#[derive(Clone, Copy, Debug)]
pub struct Quiet;

impl Handlers for Quiet {
    fn write_preset_value(&mut self, _: &mut Dictionary, _: u32) -> Result<(), AbortCode> {
        Ok(())
    }

    fn read_position_value(&mut self, _: &mut Dictionary) -> Result<(), AbortCode> {
        Ok(())
    }
}

/// The sample device with an application that does nothing.
#[must_use]
pub fn quiet() -> Device<Quiet> {
    Device::new(Quiet)
}

/// Object dictionary of `Sample`, generated from `sample.eds`. Do not edit.
pub mod device {
    use core::mem::offset_of;

    use lexican_runtime::od::{
        Access, Boolean, DataType, Extra, OctetString, Row, Table, TimeOfDay, Value, VisibleString, place,
    };
    use lexican_runtime::{AbortCode, Address, NodeId, bytemuck};

    /// The values of the dictionary, widest first, so that nothing stands between them.
    #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
    #[bytemuck(crate = "lexican_runtime::bytemuck")]
    #[repr(C)]
    pub struct Dictionary {
        /// 2002h `Serial`, UNSIGNED64, rw
        pub serial: u64,
        /// 2003h `Offset`, INTEGER40, rw, −1000 to 1000, default −5
        pub offset: i64,
        /// 2004h `Factor`, REAL64, rw, 0.5 to 2.0, default 1.0
        pub factor: f64,
        /// 1014h `COB-ID EMCY`, UNSIGNED32, rw, default `$NODEID+0x80`
        pub cob_id_emcy: u32,
        /// 1200h `SDO server parameter`
        pub sdo_server_parameter: SdoServerParameter,
        /// 2005h `Gain`, REAL32, rw, −1.5 to 1.5, default 0.25
        pub gain: f32,
        /// 2006h `Trim`, INTEGER24, rw, −100 to 100, default −1
        pub trim: i32,
        /// 6003h `Preset value`, UNSIGNED32, rw; written through [`Handlers::write_preset_value`]
        pub preset_value: u32,
        /// 6004h `Position value`, UNSIGNED32, ro; read through [`Handlers::read_position_value`]
        pub position_value: u32,
        /// 1017h `Producer heartbeat time`, UNSIGNED16, rw, ms
        pub producer_heartbeat_time: u16,
        /// 6200h `Cyclic timer`, UNSIGNED16, rw
        pub cyclic_timer: u16,
        /// 6030h `Speed value`, INTEGER16, ro
        pub speed_value: [i16; 3],
        /// 1001h `Error register`, UNSIGNED8, ro
        pub error_register: u8,
        /// 2000h `Level`, UNSIGNED8, rw, 1 to 10, default 5
        pub level: u8,
        /// 2001h `Enabled`, BOOLEAN, rw, default 1
        pub enabled: Boolean,
        /// 2007h `Clock`, TIME_OF_DAY, rw
        pub clock: TimeOfDay,
        /// 2008h `Command`, UNSIGNED8, wo
        pub command: u8,
        /// 2009h `Tag`, VISIBLE_STRING, rw, at most 20 bytes, default `tag`
        pub tag: VisibleString<20>,
        /// 200Ah `Blob`, OCTET_STRING, rw, at most 60 bytes
        pub blob: OctetString<60>,
        /// Fills the struct to a multiple of its alignment.
        pub padding: [u8; 4],
    }

    /// 1200h `SDO server parameter`
    #[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
    #[bytemuck(crate = "lexican_runtime::bytemuck")]
    #[repr(C)]
    pub struct SdoServerParameter {
        /// 1200sub1 `COB-ID client to server`, UNSIGNED32, ro, default `$NODEID+0x600`
        pub cob_id_client_to_server: u32,
        /// 1200sub2 `COB-ID server to client`, UNSIGNED32, ro, default `$NODEID+0x580`
        pub cob_id_server_to_client: u32,
    }

    impl Dictionary {
        /// 1000h `Device type`, UNSIGNED32
        pub const DEVICE_TYPE: u32 = 0x0002_0196;
        /// 1008h `Manufacturer device name`, VISIBLE_STRING
        pub const MANUFACTURER_DEVICE_NAME: &'static str = "Lexican sample";

        /// The values after power-on, with 0 for `$NODEID`.
        pub const DEFAULTS: Self = Self {
            serial: 0,
            offset: -5,
            factor: 1.0,
            cob_id_emcy: 0x80,
            sdo_server_parameter: SdoServerParameter {
                cob_id_client_to_server: 0x600,
                cob_id_server_to_client: 0x580,
            },
            gain: 0.25,
            trim: -1,
            preset_value: 0,
            position_value: 0,
            producer_heartbeat_time: 0,
            cyclic_timer: 0,
            speed_value: [0; 3],
            error_register: 0,
            level: 5,
            enabled: Boolean::new(true),
            clock: TimeOfDay::new(0, 0),
            command: 0,
            tag: VisibleString::new(b"tag"),
            blob: OctetString::EMPTY,
            padding: [0; 4],
        };

        /// The values after power-on of the node `node_id`.
        #[must_use]
        pub const fn new(node_id: NodeId) -> Self {
            Self {
                cob_id_emcy: node_id.plus_u32(0x80),
                sdo_server_parameter: SdoServerParameter {
                    cob_id_client_to_server: node_id.plus_u32(0x600),
                    cob_id_server_to_client: node_id.plus_u32(0x580),
                },
                ..Self::DEFAULTS
            }
        }
    }

    /// What the application does when certain objects are accessed.
    pub trait Handlers {
        /// 6003h `Preset value` is about to be written.
        ///
        /// # Errors
        /// The abort code for the client; then nothing is stored.
        fn write_preset_value(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode>;

        /// 6004h `Position value` is about to be read.
        ///
        /// # Errors
        /// The abort code for the client.
        fn read_position_value(&mut self, od: &mut Dictionary) -> Result<(), AbortCode>;
    }

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
                od: Dictionary::DEFAULTS,
                handlers,
            }
        }
    }

    impl<H: Handlers> lexican_runtime::Device for Device<H> {
        type Buffer = [u8; 60];
        type Pdos = lexican_runtime::pdo::Pdos<0, 0, 0>;
        type Storage = lexican_runtime::storage::NoStorage;
        type Watches = [lexican_runtime::heartbeat::Watch; 0];
        type Servers = [lexican_runtime::sdo::Channel<Self::Buffer>; 0];

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
            bytemuck::bytes_of(&Dictionary::DEFAULTS)
        }

        #[inline]
        fn buffer(&self) -> Self::Buffer {
            [0; 60]
        }

        #[inline]
        fn pdos(&self) -> Self::Pdos {
            Self::Pdos::EMPTY
        }

        #[inline]
        fn watches(&self) -> Self::Watches {
            []
        }

        #[inline]
        fn servers(&self) -> Self::Servers {
            []
        }

        fn before_read(&mut self, address: Address) -> Result<(), AbortCode> {
            match (address.index, address.sub) {
                (0x6004, 0x00) => self.handlers.read_position_value(&mut self.od),
                _ => Ok(()),
            }
        }

        fn before_write(&mut self, address: Address, value: Value<'_>) -> Result<(), AbortCode> {
            match (address.index, address.sub) {
                (0x6003, 0x00) => self.handlers.write_preset_value(&mut self.od, value.to_u32()),
                _ => Ok(()),
            }
        }
    }

    const TABLE: Table<'static> = Table {
        entries: &place::<30>(&ROWS, &SEEDS),
        seeds: &SEEDS,
        extras: &EXTRAS,
        constants: &CONSTANTS,
    };

    const RO: Access = Access::READ;
    const WO: Access = Access::WRITE;
    const RW: Access = RO.with(WO);
    const CONST: Access = RO.with(Access::CONSTANT);

    const ROWS: [Row; 26] = [
        Row::value(0x1000, 0, DataType::UNSIGNED32, CONST, 0),
        Row::value(
            0x1001,
            0,
            DataType::UNSIGNED8,
            RO.with(Access::TPDO),
            offset_of!(Dictionary, error_register),
        ),
        Row::value(0x1008, 0, DataType::VISIBLE_STRING, CONST.with(Access::EXTRA), 0),
        Row::value(
            0x1014,
            0,
            DataType::UNSIGNED32,
            RW.with(Access::NODE_ID),
            offset_of!(Dictionary, cob_id_emcy),
        ),
        Row::value(
            0x1017,
            0,
            DataType::UNSIGNED16,
            RW,
            offset_of!(Dictionary, producer_heartbeat_time),
        ),
        Row::value(0x1018, 0, DataType::UNSIGNED8, CONST, 18),
        Row::value(0x1018, 1, DataType::UNSIGNED32, CONST, 19),
        Row::value(0x1200, 0, DataType::UNSIGNED8, CONST, 23),
        Row::value(
            0x1200,
            1,
            DataType::UNSIGNED32,
            RO.with(Access::NODE_ID),
            offset_of!(Dictionary, sdo_server_parameter) + offset_of!(SdoServerParameter, cob_id_client_to_server),
        ),
        Row::value(
            0x1200,
            2,
            DataType::UNSIGNED32,
            RO.with(Access::NODE_ID),
            offset_of!(Dictionary, sdo_server_parameter) + offset_of!(SdoServerParameter, cob_id_server_to_client),
        ),
        Row::value(0x2000, 0, DataType::UNSIGNED8, RW.with(Access::EXTRA), 1),
        Row::value(0x2001, 0, DataType::BOOLEAN, RW, offset_of!(Dictionary, enabled)),
        Row::value(0x2002, 0, DataType::UNSIGNED64, RW, offset_of!(Dictionary, serial)),
        Row::value(0x2003, 0, DataType::INTEGER40, RW.with(Access::EXTRA), 2),
        Row::value(0x2004, 0, DataType::REAL64, RW.with(Access::EXTRA), 3),
        Row::value(0x2005, 0, DataType::REAL32, RW.with(Access::EXTRA), 4),
        Row::value(0x2006, 0, DataType::INTEGER24, RW.with(Access::EXTRA), 5),
        Row::value(0x2007, 0, DataType::TIME_OF_DAY, RW, offset_of!(Dictionary, clock)),
        Row::value(0x2008, 0, DataType::UNSIGNED8, WO, offset_of!(Dictionary, command)),
        Row::value(0x2009, 0, DataType::VISIBLE_STRING, RW.with(Access::EXTRA), 6),
        Row::value(0x200A, 0, DataType::OCTET_STRING, RW.with(Access::EXTRA), 7),
        Row::value(
            0x6003,
            0,
            DataType::UNSIGNED32,
            RW.with(Access::WRITE_HANDLER),
            offset_of!(Dictionary, preset_value),
        ),
        Row::value(
            0x6004,
            0,
            DataType::UNSIGNED32,
            RO.with(Access::TPDO).with(Access::READ_HANDLER),
            offset_of!(Dictionary, position_value),
        ),
        Row::value(0x6030, 0, DataType::UNSIGNED8, CONST, 24),
        Row::elements(
            0x6030,
            1,
            3,
            DataType::INTEGER16,
            RO.with(Access::TPDO),
            offset_of!(Dictionary, speed_value),
        ),
        Row::value(
            0x6200,
            0,
            DataType::UNSIGNED16,
            RW,
            offset_of!(Dictionary, cyclic_timer),
        ),
    ];

    const SEEDS: [u16; 7] = [4124, 0, 5, 515, 2, 1, 801];

    const EXTRAS: [Extra; 8] = [
        Extra::new(4, 14),                              // 1008h
        Extra::new(offset_of!(Dictionary, level), 25),  // 2000h
        Extra::new(offset_of!(Dictionary, offset), 27), // 2003h
        Extra::new(offset_of!(Dictionary, factor), 43), // 2004h
        Extra::new(offset_of!(Dictionary, gain), 59),   // 2005h
        Extra::new(offset_of!(Dictionary, trim), 67),   // 2006h
        Extra::new(offset_of!(Dictionary, tag), 20),    // 2009h
        Extra::new(offset_of!(Dictionary, blob), 60),   // 200Ah
    ];

    #[rustfmt::skip]
    const CONSTANTS: [u8; 75] = [
        0x96, 0x01, 0x02, 0x00, // 1000h
        0x4C, 0x65, 0x78, 0x69, 0x63, 0x61, 0x6E, 0x20, 0x73, 0x61, 0x6D, 0x70, 0x6C, 0x65, // 1008h
        0x01, // 1018sub0
        0xFF, 0xFF, 0x00, 0x00, // 1018sub1
        0x02, // 1200sub0
        0x03, // 6030sub0
        0x01, 0x0A, // limits of 2000h
        0x18, 0xFC, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, // lower limit of 2003h
        0xE8, 0x03, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, // upper limit of 2003h
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xE0, 0x3F, // lower limit of 2004h
        0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x40, // upper limit of 2004h
        0x00, 0x00, 0xC0, 0xBF, 0x00, 0x00, 0xC0, 0x3F, // limits of 2005h
        0x9C, 0xFF, 0xFF, 0xFF, 0x64, 0x00, 0x00, 0x00, // limits of 2006h
    ];
}
