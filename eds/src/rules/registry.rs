//! The one table of rules, in the order of their codes. A code that dies is not given again: it moves to [`RETIRED`].

use super::{Rule, com, dcf, dev, dmp, eds, enc, ini, lex, obj, pdo};

/// Rules that look at the same thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Family {
    /// The letters that its codes start with: `INI`.
    pub letters: &'static str,
    /// What its rules look at.
    pub title: &'static str,
}

pub(super) const FAMILIES: &[Family] = &[
    Family {
        letters: "INI",
        title: "the text of the file: bytes, lines, headers",
    },
    Family {
        letters: "EDS",
        title: "the structure of the file: sections, keywords, lists, numbers",
    },
    Family {
        letters: "OBJ",
        title: "the objects: types, access, limits, values",
    },
    Family {
        letters: "COM",
        title: "the communication objects of CiA 301",
    },
    Family {
        letters: "PDO",
        title: "the PDOs: what is mapped, when it is sent",
    },
    Family {
        letters: "DEV",
        title: "the device: `[DeviceInfo]`, held against the objects",
    },
    Family {
        letters: "ENC",
        title: "encoders: the objects of CiA 406",
    },
    Family {
        letters: "DCF",
        title: "a configured device: what a DCF adds to an EDS",
    },
    Family {
        letters: "DMP",
        title: "a device: what it answers, held against its file",
    },
    Family {
        letters: "LEX",
        title: "comments that speak to Lexican",
    },
];

