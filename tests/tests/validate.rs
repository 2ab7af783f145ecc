//! The full circle: a file becomes a device, the device is dumped, the dump is held against the file. Then the dump is changed
//! in one place, and that place is found.

use std::{fs, path::Path};

use lexican_eds::{
    Reading,
    diagnostic::{Diagnostic, Level},
    dump::{AbortCode, Answer, Dump},
    ir::{AccessType, Address, Entry, NodeId, ObjectCode, Value},
    rules::{self, Levels},
};
use lexican_runtime::Device;
use lexican_tests::{
    bus::Bus,
    generated::{cia406, cia406_multi, wdga, wdga_configured, wdga_st, wv58mr, wv58mr_configured, wv58mr_st},
    memory::Memory,
    sdo_client,
    simulated::{Simulated, complete},
};

/// A file, and the dump of a device that was made of it.
struct Circle {
    reading: Reading,
    dump: Dump,
}

impl Circle {
    /// A device that is put together from what the file says.
    fn simulated(file: &str) -> Self {
        let reading = read(file);
        let device = Simulated::of(&complete(&reading.dictionary));
        Self::new(reading, device)
    }

    /// A device that was generated from the file.
    fn generated(file: &str, device: impl Device) -> Self {
        Self::new(read(file), device)
    }

    fn new(reading: Reading, device: impl Device) -> Self {
        let mut bus = Bus::booted(device, 5);
        let addresses = reading.dictionary.entries().map(|entry| entry.address);
        let dump = sdo_client::dump(&mut bus, addresses);
        Self { reading, dump }
    }

    /// What is found once the dump was written and read.
    fn findings(&self) -> Vec<Diagnostic> {
        let read = Dump::from_json(self.dump.to_json().as_bytes()).expect("what was written");
        assert!(read.objects.len() > 50);
        self.validate(&read)
    }

    fn validate(&self, dump: &Dump) -> Vec<Diagnostic> {
        rules::validate(&self.reading, dump, &Levels::default())
    }

    /// What is found when the answer at `address` is `answer`.
    fn with(&self, address: Address, answer: Answer) -> Vec<Diagnostic> {
        let mut dump = self.dump.clone();
        dump.objects.insert(address, answer);
        self.validate(&dump)
    }

    /// What is found when `address` answers with these bytes: something, of that address only, at deny.
    #[track_caller]
    fn assert_found(&self, entry: &Entry, bytes: &[u8], code: Option<&str>) {
        self.assert_names(
            entry,
            &self.with(entry.address, Answer::Value(bytes.to_vec())),
            code,
            &format!("{bytes:02X?}"),
        );
    }

    #[track_caller]
    fn assert_names(&self, entry: &Entry, found: &[Diagnostic], code: Option<&str>, change: &str) {
        let name = self.named(entry);
        assert!(!found.is_empty(), "{name} with {change} is not found");
        assert!(
            found.iter().all(|diagnostic| diagnostic.message.contains(&name)),
            "{name} {change}: {found:#?}"
        );
        let is_right = |diagnostic: &Diagnostic| match code {
            Some(code) => diagnostic.code.as_str() == code,
            None => diagnostic.level == Level::Deny,
        };
        assert!(found.iter().any(is_right), "{name} {change}: {found:#?}");
    }

    fn named(&self, entry: &Entry) -> String {
        if self.has_sub_indices(entry) {
            return entry.address.to_string();
        }
        format!("{:04X}h", entry.address.index)
    }

    fn has_sub_indices(&self, entry: &Entry) -> bool {
        let object = self.reading.dictionary.object(entry.address.index);
        object.is_some_and(|object| matches!(object.code, ObjectCode::Array | ObjectCode::Record))
    }

    /// The entries that answered with bytes.
    fn answered(&self) -> impl Iterator<Item = (&Entry, &[u8])> {
        let entries = self.reading.dictionary.entries();
        entries.filter_map(|entry| Some((entry, self.dump.value(entry.address)?)))
    }
}

fn read(file: &str) -> Reading {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/devices").join(file);
    lexican_eds::read(file, fs::read(path).expect("one of our files"))
}

