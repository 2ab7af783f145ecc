//! What is in the firmware crate that `lexican new` writes: from a dictionary to the texts of its files.

use lexican_codegen::{Generated, Selector};
use lexican_eds::{
    ir::{Address, Dictionary, Entry, NodeId, Value},
    rules::LevelChange,
};
use lexican_templates::{Error, context, scaffold};

/// What is asked for beside a dictionary.
#[derive(Debug)]
pub(crate) struct Scaffold<'a> {
    /// The crate's name.
    pub(crate) package: &'a str,
    /// The EDS file's name in the crate.
    pub(crate) eds: &'a str,
    /// The node-ID that the device starts with, 1 to 127.
    pub(crate) node_id: u8,
    /// The dependency on lexican-runtime as TOML, and that on lexican-codegen.
    pub(crate) runtime: String,
    pub(crate) codegen: String,
    /// What the application answers for.
    pub(crate) handled: &'a [Selector],
    pub(crate) levels: &'a [LevelChange],
}

/// What a client may do with a value of one to four bytes, as bytes of Rust.
#[derive(Debug)]
struct Dialogue {
    read: String,
    response: String,
    write: String,
    written: String,
}

impl Scaffold<'_> {
    /// The files but for the EDS: where each goes, and its text.
    pub(crate) fn files(&self, generated: &Generated) -> Result<Vec<(&'static str, String)>, Error> {
        let dictionary = generated.dictionary();
        scaffold::render(&context! {
            package => self.package,
            crate_name => self.package.replace('-', "_"),
            node_id => self.node_id,
            runtime => &self.runtime,
            codegen => &self.codegen,
            eds => format!("{:?}", self.eds),
            builder => self.builder(),
            device_type => self.device_type(dictionary),
            example => self.example(dictionary),
            ..generated.context()
        })
    }

    /// The calls after `new`.
    fn builder(&self) -> Vec<String> {
        let levels = self.levels.iter().map(|change| {
            let (selector, level) = (change.selector(), change.level());
            format!(".level({selector:?}, lexican_codegen::Level::{level:?})")
        });
        let (mut objects, mut values) = (Vec::new(), Vec::new());
        for selector in self.handled {
            match selector {
                Selector::Object(index) => objects.push(format!("0x{index:04X}")),
                Selector::Value(index, sub) => values.push(format!("(0x{index:04X}, {sub})")),
            }
        }
        let lines = [objects, values].into_iter().filter(|list| !list.is_empty());
        let handles = lines.map(|list| format!(".handle([{}])", list.join(", ")));
        levels.chain(handles).collect()
    }

    /// What reading 1000h is answered with.
    fn device_type(&self, dictionary: &Dictionary) -> Option<lexican_templates::Value> {
        let entry = dictionary.entry(Address::new(0x1000, 0))?;
        let value = self.default(entry);
        let dialogue = dialogue(entry, &value).filter(|_| entry.access.readable())?;
        let number = value.iter().rev().map(|byte| format!("{byte:02X}"));
        let value = number.collect::<String>() + "h";
        Some(context! { value, response => dialogue.response })
    }

    /// The first handled value that a client may write its default to.
    fn example(&self, dictionary: &Dictionary) -> Option<lexican_templates::Value> {
        let entry = dictionary.entries().find(|entry| {
            let Address { index, sub } = entry.address;
            let is_handled = |selector: &Selector| match *selector {
                Selector::Object(object) => object == index,
                Selector::Value(object, value) => (object, value) == (index, sub),
            };
            self.handled.iter().any(is_handled) && is_rewritable(entry)
        })?;
        let Dialogue {
            read,
            response,
            write,
            written,
        } = dialogue(entry, &self.default(entry))?;
        let test = match entry.address {
            Address { index, sub: 0 } => format!("object_{index:04x}"),
            Address { index, sub } => format!("object_{index:04x}_sub_{sub}"),
        };
        Some(context! { test, read, response, write, written })
    }

    /// On the bus, after power-on.
    fn default(&self, entry: &Entry) -> Vec<u8> {
        match &entry.default {
            Some(default) => default.to_bytes(entry.data_type, NodeId::new(self.node_id)),
            None => vec![0; entry.data_type.bytes().unwrap_or(0)],
        }
    }
}

/// An object to show a handler with, where the user names none: the first of the device's own that a client may write.
pub(crate) fn object_to_handle(dictionary: &Dictionary) -> Option<Selector> {
    let mut objects = dictionary.objects.iter().filter(|object| object.index >= 0x2000);
    let first = objects.find(|object| object.entry(0).is_some_and(is_rewritable))?;
    Some(Selector::Object(first.index))
}

/// Whether writing its default changes nothing, and is allowed.
fn is_rewritable(entry: &Entry) -> bool {
    let Some(default @ (Value::Integer(_) | Value::Unsigned(_))) = &entry.default else {
        return false;
    };
    let is_below = |one: &Value, other: &Value| one.compare(other, None).is_some_and(std::cmp::Ordering::is_lt);
    let is_too_low = entry.low.as_ref().is_some_and(|low| is_below(default, low));
    let is_too_high = entry.high.as_ref().is_some_and(|high| is_below(high, default));
    let is_service = (0x1000..0x2000).contains(&entry.address.index);
    entry.access.writable() && entry.access.readable() && !(is_too_low || is_too_high || is_service)
}

/// Reading and writing `value` by expedited transfers (CiA 301, 7.2.4.3); `None` when it has not one to four bytes.
fn dialogue(entry: &Entry, value: &[u8]) -> Option<Dialogue> {
    let unused = 4_u8.checked_sub(u8::try_from(value.len()).ok()?)?;
    let mut padded = [0; 4];
    padded.get_mut(..value.len())?.copy_from_slice(value);
    let message = |command: u8, data: [u8; 4]| {
        let [low, high] = entry.address.index.to_le_bytes();
        let head = [command, low, high, entry.address.sub].into_iter();
        let bytes = head.chain(data).map(|byte| format!("0x{byte:02X}"));
        bytes.collect::<Vec<_>>().join(", ")
    };
    let size = unused << 2;
    (unused < 4).then(|| Dialogue {
        read: message(0x40, [0; 4]),
        response: message(0x43 | size, padded),
        write: message(0x23 | size, padded),
        written: message(0x60, [0; 4]),
    })
}
