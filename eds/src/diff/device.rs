//! What the files say of the devices as a whole.

use super::{Difference, Effect, Subject, goes};
use crate::ir::{Commissioning, DeviceInfo, Dictionary, FileInfo};

/// Adds what differs between the sections about file and device.
pub(super) fn compare(old: &Dictionary, new: &Dictionary, found: &mut Vec<Difference>) {
    let section = |name: &str| Subject {
        title: format!("[{name}]"),
        name: String::new(),
    };
    let device = section("DeviceInfo");
    found.extend(identity(&device, &old.device, &new.device));
    found.extend(capabilities(&device, &old.device, &new.device));
    found.extend(services(&device, &old.device, &new.device));
    found.extend(dummies(&section("DummyUsage"), old, new));
    found.extend(commissioning(
        &section("DeviceComissioning"),
        &old.commissioning.clone().unwrap_or_default(),
        &new.commissioning.clone().unwrap_or_default(),
    ));
    found.extend(file(&section("FileInfo"), &old.file, &new.file));
}

/// A master finds out by vendor, product and the major revision, its high 16 bits, whether a device is the one that it is
/// made for (CiA 301, object 1018h); the minor revision changes nothing that it sees.
fn identity(subject: &Subject, old: &DeviceInfo, new: &DeviceInfo) -> impl Iterator<Item = Difference> {
    let major = |device: &DeviceInfo| device.revision_number.map(|number| number >> 16);
    let revision = if major(old) == major(new) {
        Effect::Cosmetic
    } else {
        goes(old.revision_number.is_some())
    };
    let number = |fact, old: Option<u32>, new, effect| subject.fact(fact, (old, new), hex, effect);
    let text = |fact, old: &str, new: &str| words(subject, fact, old, new);
    let all = [
        number(
            "VendorNumber",
            old.vendor_number,
            new.vendor_number,
            goes(old.vendor_number.is_some()),
        ),
        number(
            "ProductNumber",
            old.product_number,
            new.product_number,
            goes(old.product_number.is_some()),
        ),
        number("RevisionNumber", old.revision_number, new.revision_number, revision),
        text("VendorName", &old.vendor_name, &new.vendor_name),
        text("ProductName", &old.product_name, &new.product_name),
        text("OrderCode", &old.order_code, &new.order_code),
    ];
    all.into_iter().flatten()
}

fn capabilities(subject: &Subject, old: &DeviceInfo, new: &DeviceInfo) -> impl Iterator<Item = Difference> {
    let (before, after) = (&old.baud_rates.0, &new.baud_rates.0);
    let lost = before.iter().any(|rate| !after.contains(rate));
    let rates = subject.fact(
        "BaudRate",
        (before, after),
        |rates: &Vec<u16>| list(rates.iter()),
        goes(lost),
    );
    let fewer = |old: Option<u16>, new: Option<u16>| goes(new.unwrap_or_default() < old.unwrap_or_default());
    let pdos = |fact, old: Option<u16>, new: Option<u16>| subject.fact(fact, (old, new), number, fewer(old, new));
    // 0: no mapping can be changed; else the least length that can be mapped.
    let coarser = match (old.granularity, new.granularity) {
        (0, _) => false,
        (_, 0) => true,
        (old, new) => new > old,
    };
    let granularity = (old.granularity, new.granularity);
    let channels = (old.dynamic_channels_supported, new.dynamic_channels_supported);
    let all = [
        rates,
        pdos("NrOfRXPDO", old.nr_of_rx_pdo, new.nr_of_rx_pdo),
        pdos("NrOfTXPDO", old.nr_of_tx_pdo, new.nr_of_tx_pdo),
        subject.fact("Granularity", granularity, |value| number(Some(value)), goes(coarser)),
        subject.fact(
            "DynamicChannelsSupported",
            channels,
            |value| number(Some(value)),
            goes(channels.1 < channels.0),
        ),
        subject.fact(
            "CompactPDO",
            (old.compact_pdo, new.compact_pdo),
            |value| number(Some(value)),
            Effect::Cosmetic,
        ),
    ];
    all.into_iter().flatten()
}

