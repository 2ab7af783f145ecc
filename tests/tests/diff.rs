//! What `lexican diff` calls breaking, an addition, cosmetic.

use lexican_eds::{
    Reading,
    diff::{self, Difference, Effect},
};
use lexican_tests::corpus::corpus;

const FILE: &str = "\
[FileInfo]
FileRevision=1
[DeviceInfo]
VendorNumber=0x1
RevisionNumber=0x00010001
BaudRate_125=1
BaudRate_500=1
Granularity=8
NrOfTXPDO=1
[DummyUsage]
Dummy0005=1
[MandatoryObjects]
SupportedObjects=1
1=0x1000
[1000]
ParameterName=Device type
DataType=0x0007
AccessType=ro
DefaultValue=0x196
[2000]
ParameterName=Speed
DataType=0x0006
AccessType=rw
DefaultValue=10
LowLimit=5
HighLimit=100
PDOMapping=1
[2001]
ParameterName=Limits
ObjectType=0x9
SubNumber=2
[2001sub0]
ParameterName=Highest
DataType=0x0005
AccessType=ro
DefaultValue=1
[2001sub1]
ParameterName=First
DataType=0x0007
AccessType=rw
";

fn read(text: &str) -> Reading {
    lexican_eds::read("pump.eds", text.into())
}

fn compare(old: &str, new: &str) -> Vec<Difference> {
    diff::compare(&read(old).dictionary, &read(new).dictionary)
}

/// What is said when `old` in the file becomes `new`.
fn change(old: &str, new: &str) -> Vec<(Effect, String)> {
    assert!(FILE.contains(old), "{old}");
    let found = compare(FILE, &FILE.replacen(old, new, 1));
    found
        .iter()
        .map(|difference| (difference.effect, difference.to_string()))
        .collect()
}

#[track_caller]
fn assert_change(old: &str, new: &str, effect: Effect, message: &str) {
    assert_eq!(change(old, new), [(effect, message.to_owned())]);
}

#[test]
fn what_a_master_can_no_longer_do_is_breaking_and_what_it_can_do_now_an_addition() {
    let speed = "DataType=0x0006\nAccessType=rw";
    for (old, new, gone, come) in [
        (
            "VendorNumber=0x1",
            "VendorNumber=0x2",
            "[DeviceInfo]: VendorNumber was `0x1`, is `0x2`",
            None,
        ),
        (
            "BaudRate_500=1",
            "BaudRate_500=0",
            "[DeviceInfo]: BaudRate was `125, 500`, is `125`",
            Some("[DeviceInfo]: BaudRate was `125`, is `125, 500`"),
        ),
        (
            "Granularity=8",
            "Granularity=16",
            "[DeviceInfo]: Granularity was `8`, is `16`",
            Some("[DeviceInfo]: Granularity was `16`, is `8`"),
        ),
        (
            "NrOfTXPDO=1",
            "NrOfTXPDO=0",
            "[DeviceInfo]: NrOfTXPDO was `1`, is `0`",
            Some("[DeviceInfo]: NrOfTXPDO was `0`, is `1`"),
        ),
        (
            "Dummy0005=1",
            "Dummy0005=0",
            "[DummyUsage]: Dummy was `UNSIGNED8`, is not given",
            Some("[DummyUsage]: Dummy was not given, is `UNSIGNED8`"),
        ),
        (
            "DefaultValue=10",
            "DefaultValue=0x0B",
            "2000 `Speed`: DefaultValue was `10`, is `11`",
            None,
        ),
        (
            "LowLimit=5",
            "LowLimit=6",
            "2000 `Speed`: LowLimit was `5`, is `6`",
            Some("2000 `Speed`: LowLimit was `6`, is `5`"),
        ),
        (
            "HighLimit=100\n",
            "HighLimit=90\n",
            "2000 `Speed`: HighLimit was `100`, is `90`",
            Some("2000 `Speed`: HighLimit was `90`, is `100`"),
        ),
        (
            "PDOMapping=1",
            "PDOMapping=0",
            "2000 `Speed`: PDOMapping was `RPDO and TPDO`, is `none`",
            Some("2000 `Speed`: PDOMapping was `none`, is `RPDO and TPDO`"),
        ),
        (
            speed,
            "DataType=0x0006\nAccessType=rwr",
            "2000 `Speed`: PDOMapping was `RPDO and TPDO`, is `TPDO`",
            Some("2000 `Speed`: PDOMapping was `TPDO`, is `RPDO and TPDO`"),
        ),
        (
            speed,
            "DataType=0x0007\nAccessType=rw",
            "2000 `Speed`: DataType was `UNSIGNED16`, is `UNSIGNED32`",
            None,
        ),
    ] {
        let said = change(old, new);
        assert!(said.contains(&(Effect::Breaking, gone.to_owned())), "{said:#?}");
        let (changed, file) = (FILE.replacen(old, new, 1), FILE);
        let back = compare(&changed, file);
        let effect = if come.is_some() {
            Effect::Addition
        } else {
            Effect::Breaking
        };
        assert!(back.iter().any(|difference| difference.effect == effect), "{back:#?}");
        if let Some(come) = come {
            assert!(
                back.iter().all(|difference| difference.effect != Effect::Breaking),
                "{back:#?}"
            );
            assert!(
                back.iter().any(|difference| difference.to_string() == come),
                "{back:#?}"
            );
        }
    }
}