/// The generated encoders, which are changed in every place.
fn encoders() -> [Circle; 2] {
    [
        Circle::generated("wdga.eds", wdga::Device::with_storage((), memory())),
        Circle::generated("wv58mr.eds", wv58mr::Device::with_storage((), memory())),
    ]
}

/// Runs `judge` on the encoders; it gives the number of changes that it judged.
fn each_encoder(judge: impl Fn(&Circle) -> usize) {
    for circle in encoders() {
        let judged = judge(&circle);
        assert!(judged > 20, "only {judged} changes");
    }
}

/// What a device stores its parameters in: without one, 1010h and 1011h say so, and differ from the file.
fn memory() -> Memory {
    Memory::flash(0x4000)
}

#[test]
fn a_generated_device_is_the_one_of_its_file() {
    let circles = [
        Circle::generated("cia406.eds", cia406::Device::with_storage((), memory())),
        Circle::generated("cia406-multi.eds", cia406_multi::Device::with_storage((), memory())),
        Circle::generated("wdga.eds", wdga::Device::with_storage((), memory())),
        Circle::generated("wdga-st.eds", wdga_st::Device::with_storage((), memory())),
        Circle::generated("wv58mr.eds", wv58mr::Device::with_storage((), memory())),
        Circle::generated("wv58mr-st.eds", wv58mr_st::Device::with_storage((), memory())),
        Circle::generated("wv58mr.dcf", wv58mr_configured::Device::with_storage((), memory())),
    ];
    for circle in circles {
        assert_eq!(circle.findings(), [], "{}", circle.reading.document.source().name());
    }
}

#[test]
fn a_generated_device_has_no_serial_number_until_it_is_given_one() {
    let found = Circle::generated("wdga.dcf", wdga_configured::Device::with_storage((), memory())).findings();
    let messages: Vec<&str> = found.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
    assert_eq!(
        messages,
        ["1018sub4 answers 0x00000000; LSS_SerialNumber says 0x00BC6138"]
    );
}

#[test]
fn a_simulated_device_is_the_one_of_its_file() {
    for file in [
        "wdga.eds",
        "wdga.dcf",
        "wv58mr.eds",
        "wv58mr.dcf",
        "cia406.eds",
        "cia406-multi.eds",
    ] {
        assert_eq!(Circle::simulated(file).findings(), [], "{file}");
    }
}

#[test]
fn any_changed_byte_of_a_constant_or_of_the_identity_is_found_and_named() {
    each_encoder(|circle| {
        let mut judged = 0;
        for (entry, bytes) in circle.answered().filter(|(entry, _)| is_fixed(entry)) {
            for place in 0..bytes.len() {
                let mut changed = bytes.to_vec();
                changed[place] ^= 0x01;
                circle.assert_found(entry, &changed, None);
                judged += 1;
            }
        }
        judged
    });
}

/// Whether the file says what the value is, once and for all.
fn is_fixed(entry: &Entry) -> bool {
    let identity = matches!((entry.address.index, entry.address.sub), (0x1000, 0) | (0x1018, 1..=3));
    entry.default.is_some() && (entry.access == AccessType::Const || identity)
}

#[test]
fn a_value_a_byte_short_or_long_is_found_and_named() {
    each_encoder(|circle| {
        let mut judged = 0;
        for (entry, bytes) in circle.answered().filter(|(entry, _)| entry.data_type.bytes().is_some()) {
            let (_, short) = bytes.split_last().expect("at least a byte");
            let long = [bytes, &[0]].concat();
            circle.assert_found(entry, short, Some("DMP003"));
            circle.assert_found(entry, &long, Some("DMP003"));
            judged += 2;
        }
        judged
    });
}

#[test]
fn a_value_beyond_its_limits_is_found_and_named() {
    let mut judged = 0;
    for circle in encoders() {
        for (entry, _) in circle.answered() {
            let beyond = [(entry.low.as_ref(), -1), (entry.high.as_ref(), 1)];
            for bytes in beyond
                .into_iter()
                .filter_map(|(limit, step)| neighbour(entry, limit?, step))
            {
                circle.assert_found(entry, &bytes, Some("DMP006"));
                judged += 1;
            }
        }
    }
    assert!(judged > 20, "only {judged} changes");
}

