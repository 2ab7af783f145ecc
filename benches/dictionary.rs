//! Writes a dictionary as `lexican-codegen` does, until it does.

use crate::eds;

fn width(data_type: u8) -> usize {
    [0, 1, 1, 2, 4, 1, 2, 4][usize::from(data_type & 7)]
}

/// The Rust source of the dictionary of `entries`.
pub fn generate(mut entries: Vec<eds::Entry>) -> String {
    entries.sort_by_key(|entry| (std::cmp::Reverse(if entry.data_type > 7 { 0 } else { width(entry.data_type) }), entry.index, entry.sub));
    let (mut values, mut constants) = (Vec::<u8>::new(), Vec::<u8>::new());
    let (mut rows, mut extras) = (Vec::new(), Vec::new());
    for entry in &entries {
        let constant = entry.access == "const";
        let bytes = if constant { &mut constants } else { &mut values };
        let mut slot = bytes.len();
        let mut access = match entry.access.as_str() {
            "const" => 0x11,
            "ro" => 0x01,
            _ => 0x03,
        };
        if entry.default.to_lowercase().contains("$nodeid") {
            access |= 0x100;
        }
        if entry.data_type > 7 {
            let capacity = entry.default.len().max(64);
            if constant {
                bytes.extend(entry.default.bytes());
                extras.push((slot, entry.default.len()));
            } else {
                bytes.extend((entry.default.len() as u16).to_le_bytes());
                bytes.extend(entry.default.bytes());
                bytes.resize(slot + 2 + capacity, 0);
                extras.push((slot, capacity));
            }
            access |= 0x20;
            slot = extras.len() - 1;
        } else {
            bytes.extend(&entry.number().to_le_bytes()[..width(entry.data_type)]);
        }
        rows.push((entry.index, entry.sub, entry.data_type, access, slot));
    }
    values.resize(values.len().next_multiple_of(4), 0);
    let addresses: Vec<(u16, u8)> = rows.iter().map(|row| (row.0, row.1)).collect();
    let places = rows.len() + rows.len() / 32 + 1;
    let seeds = seeds(&addresses, rows.len() / 3 + 1, places);
    let words: Vec<u32> = values.chunks(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
    let rows: String = rows
        .iter()
        .map(|(index, sub, data_type, access, slot)| {
            format!("Entry::new({index:#06x}, {sub}, DataType({data_type}), Access({access:#x}), {slot}),\n")
        })
        .collect();
    let extras: String = extras.iter().map(|(slot, detail)| format!("Extra::new({slot}, {detail}),\n")).collect();
    format!(
        "#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
        #[bytemuck(crate = \"lexican_runtime::bytemuck\")]
        #[repr(C)]
        pub struct Dictionary([u32; {words_len}]);
        const DEFAULTS: Dictionary = Dictionary({words:?});
        pub struct Device(Dictionary);
        impl Device {{ pub const fn new() -> Self {{ Self(DEFAULTS) }} }}
        const SORTED: [Entry; {len}] = [{rows}];
        const SEEDS: [u16; {seeds_len}] = {seeds:?};
        const TABLE: Table<'static> = Table {{ entries: &place::<{len}, {places}>(&SORTED, &SEEDS), seeds: &SEEDS, extras: &[{extras}], constants: &{constants:?} }};
        impl lexican_runtime::Device for Device {{
            type Buffer = [u8; 256];
            #[inline] fn table(&self) -> Table<'_> {{ TABLE }}
            #[inline] fn values(&self) -> &[u8] {{ bytemuck::bytes_of(&self.0) }}
            #[inline] fn values_mut(&mut self) -> &mut [u8] {{ bytemuck::bytes_of_mut(&mut self.0) }}
            #[inline] fn defaults(&self) -> &[u8] {{ bytemuck::bytes_of(&DEFAULTS) }}
            #[inline] fn buffer(&self) -> Self::Buffer {{ [0; 256] }}
            fn before_read(&mut self, _: Address) -> Result<(), AbortCode> {{ Ok(()) }}
            fn before_write(&mut self, _: Address, _: Value<'_>) -> Result<(), AbortCode> {{ Ok(()) }}
        }}",
        words_len = words.len(),
        len = entries.len(),
        seeds_len = seeds.len(),
    )
}

fn scale(hash: u32, length: usize) -> usize {
    ((u64::from(hash) * length as u64) >> 32) as usize
}

fn seeds(addresses: &[(u16, u8)], count: usize, places: usize) -> Vec<u16> {
    let mut buckets = vec![Vec::new(); count];
    for &(index, sub) in addresses {
        let key = (u32::from(index) << 8 | u32::from(sub)).wrapping_mul(0x9E37_79B1);
        buckets[scale(key, count)].push(key);
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by_key(|&bucket| std::cmp::Reverse(buckets[bucket].len()));
    let (mut used, mut seeds) = (vec![false; places], vec![0; count]);
    for bucket in order {
        seeds[bucket] = (0..=u16::MAX)
            .find(|&seed| {
                let mut wanted: Vec<usize> =
                    buckets[bucket].iter().map(|key| scale((key ^ u32::from(seed)).wrapping_mul(0x85EB_CA6B), places)).collect();
                wanted.sort_unstable();
                let free = wanted.windows(2).all(|pair| pair[0] != pair[1]) && wanted.iter().all(|&place| !used[place]);
                if free {
                    wanted.iter().for_each(|&place| used[place] = true);
                }
                free
            })
            .expect("a seed");
    }
    seeds
}
