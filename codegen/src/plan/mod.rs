//! What is to be generated, decided: every choice is made here, the emitters only write it down.

mod item;
mod kind;
mod limits;
mod options;
mod pdos;
mod pool;
mod row;
mod seeds;
mod storage;

use std::cmp::Reverse;

use lexican_eds::ir::{Address, Dictionary};

pub(crate) use item::Item;
pub(crate) use kind::{Kind, Width, is_string};
pub(crate) use options::Options;
pub(crate) use pdos::Pdos;
pub(crate) use pool::Pool;
pub(crate) use row::{Extra, Place, Row, Slot};
pub(crate) use seeds::Seeds;
pub(crate) use storage::Storage;

use row::Layout;

/// A dictionary as it will be generated.
#[derive(Debug)]
pub(crate) struct Plan<'a> {
    pub(crate) dictionary: &'a Dictionary,
    /// The file's name, as documentation gives it.
    pub(crate) file: &'a str,
    /// The module's name.
    pub(crate) module: String,
    /// Fields and constants, in the order of addresses.
    pub(crate) items: Vec<Item<'a>>,
    /// The table, in the order of addresses.
    pub(crate) rows: Vec<Row<'a>>,
    pub(crate) extras: Vec<Extra>,
    pub(crate) pool: Pool,
    pub(crate) seeds: Seeds,
}

/// What the compiler would put between fields, had they no names.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Padding {
    /// The number of the field that the gap is before.
    pub(crate) before: usize,
    /// Bytes of the gap.
    pub(crate) gap: usize,
    /// Bytes behind the last field.
    pub(crate) end: usize,
}

/// What the SDO server's buffer holds at least: the widest number, which may be sent in segments too.
const WIDEST_NUMBER: usize = 8;

impl<'a> Plan<'a> {
    /// Decides on `dictionary`.
    pub(crate) fn new(dictionary: &'a Dictionary, file: &'a str, module: String, options: &Options) -> Self {
        let items = Item::all(dictionary, options);
        let Layout { rows, extras, pool } = Layout::new(&items);
        let addresses: Vec<Address> = rows.iter().map(|row| row.entry.address).collect();
        Self {
            dictionary,
            file,
            module,
            items,
            rows,
            extras,
            pool,
            seeds: Seeds::search(&addresses),
        }
    }

