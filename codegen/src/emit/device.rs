//! The device: the dictionary and the application together, as the runtime sees them.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Arm, Expr, ImplItem, Item as SynItem, parse_quote};

use super::{
    node::{ident, number},
    rust_type,
};
use crate::{
    name::field_ident,
    plan::{Item, Kind, Plan},
};

/// So many arms stand in one function: Clippy counts its lines.
const ARMS: usize = 15;

/// The struct, its constructors and the runtime's trait.
pub(super) fn declaration(plan: &Plan<'_>) -> Vec<SynItem> {
    let mut items = if plan.stores() { storing() } else { forgetful() };
    let reads = Dispatch::new(quote!(before_read), plan.reads().map(read_arm));
    let writes = Dispatch::new(quote!(before_write), plan.writes().map(write_arm));
    items.push(implementation(plan, &reads, &writes));
    items.extend(image(plan));
    items.extend(overflow(plan, &reads, &writes));
    items
}

/// The values after power-on, as flash holds them.
fn image(plan: &Plan<'_>) -> [SynItem; 2] {
    let size = number(&plan.size().to_string());
    [
        parse_quote! {
            /// Bytes of the values; the compiler refuses any other number.
            const SIZE: usize = #size;
        },
        parse_quote! {
            /// The values after power-on, up to the last byte that is not 0.
            const POWER_ON: &[u8] = {
                const fn all() -> [u8; SIZE] { bytemuck::must_cast(Dictionary::DEFAULTS) }
                &resized::<{ written(&all()) }>(&all())
            };
        },
    ]
}

/// The struct of a device that stores nothing.
fn forgetful() -> Vec<SynItem> {
    let device = parse_quote! {
        /// The device: its dictionary, and the application behind it.
        #[derive(Clone, Debug)]
        pub struct Device<H> {
            /// The dictionary.
            pub od: Dictionary,
            /// The application.
            pub handlers: H,
        }
    };
    let constructor = parse_quote! {
        impl<H> Device<H> {
            /// The device after power-on; the node gives it its node-ID.
            #[must_use]
            pub const fn new(handlers: H) -> Self {
                Self { od: bytemuck::must_cast(resized::<SIZE>(POWER_ON)), handlers }
            }
        }
    };
    vec![device, constructor]
}

/// The struct of a device that stores parameters, or what LSS configures.
fn storing() -> Vec<SynItem> {
    let device = parse_quote! {
        /// The device: its dictionary, the application behind it, and the memory that outlives power-off.
        #[derive(Clone, Debug)]
        pub struct Device<H, S = lexican_runtime::storage::NoStorage> {
            /// The dictionary.
            pub od: Dictionary,
            /// The application.
            pub handlers: H,
            /// The memory.
            pub storage: S,
        }
    };
    let constructor = parse_quote! {
        impl<H> Device<H> {
            /// The device after power-on, without a memory; the node gives it its node-ID.
            #[must_use]
            pub const fn new(handlers: H) -> Self {
                Self::with_storage(handlers, lexican_runtime::storage::NoStorage)
            }
        }
    };
    let with_storage = parse_quote! {
        impl<H, S> Device<H, S> {
            /// The device after power-on; the node gives it its node-ID, and what is stored.
            #[must_use]
            pub const fn with_storage(handlers: H, storage: S) -> Self {
                Self { od: bytemuck::must_cast(resized::<SIZE>(POWER_ON)), handlers, storage }
            }
        }
    };
    vec![device, constructor, with_storage]
}