fn services(subject: &Subject, old: &DeviceInfo, new: &DeviceInfo) -> impl Iterator<Item = Difference> {
    let flag = |fact, old: bool, new: bool| {
        let shown = |flag: bool| Some(u8::from(flag).to_string());
        subject.fact(fact, (old, new), shown, goes(old))
    };
    let serial = (old.lss_serial_number, new.lss_serial_number);
    let all = [
        flag(
            "SimpleBootUpMaster",
            old.simple_boot_up_master,
            new.simple_boot_up_master,
        ),
        flag("SimpleBootUpSlave", old.simple_boot_up_slave, new.simple_boot_up_slave),
        flag("GroupMessaging", old.group_messaging, new.group_messaging),
        flag("LSS_Supported", old.lss_supported, new.lss_supported),
        flag("NG_Slave", old.ng_slave, new.ng_slave),
        subject.fact("LSS_SerialNumber", serial, hex, Effect::Cosmetic),
    ];
    all.into_iter().flatten()
}

/// A dummy type that goes takes the mappings with it that it fills.
fn dummies(subject: &Subject, old: &Dictionary, new: &Dictionary) -> Option<Difference> {
    let lost = old.dummies.iter().any(|dummy| !new.dummies.contains(dummy));
    let names =
        |dictionary: &Dictionary| -> Vec<&str> { dictionary.dummies.iter().map(|dummy| dummy.name()).collect() };
    subject.fact(
        "Dummy",
        (names(old), names(new)),
        |names: Vec<&str>| list(names.iter()),
        goes(lost),
    )
}

fn commissioning(subject: &Subject, old: &Commissioning, new: &Commissioning) -> impl Iterator<Item = Difference> {
    let node = |commissioning: &Commissioning| commissioning.node_id.map(|node| u16::from(node.get()));
    let number = |fact, old: Option<u16>, new| subject.fact(fact, (old, new), number, goes(old.is_some()));
    let manager = (old.canopen_manager, new.canopen_manager);
    let all = [
        number("NodeID", node(old), node(new)),
        number("Baudrate", old.baud_rate, new.baud_rate),
        subject.fact(
            "CANopenManager",
            manager,
            |flag| Some(u8::from(flag).to_string()),
            goes(manager.0),
        ),
        subject.fact("NetNumber", (old.net_number, new.net_number), hex, Effect::Cosmetic),
        subject.fact(
            "LSS_SerialNumber",
            (old.lss_serial_number, new.lss_serial_number),
            hex,
            Effect::Cosmetic,
        ),
        words(subject, "NodeName", &old.node_name, &new.node_name),
        words(subject, "NetworkName", &old.network_name, &new.network_name),
    ];
    all.into_iter().flatten()
}

fn file(subject: &Subject, old: &FileInfo, new: &FileInfo) -> impl Iterator<Item = Difference> {
    let number = |fact, old: u32, new| subject.fact(fact, (old, new), |value| number(Some(value)), Effect::Cosmetic);
    let all = [
        words(subject, "FileName", &old.file_name, &new.file_name),
        number("FileVersion", old.file_version, new.file_version),
        number("FileRevision", old.file_revision, new.file_revision),
        words(subject, "EDSVersion", &old.eds_version, &new.eds_version),
        words(subject, "Description", &old.description, &new.description),
    ];
    all.into_iter().flatten()
}

fn words(subject: &Subject, fact: &'static str, old: &str, new: &str) -> Option<Difference> {
    let given = |word: &str| (!word.is_empty()).then(|| word.to_owned());
    subject.fact(fact, (old, new), given, Effect::Cosmetic)
}

fn hex(number: Option<u32>) -> Option<String> {
    number.map(|number| format!("0x{number:X}"))
}

fn number<T: ToString>(number: Option<T>) -> Option<String> {
    number.map(|number| number.to_string())
}

fn list<T: ToString>(items: impl Iterator<Item = T>) -> Option<String> {
    let items: Vec<String> = items.map(|item| item.to_string()).collect();
    (!items.is_empty()).then(|| items.join(", "))
}