const RULES: &[Rule] = &[
    Rule::document::<ini::JunkLine>(),
    Rule::document::<ini::DuplicateSection>(),
    Rule::document::<ini::DuplicateKeyword>(),
    Rule::document::<ini::TextNotAscii>(),
    Rule::document::<ini::KeywordOutsideSection>(),
    Rule::document::<ini::MalformedHeader>(),
    Rule::document::<ini::IndentedHeader>(),
    Rule::document::<ini::TextAfterHeader>(),
    Rule::document::<ini::OverlongLine>(),
    Rule::document::<ini::ControlCharacter>(),
    Rule::document::<ini::ByteOrderMark>(),
    Rule::document::<ini::MixedLineEnds>(),
    Rule::document::<ini::HashComment>(),
    Rule::document::<ini::ForeignFile>(),
    Rule::document::<eds::MissingSection>(),
    Rule::document::<eds::MissingKeyword>(),
    Rule::document::<eds::UnknownKeyword>(),
    Rule::model::<eds::UnreadableNumber>(),
    Rule::model::<eds::WrongObjectCount>(),
    Rule::reading::<eds::UnlistedObject>(),
    Rule::reading::<eds::AbsentObject>(),
    Rule::model::<eds::MisfiledObject>(),
    Rule::model::<eds::WrongSubNumber>(),
    Rule::document::<eds::UnknownSection>(),
    Rule::document::<eds::BadSectionName>(),
    Rule::document::<eds::KeywordSpelling>(),
    Rule::model::<eds::OctalNumber>(),
    Rule::model::<eds::ListGap>(),
    Rule::reading::<eds::TwiceListedObject>(),
    Rule::reading::<eds::OrphanedSubObject>(),
    Rule::model::<eds::WrongDate>(),
    Rule::model::<eds::WrongTime>(),
    Rule::model::<eds::LegacyKeyword>(),
    Rule::model::<eds::MisplacedKeyword>(),
    Rule::document::<eds::DcfKeyword>(),
    Rule::model::<eds::EmptyValue>(),
    Rule::model::<eds::OldEdsVersion>(),
    Rule::document::<eds::CommissioningSpelling>(),
    Rule::model::<eds::TrailingComment>(),
    Rule::model::<eds::CSuffix>(),
    Rule::model::<eds::QuotedText>(),
    Rule::reading::<eds::LineWithoutSubObject>(),
    Rule::reading::<eds::AbsentModule>(),
    Rule::reading::<eds::CrowdedDictionary>(),
    Rule::reading::<eds::AbsentLinkedObject>(),
    Rule::model::<eds::WrongEntryCount>(),
    Rule::model::<eds::ListWithoutCompactForm>(),
    Rule::reading::<eds::WrongFileName>(),
    Rule::dictionary::<obj::DefaultBeyondLimits>(),
    Rule::dictionary::<obj::InvertedLimits>(),
    Rule::model::<obj::ValueOfWrongType>(),
    Rule::model::<obj::LimitOfWrongType>(),
    Rule::reading::<obj::UnknownDataType>(),
    Rule::reading::<obj::ForeignDataType>(),
    Rule::reading::<obj::UnknownAccessType>(),
    Rule::reading::<obj::UnknownObjectType>(),
    Rule::reading::<obj::MissingSubIndexZero>(),
    Rule::reading::<obj::MisplacedAttribute>(),
    Rule::model::<obj::TwosComplement>(),
    Rule::model::<obj::WideHex>(),
    Rule::model::<obj::LetterCase>(),
    Rule::model::<obj::NodeIdSpelling>(),
    Rule::model::<obj::RealAsBits>(),
    Rule::model::<obj::UnorderedLimit>(),
    Rule::reading::<obj::SubObjectsOfSingleValue>(),
    Rule::reading::<obj::EmptyStructure>(),
    Rule::reading::<obj::TooManySubObjects>(),
    Rule::model::<obj::DomainValue>(),
    Rule::model::<obj::OctalValue>(),
    Rule::dictionary::<obj::InvertedReadOnlyLimits>(),
    Rule::model::<obj::NamedNumber>(),
    Rule::model::<obj::AbbreviatedAccessType>(),
    Rule::model::<obj::MixedStructure>(),
    Rule::dictionary::<obj::WrongSubIndexZeroType>(),
    Rule::reading::<obj::SilentSubIndexZero>(),
    Rule::dictionary::<obj::ArrayGap>(),
    Rule::dictionary::<obj::MixedArray>(),
    Rule::dictionary::<obj::RepeatedName>(),
    Rule::dictionary::<obj::NodeIdOverflow>(),
    Rule::model::<obj::EmptyName>(),
    Rule::model::<obj::TypedDomain>(),
    Rule::dictionary::<com::MissingMandatoryObject>(),
    Rule::dictionary::<com::WrongStandardType>(),
    Rule::dictionary::<com::RestrictedCanId>(),
    Rule::dictionary::<com::DuplicateCobId>(),
    Rule::reading::<com::WrongStandardCode>(),
    Rule::dictionary::<com::WritableStandardObject>(),
    Rule::dictionary::<com::WrongHighestSubIndex>(),
    Rule::dictionary::<com::MissingStandardSubIndex>(),
    Rule::dictionary::<com::UnknownStandardSubIndex>(),
    Rule::dictionary::<com::WrongStandardAccess>(),
    Rule::dictionary::<com::MappableStandardObject>(),
    Rule::dictionary::<com::UnknownCommunicationObject>(),
    Rule::dictionary::<com::UnusualCobId>(),
    Rule::dictionary::<com::FixedCobId>(),
    Rule::dictionary::<com::WrongStorageCapability>(),
    Rule::dictionary::<com::WrongHeartbeatConsumer>(),
    Rule::dictionary::<com::CompetingErrorControl>(),
    Rule::reading::<com::HalfNodeGuarding>(),
    Rule::dictionary::<com::ReservedStandardValue>(),
    Rule::dictionary::<com::RetiredObject>(),
    Rule::dictionary::<com::SharedReceiveCanId>(),
    Rule::dictionary::<com::MisplacedNodeId>(),
    Rule::dictionary::<com::WrongDefaultSdo>(),
    Rule::dictionary::<pdo::OversizedMapping>(),
    Rule::dictionary::<pdo::UnmappableObject>(),
    Rule::dictionary::<pdo::HalfAPdo>(),
    Rule::dictionary::<pdo::AbsentMappedObject>(),
    Rule::dictionary::<pdo::WrongDirection>(),
    Rule::dictionary::<pdo::UndirectedObject>(),
    Rule::dictionary::<pdo::UndirectedMappedObject>(),
    Rule::dictionary::<pdo::WrongMappedLength>(),
    Rule::dictionary::<pdo::UnmappableDataType>(),
    Rule::dictionary::<pdo::MappingGap>(),
    Rule::dictionary::<pdo::EmptyMappingEntry>(),
    Rule::dictionary::<pdo::MixedMappingAccess>(),
    Rule::dictionary::<pdo::DummyInTpdo>(),
    Rule::dictionary::<pdo::DisabledDummy>(),
    Rule::reading::<pdo::NeedlessGranularity>(),
    Rule::reading::<pdo::ZeroGranularity>(),
    Rule::dictionary::<pdo::TooFineMapping>(),
    Rule::reading::<pdo::TooFineDummy>(),
    Rule::dictionary::<pdo::ReservedTransmissionType>(),
    Rule::dictionary::<pdo::UngroupedMultiplexedPdo>(),
    Rule::dictionary::<pdo::WrongMappingCount>(),
    Rule::dictionary::<pdo::IdleMapping>(),
    Rule::dictionary::<pdo::ContraryDirection>(),
    Rule::dictionary::<pdo::PointlessMappability>(),
    Rule::dictionary::<pdo::TwiceMappedObject>(),
    Rule::dictionary::<pdo::UnaskablePdo>(),
    Rule::dictionary::<pdo::UntimedPdo>(),
    Rule::reading::<pdo::StrangeDummy>(),
    Rule::reading::<dev::WrongPdoCount>(),
    Rule::reading::<dev::WrongIdentity>(),
    Rule::reading::<dev::WrongSerialNumber>(),
    Rule::dictionary::<dev::WrongNumberOfPdos>(),
    Rule::reading::<dev::IncompleteLssAddress>(),
    Rule::reading::<dev::OversizedGranularity>(),
    Rule::reading::<dev::MissingBitRate>(),
    Rule::reading::<dev::UnknownBitRate>(),
    Rule::reading::<dev::HiddenDynamicChannels>(),
    Rule::reading::<dev::IdleCompactPdo>(),
    Rule::reading::<dev::HalfAModuleList>(),
    Rule::model::<dev::TwiceDescribedObject>(),
    Rule::model::<dev::FixedAndExtendedObject>(),
    Rule::model::<dev::UnequalFixedObject>(),
    Rule::reading::<dev::MissingBootUpRole>(),
    Rule::encoder::<enc::UnknownEncoderType>(),
    Rule::encoder::<enc::MissingEncoderObject>(),
    Rule::encoder::<enc::IncompleteClass>(),
    Rule::encoder::<enc::WrongEncoderCode>(),
    Rule::encoder::<enc::WrongEncoderType>(),
    Rule::encoder::<enc::WrongEncoderAccess>(),
    Rule::encoder::<enc::WrongEncoderMapping>(),
    Rule::encoder::<enc::ReservedBit>(),
    Rule::encoder::<enc::UnsupportedAlarm>(),
    Rule::encoder::<enc::IncompleteCam>(),
    Rule::encoder::<enc::IncompleteWorkArea>(),
    Rule::encoder::<enc::UnequalChannels>(),
    Rule::encoder::<enc::InvertedSwitchPoints>(),
    Rule::encoder::<enc::ImpossibleResolution>(),
    Rule::encoder::<enc::ContradictoryRevolutions>(),
    Rule::encoder::<enc::ZeroResolution>(),
    Rule::encoder::<enc::PresetBeyondRange>(),
    Rule::encoder::<enc::UnmappedPosition>(),
    Rule::encoder::<enc::DividedCycle>(),
    Rule::encoder::<enc::UnknownProfileVersion>(),
    Rule::encoder::<enc::UnknownEncoderObject>(),
    Rule::reading::<dcf::MissingCommissioning>(),
    Rule::reading::<dcf::CommissionedEds>(),
    Rule::document::<dcf::MissingLastEds>(),
    Rule::document::<dcf::IncompleteCommissioning>(),
    Rule::model::<dcf::ImpossibleNodeId>(),
    Rule::model::<dcf::UnknownBitRate>(),
    Rule::model::<dcf::UnsupportedBitRate>(),
    Rule::model::<dcf::ImpossibleNetNumber>(),
    Rule::reading::<dcf::ChangedConstantParameter>(),
    Rule::reading::<dcf::FileForValue>(),
    Rule::reading::<dcf::ContraryFile>(),
    Rule::reading::<dcf::AbsolutePath>(),
    Rule::dump::<dmp::MissingObject>(),
    Rule::dump::<dmp::UndeclaredObject>(),
    Rule::dump::<dmp::WrongLength>(),
    Rule::dump::<dmp::ChangedConstant>(),
    Rule::dump::<dmp::ChangedDefault>(),
    Rule::dump::<dmp::ValueBeyondLimits>(),
    Rule::dump::<dmp::WrongIdentity>(),
    Rule::dump::<dmp::WrongHighestSubIndex>(),
    Rule::dump::<dmp::UnreadableObject>(),
    Rule::dump::<dmp::ReadableWriteOnly>(),
    Rule::dump::<dmp::SilentObject>(),
    Rule::dump::<dmp::UnreadObject>(),
    Rule::dump::<dmp::FailedRead>(),
    Rule::dump::<dmp::WrongAbortCode>(),
    Rule::dump::<dmp::UnprintableString>(),
    Rule::dump::<dmp::WrongSdoCobId>(),
    Rule::dump::<dmp::CobIdOfAnotherNode>(),
    Rule::dump::<dmp::MixedDevices>(),
    Rule::dump::<dmp::UnappliedParameter>(),
    Rule::dump::<dmp::ImpossibleMapping>(),
    Rule::document::<lex::BadAllowance>(),
    Rule::allowance::<lex::IdleAllowance>(),
];