fn implementation(plan: &Plan<'_>, reads: &Dispatch, writes: &Dispatch) -> SynItem {
    let buffer = number(&plan.buffer().to_string());
    let pdos = plan.pdos();
    let [tpdos, rpdos, mapped] = [pdos.tpdos, pdos.rpdos, pdos.mapped].map(|count| number(&count.to_string()));
    let [watches, servers] = [plan.watches(), plan.servers()].map(|count| number(&count.to_string()));
    let dummy_usage = dummy_usage(pdos.dummy_usage);
    let services = services(plan);
    let bit_rates = bit_rates(plan);
    let (generics, device) = header(plan);
    let (storage_type, storage) = storage(plan);
    let read = reads.first(&quote!());
    let write = writes.first(&quote!(value: Value<'_>));
    let (read_part, write_part) = (read_part(plan), write_part(plan));
    parse_quote! {
        impl #generics lexican_runtime::Device for #device {
            type Buffer = [u8; #buffer];
            type Pdos = lexican_runtime::pdo::Pdos<#tpdos, #rpdos, #mapped>;
            type Storage = #storage_type;

            type Watches = [lexican_runtime::heartbeat::Watch; #watches];
            type Servers = [lexican_runtime::sdo::Channel<Self::Buffer>; #servers];

            const SERVICES: ServiceSet = #services;
            const NUMBERS: NumberSet = NumberSet::of(&ROWS);

            #[inline]
            fn table(&self) -> Table<'_> { TABLE }

            #[inline]
            fn values(&self) -> &[u8] { bytemuck::bytes_of(&self.od) }

            #[inline]
            fn values_mut(&mut self) -> &mut [u8] { bytemuck::bytes_of_mut(&mut self.od) }

            #[inline]
            fn defaults(&self) -> &[u8] { POWER_ON }

            #[inline]
            fn buffer(&self) -> Self::Buffer { [0; #buffer] }

            #[inline]
            fn pdos(&self) -> Self::Pdos { Self::Pdos::EMPTY }

            #[inline]
            fn watches(&self) -> Self::Watches { [lexican_runtime::heartbeat::Watch::NOBODY; #watches] }

            #[inline]
            fn servers(&self) -> Self::Servers { [lexican_runtime::sdo::Channel::IDLE; #servers] }

            #dummy_usage

            #bit_rates

            #storage

            #[inline]
            fn event(&mut self, event: Event) { self.handlers.event(&mut self.od, event); }

            #read
            #write
            #read_part
            #write_part
        }
    }
}

/// The generics of the runtime's trait, and the type that it is implemented for.
fn header(plan: &Plan<'_>) -> (TokenStream, TokenStream) {
    if plan.stores() {
        (
            quote!(<H: Handlers, S: lexican_runtime::storage::Storage>),
            quote!(Device<H, S>),
        )
    } else {
        (quote!(<H: Handlers>), quote!(Device<H>))
    }
}

/// The type of the memory for what is stored, and how it is reached.
fn storage(plan: &Plan<'_>) -> (TokenStream, Option<ImplItem>) {
    if !plan.stores() {
        return (quote!(lexican_runtime::storage::NoStorage), None);
    }
    let access = parse_quote! {
        #[inline]
        fn storage(&mut self) -> Option<&mut S> { Some(&mut self.storage) }
    };
    (quote!(S), Some(access))
}

/// The optional services: the objects say which, and DeviceInfo says LSS and multiplexed PDOs.
fn services(plan: &Plan<'_>) -> Expr {
    let lss = plan.supports_lss().then(|| quote!(.with(ServiceSet::LSS)));
    let mpdo = plan.has_multiplexed_pdos().then(|| quote!(.with(ServiceSet::MPDO)));
    parse_quote!(ServiceSet::of(&ROWS) #lss #mpdo)
}

/// Which dummy entries an RPDO may have; the runtime takes none for granted.
fn dummy_usage(bits: u8) -> Option<ImplItem> {
    let bits = number(&match bits {
        0 => return None,
        bits => format!("0x{bits:02X}"),
    });
    Some(parse_quote! {
        #[inline]
        fn dummy_usage(&self) -> u8 { #bits }
    })
}

/// The bit rates that LSS may set.
fn bit_rates(plan: &Plan<'_>) -> Option<ImplItem> {
    let bits = number(&format!("0x{:04X}", plan.bit_rates()?));
    Some(parse_quote! {
        #[inline]
        fn bit_rates(&self) -> lexican_runtime::lss::BitRates { lexican_runtime::lss::BitRates(#bits) }
    })
}

/// What did not fit into the first function of each kind.
fn overflow(plan: &Plan<'_>, reads: &Dispatch, writes: &Dispatch) -> Option<SynItem> {
    let methods: Vec<ImplItem> = reads
        .rest(&quote!())
        .into_iter()
        .chain(writes.rest(&quote!(value: Value<'_>)))
        .collect();
    if methods.is_empty() {
        return None;
    }
    let (generics, device) = header(plan);
    Some(parse_quote!(impl #generics #device { #(#methods)* }))
}

/// The choice of a handler by its address.
struct Dispatch {
    name: TokenStream,
    arms: Vec<Arm>,
}

impl Dispatch {
    fn new(name: TokenStream, arms: impl Iterator<Item = Arm>) -> Self {
        let arms = arms.collect();
        Self { name, arms }
    }

    /// The trait's method.
    fn first(&self, value: &TokenStream) -> ImplItem {
        self.method(0, self.arms.chunks(ARMS).next().unwrap_or_default(), value)
    }

    /// The methods that it goes on in.
    fn rest(&self, value: &TokenStream) -> Vec<ImplItem> {
        let rest = self.arms.chunks(ARMS).enumerate().skip(1);
        rest.map(|(number, arms)| self.method(number, arms, value)).collect()
    }

    fn method(&self, number: usize, arms: &[Arm], value: &TokenStream) -> ImplItem {
        let name = self.part(number);
        if arms.is_empty() {
            let value = (!value.is_empty()).then(|| quote!(_: Value<'_>));
            return parse_quote!(fn #name(&mut self, _: Address, #value) -> Result<(), AbortCode> { Ok(()) });
        }
        let otherwise = self.otherwise(number, value);
        parse_quote! {
            fn #name(&mut self, address: Address, #value) -> Result<(), AbortCode> {
                let Self { od, handlers, .. } = self;
                match (address.index, address.sub) {
                    #(#arms,)*
                    _ => #otherwise,
                }
            }
        }
    }

    /// What is done for an address that has no arm in the method `number`.
    fn otherwise(&self, number: usize, value: &TokenStream) -> Expr {
        if (number + 1) * ARMS >= self.arms.len() {
            return parse_quote!(Ok(()));
        }
        let next = self.part(number + 1);
        let value = (!value.is_empty()).then(|| quote!(value));
        parse_quote!(self.#next(address, #value))
    }

    fn part(&self, number: usize) -> syn::Ident {
        let name = &self.name;
        match number {
            0 => ident(&name.to_string()),
            number => ident(&format!("{name}_{number}")),
        }
    }
}

/// The choice of who gives a part, if anyone does.
fn read_part(plan: &Plan<'_>) -> Option<ImplItem> {
    let arms: Vec<Arm> = plan
        .parts()
        .filter(|item| !item.reads.is_empty())
        .map(read_part_arm)
        .collect();
    if arms.is_empty() {
        return None;
    }
    Some(parse_quote! {
        fn read_part(&mut self, address: Address, offset: usize, buffer: &mut [u8]) -> Result<usize, AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                #(#arms,)*
                _ => Err(AbortCode::NO_DATA),
            }
        }
    })
}

fn read_part_arm(item: &Item<'_>) -> Arm {
    let pattern = pattern(item, &item.reads);
    let method = ident(&format!("read_{}", item.name));
    let sub = item.is_array.then(|| quote!(sub,));
    parse_quote!(#pattern => handlers.#method(od, #sub offset, buffer))
}

/// The choice of who takes a part, if anyone does.
fn write_part(plan: &Plan<'_>) -> Option<ImplItem> {
    let arms: Vec<Arm> = plan
        .parts()
        .filter(|item| !item.writes.is_empty())
        .map(write_part_arm)
        .collect();
    if arms.is_empty() {
        return None;
    }
    Some(parse_quote! {
        fn write_part(&mut self, address: Address, part: Part<'_>) -> Result<(), AbortCode> {
            let Self { od, handlers, .. } = self;
            match (address.index, address.sub) {
                #(#arms,)*
                _ => Err(AbortCode::NOT_STORED),
            }
        }
    })
}

fn write_part_arm(item: &Item<'_>) -> Arm {
    let pattern = pattern(item, &item.writes);
    let method = ident(&format!("write_{}", item.name));
    let sub = item.is_array.then(|| quote!(sub,));
    parse_quote!(#pattern => handlers.#method(od, #sub part))
}

fn read_arm(item: &Item<'_>) -> Arm {
    let pattern = pattern(item, &item.reads);
    let method = ident(&format!("read_{}", item.name));
    let field = ident(&field_ident(&item.name));
    if item.is_array {
        let value: Expr = if item.kind == Kind::Boolean {
            parse_quote!(value.into())
        } else {
            parse_quote!(value)
        };
        return parse_quote!(#pattern => handlers.#method(od, sub).map(|value| set_element(&mut od.#field, sub, #value)));
    }
    match item.kind {
        Kind::Boolean => parse_quote!(#pattern => handlers.#method(od).map(|value| od.#field = value.into())),
        _ => parse_quote!(#pattern => handlers.#method(od).map(|value| od.#field = value)),
    }
}

fn write_arm(item: &Item<'_>) -> Arm {
    let pattern = pattern(item, &item.writes);
    let method = ident(&format!("write_{}", item.name));
    let conversion = ident(&rust_type::conversion(item.kind));
    let sub = item.is_array.then(|| quote!(sub,));
    parse_quote!(#pattern => handlers.#method(od, #sub value.#conversion()))
}

/// `(0x6004, 0x00)`, `(0x6030, sub @ 0x01..=0x03)`
fn pattern(item: &Item<'_>, subs: &[u8]) -> TokenStream {
    let index = number(&format!("0x{:04X}", item.object.index));
    let runs = subs.chunk_by(|a, b| a + 1 == *b).map(run);
    let sub: TokenStream = if item.is_array {
        binding(&runs.collect::<Vec<_>>())
    } else {
        runs.collect()
    };
    quote!((#index, #sub))
}

/// `sub @ 0x01`, `sub @ (0x01 | 0x03)`
fn binding(runs: &[TokenStream]) -> TokenStream {
    match runs {
        [run] => quote!(sub @ #run),
        runs => quote!(sub @ (#(#runs)|*)),
    }
}

/// Sub-indices that follow one another.
fn run(subs: &[u8]) -> TokenStream {
    let hex = |sub: &u8| number(&format!("0x{sub:02X}"));
    match subs {
        [first, .., last] => {
            let (first, last) = (hex(first), hex(last));
            quote!(#first..=#last)
        }
        subs => subs.iter().map(hex).map(|sub| quote!(#sub)).collect(),
    }
}