#[test]
fn objects_and_sub_objects_come_and_go() {
    let second = "[2001sub2]\nParameterName=Second\nDataType=0x0007\nAccessType=rw\n";
    let more = format!("{FILE}{second}[2002]\nParameterName=New\nDataType=0x0005\nAccessType=ro\n");
    let said = |found: Vec<Difference>| -> Vec<(Effect, String)> {
        let said = found
            .iter()
            .map(|difference| (difference.effect, difference.to_string()));
        said.collect()
    };
    assert_eq!(
        said(compare(FILE, &more)),
        [
            (Effect::Addition, "2001sub2 `Second` is new".to_owned()),
            (Effect::Addition, "2002 `New` is new".to_owned())
        ]
    );
    assert_eq!(
        said(compare(&more, FILE)),
        [
            (Effect::Breaking, "2001sub2 `Second` is gone".to_owned()),
            (Effect::Breaking, "2002 `New` is gone".to_owned())
        ]
    );
}

#[test]
fn names_and_the_minor_revision_are_cosmetic_and_the_major_revision_is_not() {
    assert_change(
        "=Speed",
        "=Velocity",
        Effect::Cosmetic,
        "2000 `Velocity`: ParameterName was `Speed`, is `Velocity`",
    );
    assert_change(
        "FileRevision=1",
        "FileRevision=2",
        Effect::Cosmetic,
        "[FileInfo]: FileRevision was `1`, is `2`",
    );
    let (old, minor, major) = ("Number=0x00010001", "Number=0x00010002", "Number=0x00020001");
    assert_change(
        old,
        minor,
        Effect::Cosmetic,
        "[DeviceInfo]: RevisionNumber was `0x10001`, is `0x10002`",
    );
    assert_change(
        old,
        major,
        Effect::Breaking,
        "[DeviceInfo]: RevisionNumber was `0x10001`, is `0x20001`",
    );
}

#[test]
fn the_way_a_file_is_written_makes_no_difference() {
    let other = FILE
        .replace("DefaultValue=10\n", "; in rpm\r\ndefaultvalue = 0x000A\n")
        .replace(
            "ParameterName=Device type\nDataType=0x0007\n",
            "DataType=0x07\nParameterName=Device type\n",
        );
    assert_ne!(other, FILE);
    assert_eq!(compare(FILE, &other), []);
}

#[test]
fn breaking_differences_come_first() {
    let other = FILE
        .replace("=Speed", "=Velocity")
        .replace("[2001", "[2002")
        .replace("BaudRate_125=1", "BaudRate_125=0");
    let effects: Vec<Effect> = compare(FILE, &other)
        .iter()
        .map(|difference| difference.effect)
        .collect();
    assert_eq!(
        effects,
        [Effect::Breaking, Effect::Breaking, Effect::Addition, Effect::Cosmetic]
    );
}

#[test]
fn no_real_file_differs_from_itself_and_what_goes_one_way_comes_the_other_way() {
    let Some(files) = corpus("files") else { return };
    let readings: Vec<Reading> = files
        .into_iter()
        .map(|file| lexican_eds::read(file.name, file.bytes))
        .collect();
    for reading in &readings {
        let name = reading.document.source().name();
        assert_eq!(diff::compare(&reading.dictionary, &reading.dictionary), [], "{name}");
    }
    for pair in readings.windows(2) {
        let (one, other) = (&pair[0].dictionary, &pair[1].dictionary);
        let (there, back) = (diff::compare(one, other), diff::compare(other, one));
        let facts = |found: &[Difference], turned: bool| {
            let facts = found.iter().map(|difference| {
                let (before, after) = (difference.before.clone(), difference.after.clone());
                let (before, after) = if turned { (after, before) } else { (before, after) };
                (difference.subject.clone(), difference.fact, before, after)
            });
            let mut facts: Vec<_> = facts.collect();
            facts.sort();
            facts
        };
        assert_eq!(
            facts(&there, false),
            facts(&back, true),
            "{}",
            pair[0].document.source().name()
        );
    }
}
