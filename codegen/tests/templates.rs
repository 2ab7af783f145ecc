//! Handler stubs, documentation, and templates of a user's own.
//!
//! After a wanted change: `INSTA_UPDATE=always cargo test -p lexican-codegen --features templates`, and read the difference.

use std::path::Path;

use lexican_codegen::{Builder, Error, Generated, Template};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn every_kind() -> Generated {
    let builder = Builder::new(root().join("tests/fixtures/codegen/every_kind.eds"))
        .handle([0x2600, 0x2601, 0x2602, 0x2603, 0x2604, 0x2605, 0x2606, 0x6004, 0x6030])
        .handle_writes([(0x2300, 1), (0x2300, 3), (0x1010, 1), (0x6003, 0)])
        .stream([0x2607])
        .capacity((0x2013, 0), 20)
        .capacity((0x2603, 0), 100);
    builder.generate().expect("the fixture is compiled")
}

fn wdga() -> Generated {
    let builder = Builder::new(root().join("eds/devices/wdga.eds"));
    builder.generate().expect("the device is compiled")
}

#[test]
fn stubs_are_a_skeleton_that_compiles() {
    // `lexican-tests` compiles the snapshot.
    insta::with_settings!({
        snapshot_path => root().join("tests/generated"),
        prepend_module_to_snapshot => false,
        omit_expression => true
    }, {
        let stubs = every_kind().stubs().unwrap();
        insta::assert_binary_snapshot!("every_kind_stubs.rs", stubs.into_bytes());
    });
}

#[test]
fn without_handlers_there_is_nothing_to_write() {
    insta::assert_snapshot!(wdga().stubs().unwrap(), @"
    // The application behind `wdga`. `lexican generate --stubs` wrote it as a start; it is yours now.
    //
    // No object was named for it to handle: `wdga::Device::new(())` is the whole device.
    ");
}

#[test]
fn the_documentation_has_every_object_and_pdo() {
    insta::assert_snapshot!("wdga.md", wdga().docs().unwrap());
    let documentation = every_kind().docs().unwrap();
    let rows = documentation.lines().filter(|line| line.starts_with('|')).count();
    assert!(rows > every_kind().dictionary().entries().count(), "{rows}");
    assert!(
        documentation.contains(r"a\`b\`\`c \[x\] \<b\>"),
        "names mean nothing to Markdown"
    );
}

#[test]
fn a_template_of_the_user_s_own_sees_the_dictionary() {
    let template = Template {
        name: "list.csv.j2",
        text: "{% for object in objects %}{% for entry in object.entries if entry.writable and entry.unit %}\
               {{ entry.index | hex(4) }},{{ entry.sub }},{{ entry.rust_name }},{{ entry.default }} {{ entry.unit }}\n\
               {% endfor %}{% endfor %}",
    };
    insta::assert_snapshot!(wdga().render(&template).unwrap(), @"
    100C,0,guard_time,0 ms
    1015,0,inhibit_time_emergency_message,0 multiples of 100 µs
    1017,0,producer_heartbeat_time,0 ms
    1800,5,tpdo_1_communication_event_timer,0 ms
    1801,5,tpdo_2_communication_event_timer,0 ms
    1802,5,tpdo_3_communication_event_timer,0 ms
    1803,5,tpdo_4_communication_event_timer,0 ms
    ");
}

#[test]
fn a_template_that_asks_for_what_is_not_there_is_an_error_with_its_line() {
    let template = Template {
        name: "mine.j2",
        text: "\n{{ device.serial }}",
    };
    let error = wdga().render(&template).unwrap_err();
    assert!(matches!(error, Error::Template(_)));
    assert_eq!(
        error.to_string(),
        "mine.j2:2: undefined value: `device.serial` is undefined"
    );
}
