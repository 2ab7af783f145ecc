//! What the builder says when it cannot do what it is told, in the words that a failing build script shows.

use std::{fs, path::Path};

use lexican_codegen::{Builder, Error, Level, Levels};

fn wdga() -> Builder {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/devices/wdga.eds");
    Builder::from_bytes("wdga.eds", fs::read(path).expect("a file of the project"))
}

/// As Cargo shows it: `Error: {error:?}`.
fn failure(builder: Builder) -> String {
    format!("{:?}", builder.generate().expect_err("this cannot be generated"))
}

#[test]
fn an_object_that_is_not_there_is_named_with_its_neighbours() {
    insta::assert_snapshot!(failure(wdga().handle([0x6005])), @"6005h is not in wdga.eds; near it are 6002h `Total measuring range`, 6003h `Preset value`, 6004h `Position value`");
    insta::assert_snapshot!(failure(wdga().handle([(0x1010, 9)])), @"1010sub9 is not in wdga.eds; near it are 1010sub2 `Save communication parameters`, 1010sub3 `Save application parameters`, 1010sub4 `Save manufacturer parameters`");
    insta::assert_snapshot!(failure(wdga().capacity(0x7000, 5)), @"7000h is not in wdga.eds; near it are 650Ah `Module identification`, 650Bh `Serial number`, 6510h `Number of high precision revolutions`");
}

#[test]
fn what_a_client_cannot_do_needs_no_handler() {
    insta::assert_snapshot!(failure(wdga().handle_writes([0x6004])), @"6004h of wdga.eds cannot be written, so there is nothing to handle");
    assert!(wdga().handle_reads([0x6004]).generate().is_ok());
}

#[test]
fn only_strings_have_a_capacity() {
    insta::assert_snapshot!(failure(wdga().capacity(0x6004, 5)), @"6004h of wdga.eds is no string, so it has no capacity");
}

#[test]
fn only_strings_go_in_parts() {
    insta::assert_snapshot!(failure(wdga().stream([0x6004])), @"6004h of wdga.eds is no string, so it does not go in parts");
}

#[test]
fn a_missing_file_is_named() {
    insta::assert_snapshot!(failure(Builder::new("nowhere/wdga.eds")), @"cannot read nowhere/wdga.eds: No such file or directory (os error 2)");
}

#[test]
fn what_a_rule_denies_is_shown_as_the_checker_shows_it() {
    insta::assert_snapshot!(failure(Builder::from_bytes("pump.eds", "[FileInfo]\nFileName=a\nFileName=b\n")), @"
    pump.eds has an error, so no code is generated

    pump.eds:3:1: error[INI003]: keyword `FileName` appears twice in this section
      |
    1 | [FileInfo]
    2 | FileName=a
      | -------- the first; it is the one that counts
    3 | FileName=b
      | ^^^^^^^^ the second
      |
      = help: remove one of them
    ");
}

#[test]
fn the_level_of_a_rule_can_be_changed() {
    let twice = || Builder::from_bytes("pump.eds", "[FileInfo]\nFileName=a\nFileName=b\n");
    let generated = twice().level("INI003", Level::Warn).generate().unwrap();
    assert!(
        generated.warnings().iter().any(|line| line.contains("INI003")),
        "{:?}",
        generated.warnings()
    );
    assert!(twice().level("INI", Level::Allow).generate().is_ok());
    insta::assert_snapshot!(failure(twice().level("INI999", Level::Warn)), @"unknown rule `INI999`; did you mean INI009?");
}

#[test]
fn a_comment_in_the_file_allows_a_rule_in_a_build_as_well() {
    let text = "[FileInfo]\nFileName=a\n; lexican: allow(INI003) as our tool writes it\nFileName=b\n";
    assert!(Builder::from_bytes("pump.eds", text).generate().is_ok());
}

#[test]
fn the_levels_of_a_rule_come_from_the_caller_and_are_changed_by_the_builder() {
    let levels = Levels::default().with("INI003=allow".parse().unwrap());
    let twice = || Builder::from_bytes("pump.eds", "[FileInfo]\nFileName=a\nFileName=b\n").levels(levels.clone());
    assert!(twice().generate().is_ok());
    assert!(twice().level("INI", Level::Deny).generate().is_err());
}

#[test]
fn a_dictionary_beyond_the_reach_of_its_table_is_refused() {
    let error = wdga().capacity(0x1009, u16::MAX).generate().unwrap_err();
    assert!(matches!(error, Error::TooLarge { values: 65_537.., .. }), "{error}");
    insta::assert_snapshot!(error, @"wdga.eds is too large: 66104 bytes of values and 86 of constants, while a table reaches 65536 of each; give strings less room with `capacity`");
}

#[test]
fn the_output_is_the_same_every_time() {
    let [first, second] = [(); 2].map(|()| wdga().handle([0x6003]).generate().unwrap());
    assert_eq!(first.source(), second.source());
}

#[test]
fn a_name_does_not_change_when_an_object_is_added() {
    let object = |index: u16, name: &str| {
        format!("[{index:X}]\nParameterName={name}\nObjectType=7\nDataType=7\nAccessType=rw\nPDOMapping=0\n")
    };
    let names = |objects: &[(u16, &str)]| -> Vec<String> {
        let list: Vec<String> = (1..)
            .zip(objects)
            .map(|(n, (index, _))| format!("{n}=0x{index:X}"))
            .collect();
        let text: Vec<String> = objects.iter().map(|&(index, name)| object(index, name)).collect();
        let (count, list, text) = (
            objects.len(),
            list.join(
                "
",
            ),
            text.concat(),
        );
        let text = format!(
            "[ManufacturerObjects]
SupportedObjects={count}
{list}
{text}"
        );
        let builder = Builder::from_bytes("a.eds", text);
        let builder = ["INI", "EDS", "OBJ"]
            .iter()
            .fold(builder, |builder, family| builder.level(*family, Level::Allow));
        let generated = builder.generate().expect("it is compiled");
        let fields = generated
            .source()
            .lines()
            .filter_map(|line| line.trim().strip_prefix("pub "));
        fields
            .filter_map(|line| line.strip_suffix(": u32,"))
            .map(str::to_owned)
            .collect()
    };
    assert_eq!(names(&[(0x2001, "Speed"), (0x2003, "Angle")]), ["speed", "angle"]);
    assert_eq!(
        names(&[
            (0x2000, "Type"),
            (0x2001, "Speed"),
            (0x2002, "Angle limit"),
            (0x2003, "Angle")
        ]),
        ["type_", "speed", "angle_limit", "angle"]
    );
    // The first of two of a name does not keep it for itself: the compiler is to say that there are two now.
    assert_eq!(
        names(&[(0x2001, "Speed"), (0x2002, "Speed"), (0x2003, "Angle")]),
        ["speed_2001", "speed_2002", "angle"]
    );
}
