//! The keywords of all sections (CiA 306-1).

mod parse;

/// Declares [`Keyword`] and the spelling of each keyword that carries no number.
macro_rules! keywords {
    ($($(#[$doc:meta])* $variant:ident = $name:literal,)+) => {
        /// A keyword: what stands before `=`.
        ///
        /// Parsed without regard to case; [`Document::text`](super::Document::text) of an entry's key has the spelling.
        /// A keyword means what its section makes of it: `[M1ModuleInfo]` and `[DeviceInfo]` share ProductName.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Keyword {
            $($(#[$doc])* $variant,)+
            /// `1`: the number of a list's line, a sub-index, a module's place.
            Number(u32),
            /// `Line1`, of `[Comments]`
            Line(u32),
            /// `Dummy0005`, of `[DummyUsage]`: the index of a data type.
            Dummy(u16),
            /// `BaudRate_500`, of `[DeviceInfo]`: in kbit/s.
            BaudRate(u16),
            /// `0x0005`, of `[StandardDataTypes]`: the index of a data type.
            DataTypeIndex(u16),
            /// `Type1`, of `[DynamicChannels]`
            Type(u32),
            /// `Dir1`, of `[DynamicChannels]`
            Dir(u32),
            /// `Range1`, of `[DynamicChannels]`
            Range(u32),
            /// `PPOffset1`, of `[DynamicChannels]`
            PpOffset(u32),
            /// `MaxCnt1`, of `[DynamicChannels]` before EDS version 4
            MaxCnt(u32),
            /// None of CiA 306-1.
            Unknown,
        }

        /// The keywords that carry no number.
        const PLAIN: &[(Keyword, &str)] = &[$((Keyword::$variant, $name),)+];

        impl Keyword {
            /// The standard's spelling, without the number of a numbered keyword; empty for [`Keyword::Number`],
            /// [`Keyword::DataTypeIndex`] and [`Keyword::Unknown`].
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                    Self::Number(_) | Self::DataTypeIndex(_) | Self::Unknown => "",
                    Self::Line(_) => "Line",
                    Self::Dummy(_) => "Dummy",
                    Self::BaudRate(_) => "BaudRate_",
                    Self::Type(_) => "Type",
                    Self::Dir(_) => "Dir",
                    Self::Range(_) => "Range",
                    Self::PpOffset(_) => "PPOffset",
                    Self::MaxCnt(_) => "MaxCnt",
                }
            }
        }
    };
}

keywords! {
    /// The name of the file; `[FileInfo]`
    FileName = "FileName",
    /// UNSIGNED8; `[FileInfo]`
    FileVersion = "FileVersion",
    /// UNSIGNED8; `[FileInfo]`
    FileRevision = "FileRevision",
    /// `4.0`; `[FileInfo]`
    EdsVersion = "EDSVersion",
    /// Up to 243 characters; `[FileInfo]`
    Description = "Description",
    /// `hh:mm(AM|PM)`; `[FileInfo]`
    CreationTime = "CreationTime",
    /// `mm-dd-yyyy`; `[FileInfo]`
    CreationDate = "CreationDate",
    /// Who wrote the file; `[FileInfo]`
    CreatedBy = "CreatedBy",
    /// `hh:mm(AM|PM)`; `[FileInfo]`
    ModificationTime = "ModificationTime",
    /// `mm-dd-yyyy`; `[FileInfo]`
    ModificationDate = "ModificationDate",
    /// Who changed the file; `[FileInfo]`
    ModifiedBy = "ModifiedBy",
    /// The EDS that a DCF was made from; `[FileInfo]`
    LastEds = "LastEDS",

    /// `[DeviceInfo]`
    VendorName = "VendorName",
    /// 1018h sub 1; `[DeviceInfo]`
    VendorNumber = "VendorNumber",
    /// `[DeviceInfo]`, `[MxModuleInfo]`
    ProductName = "ProductName",
    /// 1018h sub 2; `[DeviceInfo]`
    ProductNumber = "ProductNumber",
    /// 1018h sub 3; `[DeviceInfo]`
    RevisionNumber = "RevisionNumber",
    /// `[DeviceInfo]`, `[MxModuleInfo]`
    OrderCode = "OrderCode",
    /// `[DeviceInfo]`
    SimpleBootUpMaster = "SimpleBootUpMaster",
    /// `[DeviceInfo]`
    SimpleBootUpSlave = "SimpleBootUpSlave",
    /// `[DeviceInfo]`
    Granularity = "Granularity",
    /// `[DeviceInfo]`
    DynamicChannelsSupported = "DynamicChannelsSupported",
    /// `[DeviceInfo]`
    GroupMessaging = "GroupMessaging",
    /// `[DeviceInfo]`
    NrOfRxPdo = "NrOfRXPDO",
    /// `[DeviceInfo]`
    NrOfTxPdo = "NrOfTXPDO",
    /// `[DeviceInfo]`
    LssSupported = "LSS_Supported",
    /// `[DeviceInfo]`
    CompactPdo = "CompactPDO",
    /// LSS as master; `[DeviceInfo]`
    LssMaster = "LSS_Master",
    /// The device finds out the bit rate; `[DeviceInfo]`
    BaudRateAuto = "BaudRate_auto",
    /// Node guarding as NMT slave; `[DeviceInfo]`
    NgSlave = "NG_Slave",
    /// Node guarding as NMT master; `[DeviceInfo]`
    NgMaster = "NG_Master",
    /// `[DeviceInfo]`
    NrOfNgMonitoredNodes = "NrOfNG_MonitoredNodes",
    /// `[MxModuleInfo]`; in `[DeviceInfo]` before EDS version 4
    ProductVersion = "ProductVersion",
    /// `[MxModuleInfo]`; in `[DeviceInfo]` before EDS version 4
    ProductRevision = "ProductRevision",
    /// CANopen Safety, EN 50325-5; `[DeviceInfo]`
    CanopenSafetySupported = "CANopenSafetySupported",
    /// `[DeviceInfo]` before EDS version 4
    ExtendedBootUpMaster = "ExtendedBootUpMaster",
    /// `[DeviceInfo]` before EDS version 4
    ExtendedBootUpSlave = "ExtendedBootUpSlave",
    /// `[DeviceInfo]` before EDS version 4
    LmtManufacturerName = "LMT_ManufacturerName",
    /// `[DeviceInfo]` before EDS version 4
    LmtProductName = "LMT_ProductName",

    /// `[DeviceComissioning]`
    NodeId = "NodeID",
    /// `[DeviceComissioning]`
    NodeName = "NodeName",
    /// Reference designator of the node; `[DeviceComissioning]`
    NodeRefd = "NodeRefd",
    /// `Baudrate` without a number, in kbit/s; `[DeviceComissioning]`
    CommissionedBaudRate = "Baudrate",
    /// `[DeviceComissioning]`
    NetNumber = "NetNumber",
    /// `[DeviceComissioning]`
    NetworkName = "NetworkName",
    /// Reference designator of the network; `[DeviceComissioning]`
    NetRefd = "NetRefd",
    /// `[DeviceComissioning]`
    CanopenManager = "CANopenManager",
    /// 1018h sub 4; `[DeviceComissioning]`
    LssSerialNumber = "LSS_SerialNumber",

    /// How many lines follow; `[Comments]`, `[MxComments]`
    Lines = "Lines",
    /// How many objects follow; the three object lists
    SupportedObjects = "SupportedObjects",
    /// How many entries follow; compact forms, modules
    NrOfEntries = "NrOfEntries",

    /// Objects
    ParameterName = "ParameterName",
    /// Objects
    ObjectType = "ObjectType",
    /// Objects
    DataType = "DataType",
    /// Objects
    AccessType = "AccessType",
    /// Objects
    DefaultValue = "DefaultValue",
    /// Objects
    LowLimit = "LowLimit",
    /// Objects
    HighLimit = "HighLimit",
    /// Objects
    PdoMapping = "PDOMapping",
    /// Mappable into an SRDO of CANopen Safety; objects
    SrdoMapping = "SRDOMapping",
    /// The object with the inverted value of one in an SRDO; objects
    InvertedSrad = "InvertedSRAD",
    /// Objects
    ObjFlags = "ObjFlags",
    /// How many sub-objects have a section; objects
    SubNumber = "SubNumber",
    /// How many sub-objects the compact form stands for; objects
    CompactSubObj = "CompactSubObj",
    /// Reference designator of a parameter; objects of a DCF
    ParaRefd = "ParaRefd",
    /// [`Keyword::ParaRefd`] as CiA 306-1 spells it from version 1.4 on
    ParamRefd = "ParamRefd",
    /// Objects
    UniqueIdRef = "UniqueIDRef",
    /// Objects of a DCF
    ParameterValue = "ParameterValue",
    /// Objects of a DCF
    Denotation = "Denotation",
    /// Objects of a DCF
    UploadFile = "UploadFile",
    /// Objects of a DCF
    DownloadFile = "DownloadFile",
    /// How many links follow; `[xxxxObjectLinks]`
    ObjectLinks = "ObjectLinks",

    /// How many sub-objects a module adds; `[MxSubExtxxxx]`
    Count = "Count",
    /// How sub-objects are added; `[MxSubExtxxxx]`
    ObjExtend = "ObjExtend",
    /// How many segments follow; `[DynamicChannels]`
    NrOfSeg = "NrOfSeg",

    /// How many tools follow; `[Tools]`
    Items = "Items",
    /// `[Toolx]`
    Name = "Name",
    /// `[Toolx]`
    Command = "Command",
}

impl Keyword {
    /// The standard's spelling of every keyword that carries no number.
    pub fn names() -> impl Iterator<Item = &'static str> {
        PLAIN.iter().map(|(_, name)| *name)
    }

    /// Whether `key` is written as the standard writes this keyword, letter by letter.
    #[must_use]
    pub fn is_spelled(self, key: &str) -> bool {
        match self {
            Self::Unknown => false,
            Self::DataTypeIndex(index) => key
                .strip_prefix("0x")
                .is_some_and(|digits| digits.len() == 4 && parse::hex(digits) == Some(index)),
            Self::Dummy(index) => key
                .strip_prefix("Dummy")
                .is_some_and(|digits| digits.len() == 4 && parse::hex(digits) == Some(index)),
            _ => key
                .strip_prefix(self.name())
                .is_some_and(|digits| !digits.starts_with('0')),
        }
    }
}