    /// The items that are fields, in the struct's order: those that are 0 after power-on last, so that flash need not hold
    /// them; of both the widest first, so that no padding is needed between them.
    pub(crate) fn fields(&self) -> Vec<&Item<'a>> {
        let mut fields: Vec<&Item<'_>> = self
            .items
            .iter()
            .filter(|item| item.storage == Storage::Field)
            .collect();
        fields.sort_by_cached_key(|item| (item.is_zero(), Reverse(item.kind.alignment())));
        fields
    }

    /// The item that the value at `address` is in.
    #[cfg(feature = "templates")]
    pub(crate) fn item(&self, address: Address) -> Option<&Item<'a>> {
        let after = self.items.partition_point(|item| item.address() <= address);
        self.items.get(after.checked_sub(1)?)
    }

    /// The items that are constants, in the order of addresses.
    pub(crate) fn constants(&self) -> impl Iterator<Item = &Item<'a>> {
        self.items.iter().filter(|item| item.storage == Storage::Constant)
    }

    /// The items that the application answers for when a client reads them.
    pub(crate) fn reads(&self) -> impl Iterator<Item = &Item<'a>> {
        let items = self.items.iter().filter(|item| item.storage != Storage::Parts);
        items.filter(|item| !item.reads.is_empty())
    }

    /// The items that the application gives and takes in parts.
    pub(crate) fn parts(&self) -> impl Iterator<Item = &Item<'a>> {
        self.items.iter().filter(|item| item.storage == Storage::Parts)
    }

    /// The items that the application answers for when a client writes them.
    pub(crate) fn writes(&self) -> impl Iterator<Item = &Item<'a>> {
        let items = self.items.iter().filter(|item| item.storage != Storage::Parts);
        items.filter(|item| !item.writes.is_empty())
    }

    /// Where the struct needs padding, and how many bytes: before the fields that are 0, and at its end.
    pub(crate) fn padding(&self) -> Padding {
        let fields = self.fields();
        let (values, zeros) = fields.split_at(fields.partition_point(|item| !item.is_zero()));
        let size = |fields: &[&Item<'_>]| fields.iter().map(|item| item.size()).sum::<usize>();
        let alignment = |fields: &[&Item<'_>]| fields.iter().map(|item| item.kind.alignment()).max().unwrap_or(1);
        let gap = size(values).next_multiple_of(alignment(zeros)) - size(values);
        let whole = size(&fields) + gap;
        Padding {
            before: values.len(),
            gap,
            end: whole.next_multiple_of(alignment(&fields)) - whole,
        }
    }

    /// Bytes of the struct.
    pub(crate) fn size(&self) -> usize {
        let Padding { gap, end, .. } = self.padding();
        self.fields().iter().map(|item| item.size()).sum::<usize>() + gap + end
    }

    /// The PDOs that there are objects for.
    pub(crate) fn pdos(&self) -> Pdos {
        Pdos::of(self.dictionary)
    }

    /// How many nodes' heartbeats may be watched: the sub-indices of 1016h.
    pub(crate) fn watches(&self) -> usize {
        let addresses = self.rows.iter().map(|row| row.entry.address);
        let watches = addresses.filter(|address| address.index == 0x1016 && address.sub != 0);
        watches.count()
    }

    /// How many SDO servers there are beyond the first: the objects 1201h to 127Fh.
    pub(crate) fn servers(&self) -> usize {
        let addresses = self.rows.iter().map(|row| row.entry.address);
        let servers = addresses.filter(|address| matches!((address.index, address.sub), (0x1201..=0x127F, 1)));
        servers.count()
    }

    /// The bit rates of DeviceInfo that CiA 305's table has, a bit for each of its rows; `None` of a device without LSS.
    pub(crate) fn bit_rates(&self) -> Option<u16> {
        const TABLE: [u16; 9] = [1000, 800, 500, 250, 125, 0, 50, 20, 10];
        let has = |rate: &u16| self.dictionary.device.baud_rates.0.contains(rate);
        let rows = (0..).zip(TABLE).filter(|(_, rate)| has(rate));
        self.supports_lss()
            .then(|| rows.fold(0, |bits, (row, _)| bits | 1 << row))
    }

    /// Whether there is anything to store: parameters (1010h, 1011h), or what LSS configures.
    pub(crate) fn stores(&self) -> bool {
        let mut indices = self.dictionary.objects.iter().map(|object| object.index);
        self.supports_lss() || indices.any(|index| matches!(index, 0x1010 | 0x1011))
    }

    /// Whether PDOs may say themselves which object they carry.
    pub(crate) fn has_multiplexed_pdos(&self) -> bool {
        self.dictionary.device.group_messaging
    }

    /// Whether the device has the layer setting services.
    pub(crate) fn supports_lss(&self) -> bool {
        self.dictionary.device.lss_supported
    }

    /// Bytes that the longest value needs on its way.
    pub(crate) fn buffer(&self) -> usize {
        let items = self.items.iter().filter(|item| item.storage != Storage::Constant);
        let capacities = items.filter_map(|item| item.kind.capacity());
        capacities.fold(WIDEST_NUMBER, usize::max)
    }
}

#[cfg(test)]
pub(crate) fn test_entry(index: u16, sub: u8, data_type: lexican_eds::ir::DataType) -> lexican_eds::ir::Entry {
    lexican_eds::ir::Entry {
        address: Address::new(index, sub),
        name: String::new(),
        data_type,
        access: lexican_eds::ir::AccessType::Rw,
        pdo_mapping: false,
        default: None,
        configured: false,
        low: None,
        high: None,
        refuse_write_on_download: false,
        refuse_read_on_scan: false,
        denotation: None,
        upload_file: None,
        download_file: None,
        spans: lexican_eds::ir::EntrySpans::default(),
    }
}
