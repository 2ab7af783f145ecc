//! The forms of a rule that its fixture does not show.

use std::{fs, path::Path};

use lexican_eds::rules::{self, Levels};

/// What is found in a good file whose object 2000h is described by `lines`, each as code and message.
fn found(lines: &str) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules/OBJ001.fixed.eds");
    let file = fs::read_to_string(path).expect("the fixture is there");
    let (before, _) = file.split_once("[2000]\n").expect("the fixture has the object");
    let text = format!("{before}[2000]\nParameterName=Gain\n{}\n", lines.replace(' ', "\n"));
    let reading = lexican_eds::read("x.eds", text.into());
    let found = rules::check(&reading, &Levels::default());
    found
        .iter()
        .map(|diagnostic| format!("{}: {}", diagnostic.code, diagnostic.message))
        .collect()
}

#[test]
fn a_data_type_may_be_unknown_in_many_ways() {
    let of_type = |data_type: &str| found(&format!("ObjectType=0x7 AccessType=rw DataType={data_type}"));
    assert_eq!(of_type("0x0006"), [""; 0]);
    assert_eq!(of_type(""), ["OBJ005: keyword DataType has no value"]);
    assert_eq!(of_type("U16"), ["OBJ005: DataType `U16` does not exist"]);
    assert_eq!(of_type("08"), ["OBJ005: DataType `08` does not exist"]);
    assert_eq!(of_type("0x17"), ["OBJ005: DataType `0x17` is reserved by CiA 301"]);
    assert_eq!(
        of_type("0x22"),
        ["OBJ005: DataType `0x22` is a structure, not the type of a value"]
    );
    assert_eq!(of_type("0x60"), ["OBJ006: DataType `0x60` is no data type of CiA 301"]);
}

#[test]
fn an_access_type_may_be_missing_or_empty() {
    let with = |access: &str| found(&format!("ObjectType=0x7 DataType=0x0006{access}"));
    assert_eq!(with(""), ["OBJ007: keyword AccessType is missing"]);
    assert_eq!(with(" AccessType="), ["OBJ007: keyword AccessType has no value"]);
}

#[test]
fn an_object_type_may_not_fit_the_object_or_be_missing() {
    let sub = "[2000sub0] ParameterName=Count DataType=0x0005 AccessType=ro DefaultValue=1 \
               [2000sub1] ParameterName=One DataType=0x0005 AccessType=ro";
    assert_eq!(found(&format!("ObjectType=0x9 SubNumber=2 {sub}")), [""; 0]);
    assert_eq!(
        found(&format!("SubNumber=2 {sub}")),
        ["OBJ008: keyword ObjectType is missing: the object looks like a record"]
    );
    assert_eq!(
        found(&format!("ObjectType=0x7 SubNumber=2 {sub}")),
        ["OBJ008: ObjectType `0x7` does not fit: the object looks like a record"]
    );
    assert_eq!(
        found(&format!("ObjectType=0x9 {sub}")),
        ["EDS009: SubNumber is missing; 2 sub-objects have a section"]
    );
}

#[test]
fn a_value_is_refused_with_the_reason_that_fits() {
    let value = |data_type: &str, value: &str| {
        found(&format!(
            "ObjectType=0x7 AccessType=rw DataType={data_type} DefaultValue={value}"
        ))
    };
    assert_eq!(
        value("0x0005", "256"),
        ["OBJ003: DefaultValue `256` is out of the range of UNSIGNED8"]
    );
    assert_eq!(
        value("0x0007", "$ID+1"),
        ["OBJ003: DefaultValue `$ID+1` names a variable other than $NODEID"]
    );
    assert_eq!(
        value("0x0008", "$NODEID+1"),
        ["OBJ003: DefaultValue `$NODEID+1` is a formula, but the value is REAL32"]
    );
    assert_eq!(
        value("0x0008", "0x19999a"),
        ["OBJ003: DefaultValue `0x19999a` is hex, but has not all digits of REAL32: is it a value, or are these bits?"]
    );
    assert_eq!(
        value("0x000A", "xyz"),
        ["OBJ003: DefaultValue `xyz` cannot be read as OCTET_STRING"]
    );
    assert_eq!(
        value("0x0006", "08"),
        ["OBJ021: DefaultValue `08` starts with 0, but is no octal number"]
    );
}

#[test]
fn limits_hold_a_value_from_both_sides() {
    let with = |value: &str, low: &str, high: &str| {
        found(&format!(
            "ObjectType=0x7 AccessType=rw DataType=0x0007 DefaultValue={value} LowLimit={low} HighLimit={high}"
        ))
    };
    assert_eq!(with("5", "1", "5"), [""; 0]);
    assert_eq!(
        with("6", "1", "5"),
        ["OBJ001: DefaultValue `6` is above its HighLimit `5`"]
    );
    // Inverted limits are one finding, whatever the value is.
    assert_eq!(
        with("6", "5", "1"),
        ["OBJ002: LowLimit `5` is above HighLimit `1` of this UNSIGNED32"]
    );
}

#[test]
fn a_formula_is_beyond_limits_when_it_is_for_every_node() {
    let with = |low: &str, high: &str| {
        found(&format!(
            "ObjectType=0x7 AccessType=rw DataType=0x0007 DefaultValue=$NODEID+0x180 LowLimit={low} HighLimit={high}"
        ))
    };
    assert_eq!(with("0x181", "0x1FF"), [""; 0]);
    assert_eq!(
        with("0x200", "0x2FF"),
        ["OBJ001: DefaultValue `$NODEID+0x180` is below its LowLimit `0x200`"]
    );
    assert_eq!(
        with("0x100", "0x180"),
        ["OBJ001: DefaultValue `$NODEID+0x180` is above its HighLimit `0x180`"]
    );
}

#[test]
fn a_habit_of_a_whole_file_is_one_finding() {
    let lines = "ObjectType=0x7 DataType=0x0005 AccessType=RW DefaultValue=0x0001 LowLimit=0x0000 HighLimit=0x00FF";
    assert_eq!(
        found(lines),
        [
            "OBJ013: AccessType `RW` is not in small letters",
            "OBJ012: DefaultValue `0x0001` has more digits than its type (and 2 more)"
        ]
    );
}
