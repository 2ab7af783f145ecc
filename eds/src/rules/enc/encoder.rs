//! A device of profile CiA 406.

use super::standard::{Class, Kind, Standard, standard};
use crate::{
    ir::{Address, Dictionary, Entry, EntrySpans, Object, Value},
    span::Span,
};

/// What a file says of an encoder.
pub(crate) struct Encoder<'a> {
    pub(super) dictionary: &'a Dictionary,
    /// The encoder type, if the file gives one.
    pub(super) encoder_type: Option<EncoderType>,
}

/// The high word of the device type (CiA 406, object 1000h).
#[derive(Clone, Copy)]
pub(super) struct EncoderType {
    pub(super) code: u16,
    /// Where the device type stands.
    pub(super) span: Span,
}

/// A value that the profile knows, and the place of a fact about it.
pub(super) struct EncoderValue<'a> {
    pub(super) entry: &'a Entry,
    pub(super) standard: &'static Standard,
    /// Whether it is one of several.
    counted: bool,
    pub(super) at: Span,
}

impl EncoderValue<'_> {
    /// As a message names it: `6003h, preset value,` or `6030sub1, speed value,`.
    pub(super) fn named(&self) -> String {
        let (address, name) = (self.entry.address, self.standard.name.to_lowercase());
        if self.counted {
            return format!("{address}, {name},");
        }
        format!("{:04X}h, {name},", address.index)
    }

    /// Whether the file gives the fact; another rule tells that it is missing.
    pub(super) fn is_given(&self) -> bool {
        self.at != self.entry.spans.section
    }
}

/// A number after power-on, and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Number {
    pub(super) value: i128,
    pub(super) span: Span,
}

/// A device with several modules: what each of them is stands in 67FFh, 6FFFh … (CiA 301, object 1000h).
const SEVERAL_MODULES: u16 = 0xFFFF;

impl<'a> Encoder<'a> {
    /// The number of the profile.
    pub(crate) const PROFILE: u16 = 406;

    pub(crate) fn new(dictionary: &'a Dictionary) -> Self {
        let device = encoder_type(dictionary, 0x1000);
        let encoder_type = match device {
            Some(device) if device.code == SEVERAL_MODULES => encoder_type(dictionary, 0x67FF),
            device => device,
        };
        Self {
            dictionary,
            encoder_type,
        }
    }

    /// What the encoder type makes it: [`Kind::Any`] when the file does not say.
    pub(super) fn kind(&self) -> Kind {
        match self.encoder_type.map(|encoder_type| encoder_type.code) {
            Some(1..=5) => Kind::Rotary,
            Some(6..=9) => Kind::Linear,
            Some(10) => Kind::Multiple,
            _ => Kind::Any,
        }
    }

    /// The class that the device says it is of, in bits 0 to 2 of 650Eh; V2.0 has no such object.
    pub(super) fn class(&self) -> Option<Class> {
        match self.number(0x650E)?.value & 0b111 {
            1 => Some(Class::C1),
            // C3 is no less than C2.
            2 | 3 => Some(Class::C2),
            _ => None,
        }
    }

    pub(super) fn has(&self, index: u16) -> bool {
        self.dictionary.object(index).is_some()
    }

    /// The objects that the profile knows, each with what it says.
    pub(super) fn objects(&self) -> impl Iterator<Item = (&'a Object, &'static Standard)> {
        let objects = self.dictionary.objects.iter();
        objects.filter_map(|object| Some((object, standard(object.index)?)))
    }

    /// The values of these objects with the place of a fact about them, one for each place: in the compact form one line stands
    /// for many. Without the counts at sub-index 0, and without objects of another kind, which are ENC004.
    pub(super) fn values(&self, place: fn(&EntrySpans) -> Span) -> impl Iterator<Item = EncoderValue<'a>> {
        let like = self.objects().filter(|(object, standard)| standard.may_be(object.code));
        let all = like.flat_map(move |(object, standard)| {
            let counted = object.entries.len() > 1;
            let values = object.entries.iter();
            let values = values.filter(move |entry| !(counted && entry.address.sub == 0));
            values.map(move |entry| EncoderValue {
                entry,
                standard,
                counted,
                at: place(&entry.spans),
            })
        });
        let mut last = None;
        all.filter(move |value| last.replace(value.at) != Some(value.at))
    }

    /// The single value of `index` after power-on.
    pub(super) fn number(&self, index: u16) -> Option<Number> {
        self.number_at(Address::new(index, 0))
    }

    /// The value at `address` after power-on.
    pub(super) fn number_at(&self, address: Address) -> Option<Number> {
        let entry = self.dictionary.entry(address)?;
        let value = match entry.default {
            Some(Value::Unsigned(value)) => i128::from(value),
            Some(Value::Integer(value)) => i128::from(value),
            _ => return None,
        };
        let span = entry.spans.default;
        Some(Number { value, span })
    }
}

/// What the device type at `index` says, if it is that of an encoder.
fn encoder_type(dictionary: &Dictionary, index: u16) -> Option<EncoderType> {
    let entry = dictionary.entry(Address::new(index, 0))?;
    let Some(Value::Unsigned(device_type)) = entry.default else {
        return None;
    };
    let code = u16::try_from(device_type >> 16).ok()?;
    (device_type & 0xFFFF == u64::from(Encoder::PROFILE)).then_some(EncoderType {
        code,
        span: entry.spans.default,
    })
}
