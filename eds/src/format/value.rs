//! Values as the canonical form has them.

use crate::{
    document::{Document, Entry, Keyword, Section, SectionName},
    ir::DataType,
    literal::{self, Radix},
};

/// The value of `entry`: hex numbers with `0x` and capital digits, indices with four of them. What is no number stays.
pub(super) fn canonical(document: &Document, section: &Section, entry: &Entry) -> String {
    let text = document.text(entry.value);
    let index = || {
        literal::unsigned(text, u16::MAX.into())
            .ok()
            .filter(|read| read.notes.is_empty())
    };
    let written = match entry.keyword {
        Keyword::DataType => index().map(|index| format!("0x{:04X}", index.value)),
        Keyword::ObjectType => index().map(|code| format!("0x{:X}", code.value)),
        Keyword::Number(_) if is_list(section.name) => index().map(|index| format!("0x{:04X}", index.value)),
        keyword if is_number(document, section, keyword) => hex(text),
        _ => None,
    };
    written.unwrap_or_else(|| text.to_owned())
}

/// A list of objects.
const fn is_list(name: SectionName) -> bool {
    matches!(
        name,
        SectionName::MandatoryObjects | SectionName::OptionalObjects | SectionName::ManufacturerObjects
    )
}

/// Whether the keyword takes a number in this section, so that `0xab` cannot be a text or bytes.
fn is_number(document: &Document, section: &Section, keyword: Keyword) -> bool {
    match keyword {
        Keyword::DefaultValue | Keyword::ParameterValue | Keyword::LowLimit | Keyword::HighLimit => {
            let data_type = section.entry(Keyword::DataType);
            let number = data_type.map(|entry| literal::unsigned(document.text(entry.value), u16::MAX.into()));
            let index = number
                .and_then(Result::ok)
                .and_then(|number| u16::try_from(number.value).ok());
            let known = index.and_then(DataType::from_index);
            known.is_some_and(|data_type| data_type.is_unsigned() || data_type.is_signed())
        }
        Keyword::VendorNumber
        | Keyword::ProductNumber
        | Keyword::RevisionNumber
        | Keyword::LssSerialNumber
        | Keyword::SubNumber
        | Keyword::CompactSubObj
        | Keyword::ObjFlags
        | Keyword::PdoMapping => true,
        _ => false,
    }
}

/// A hex number, or a formula with one.
fn hex(text: &str) -> Option<String> {
    let start = text.find("0x").or_else(|| text.find("0X"))?;
    let (before, number) = text.split_at_checked(start)?;
    let digits = number.get(2..)?;
    let length = digits.bytes().take_while(u8::is_ascii_hexdigit).count();
    let (digits, after) = digits.split_at_checked(length)?;
    let is_whole = before.is_empty() && after.is_empty();
    let is_formula = before.starts_with("$NODEID") || after.ends_with("$NODEID");
    let plain = literal::integer(&format!("0x{digits}")).is_ok_and(|read| read.value.radix == Radix::Hex);
    (plain && (is_whole || is_formula)).then(|| format!("{before}0x{}{after}", digits.to_ascii_uppercase()))
}

#[cfg(test)]
mod tests {
    use super::hex;

    #[test]
    fn hex_digits_are_capital_and_what_is_no_number_stays() {
        assert_eq!(hex("0Xab").as_deref(), Some("0xAB"));
        assert_eq!(hex("$NODEID+0x1ff").as_deref(), Some("$NODEID+0x1FF"));
        assert_eq!(hex("0x1ff + $NODEID").as_deref(), Some("0x1FF + $NODEID"));
        assert_eq!(hex("-5"), None);
        assert_eq!(hex("0xab # text"), None);
    }
}