/// The bytes of the number next to `limit`; `None` where the data type ends.
fn neighbour(entry: &Entry, limit: &Value, step: i8) -> Option<Vec<u8>> {
    let next = match *limit {
        Value::Unsigned(number) => Value::Unsigned(number.checked_add_signed(step.into())?),
        Value::Integer(number) => Value::Integer(number.checked_add(step.into())?),
        _ => return None,
    };
    let bytes = next.to_bytes(entry.data_type, None);
    (Value::from_bytes(&bytes, entry.data_type)? == next).then_some(bytes)
}

#[test]
fn any_object_that_was_not_asked_for_is_found_and_named() {
    each_encoder(|circle| {
        let readable = circle
            .reading
            .dictionary
            .entries()
            .filter(|entry| entry.access.readable());
        readable.fold(0, |judged, entry| {
            let mut dump = circle.dump.clone();
            dump.objects.remove(&entry.address);
            circle.assert_names(entry, &circle.validate(&dump), Some("DMP012"), "dropped");
            judged + 1
        })
    });
}

#[test]
fn any_object_that_is_refused_is_found_and_named() {
    each_encoder(|circle| {
        let mut judged = 0;
        for (entry, _) in circle.answered().filter(|(entry, _)| !is_empty_error(entry)) {
            for (answer, code) in refusals(circle.has_sub_indices(entry)) {
                let found = circle.with(entry.address, answer.clone());
                circle.assert_names(entry, &found, Some(code), &format!("{answer:?}"));
                judged += 1;
            }
        }
        judged
    });
}

/// What a device may say instead of a value, with the code that it is found under.
fn refusals(of_sub_index: bool) -> [(Answer, &'static str); 4] {
    let absence = if of_sub_index {
        AbortCode::NO_SUCH_SUB_INDEX
    } else {
        AbortCode::NO_SUCH_OBJECT
    };
    [
        (Answer::Abort(absence), "DMP001"),
        (Answer::Abort(AbortCode::WRITE_ONLY), "DMP009"),
        (Answer::Abort(AbortCode(0x0800_0020)), "DMP013"),
        (Answer::Timeout, "DMP011"),
    ]
}

/// An error that has not happened may be refused in any way.
fn is_empty_error(entry: &Entry) -> bool {
    entry.address.index == 0x1003 && entry.address.sub > 0
}

#[test]
fn any_object_that_the_file_does_not_have_is_found_and_named() {
    let [circle, _] = encoders();
    let free = (0x1000..=0x9FFF)
        .step_by(0x35)
        .filter(|index| circle.reading.dictionary.object(*index).is_none());
    let mut judged = 0;
    for index in free {
        let found = circle.with(Address::new(index, 0), Answer::Value(vec![0]));
        let messages: Vec<&str> = found.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
        assert_eq!(
            messages,
            [format!("the device has an object {index:04X}h, the file has not")]
        );
        judged += 1;
    }
    assert!(judged > 100);
}

#[test]
fn a_dump_of_another_node_is_held_against_the_formulas_of_that_node() {
    let [circle, _] = encoders();
    let mut dump = circle.dump.clone();
    dump.node_id = NodeId::new(6).expect("a node-ID");
    let found = circle.validate(&dump);
    let formulas = circle
        .answered()
        .filter(|(entry, _)| matches!(entry.default, Some(Value::NodeIdPlus(_))));
    assert_eq!(found.len(), formulas.count(), "{found:#?}");
    assert!(
        found
            .iter()
            .all(|diagnostic| matches!(diagnostic.code.as_str(), "DMP016" | "DMP017")),
        "{found:#?}"
    );
}

#[test]
fn process_values_and_settings_may_differ_without_failing_the_device() {
    let [circle, _] = encoders();
    for (address, bytes) in [
        (Address::new(0x6004, 0), vec![1, 2, 3, 0]),
        (Address::new(0x1017, 0), vec![0xE8, 3]),
    ] {
        let found = circle.with(address, Answer::Value(bytes));
        assert!(
            found.iter().all(|diagnostic| diagnostic.level == Level::Note),
            "{found:#?}"
        );
    }
}