/// Codes of rules that are no more.
#[cfg(test)]
const RETIRED: &[&str] = &[];

/// All rules, in the order of their families and codes.
#[must_use]
pub const fn all() -> &'static [Rule] {
    RULES
}

/// All families.
#[must_use]
pub const fn families() -> &'static [Family] {
    FAMILIES
}

/// The rule with `code`, in any case.
#[must_use]
pub fn find(code: &str) -> Option<&'static Rule> {
    let mut rules = RULES.iter();
    rules.find(|rule| rule.code().as_str().eq_ignore_ascii_case(code))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The place in the table of families, then the number.
    fn order(code: &str) -> (Option<usize>, &str) {
        let family = FAMILIES.iter().position(|family| code.starts_with(family.letters));
        (family, &code[3..])
    }

    #[test]
    fn the_table_stands_in_the_order_of_the_codes_and_no_code_is_used_twice() {
        let codes: Vec<&str> = RULES.iter().map(|rule| rule.code().as_str()).collect();
        assert!(codes.is_sorted_by_key(|code| order(code)));
        assert!(codes.windows(2).all(|pair| pair[0] != pair[1]));
        assert!(codes.iter().all(|code| !RETIRED.contains(code)));
    }

    #[test]
    fn a_code_is_a_family_and_three_digits() {
        for code in RULES.iter().map(Rule::code) {
            assert!(FAMILIES.iter().any(|family| family.letters == code.family()), "{code}");
            let number = &code.as_str()[code.family().len()..];
            assert!(
                number.len() == 3 && number.bytes().all(|byte| byte.is_ascii_digit()),
                "{code}"
            );
        }
    }
}
