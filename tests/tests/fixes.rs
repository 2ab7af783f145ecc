//! What `lexican check --fix` promises, held against the rules' fixtures and the real files.

use std::{collections::BTreeMap, sync::LazyLock};

use lexican_eds::{
    Reading,
    diagnostic::{Diagnostic, Level},
    fix::{self, Mended},
    ir::{Dictionary, EntrySpans, FileInfo},
    rules::{self, Fixable, LevelChange, Levels, Rule},
    span::Span,
};
use lexican_tests::{corpus::corpus, fixture};

fn check(reading: &Reading) -> Vec<Diagnostic> {
    rules::check(reading, &Levels::default())
}

/// The failing fixture of each rule about files.
fn fixtures() -> impl Iterator<Item = (&'static Rule, Reading)> {
    let rules = rules::all().iter().filter(|rule| rule.code().family() != "DMP");
    rules.map(|rule| (rule, fixture::read(rule.code().as_str())))
}

/// A file, what is found in it, and what becomes of it.
struct Case {
    reading: Reading,
    found: Vec<Diagnostic>,
    mended: Mended,
}

impl Case {
    fn new(reading: Reading) -> Self {
        Self {
            found: check(&reading),
            mended: fix::mend(reading.clone(), check),
            reading,
        }
    }

    fn name(&self) -> &str {
        self.reading.document.source().name()
    }

    /// Whether something that the rule found was fixed.
    fn fixes(&self, code: &str) -> bool {
        self.mended.fixed.keys().any(|fixed| fixed.as_str() == code)
    }
}

/// The fixtures, and the real files where they are.
fn cases() -> &'static [Case] {
    static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| {
        let real = corpus("files").into_iter().flatten();
        let real = real.map(|file| lexican_eds::read(file.name, file.bytes));
        let readings = fixtures().map(|(_, reading)| reading).chain(real);
        readings.map(Case::new).collect()
    });
    &CASES
}

#[test]
fn what_is_called_fixable_is_fixed_and_nothing_else_is() {
    for (rule, reading) in fixtures() {
        let code = rule.code();
        let found = check(&reading);
        let offered = !found.is_empty() && found.iter().all(|diagnostic| diagnostic.fix.is_some());
        // Of a leading zero only `08` and `09` are certain, and the fixture of OBJ021 shows another.
        let is_off = rule.level() == Level::Allow;
        let expected = rule.fixable() != Fixable::Never && code.as_str() != "OBJ021" && !is_off;
        assert_eq!(offered, expected, "{code}");
        let mended = fix::mend(reading, check);
        if offered {
            assert_eq!(mended.remaining, [], "{code}");
            assert_eq!(mended.fixed.into_iter().collect::<Vec<_>>(), [(code, 1)]);
        } else {
            assert!(mended.fixed.is_empty(), "{code}");
        }
    }
}

#[test]
fn the_file_name_is_fixed_where_it_is_asked_for() {
    let levels = Levels::default().with(LevelChange::new("EDS034", Level::Note).unwrap());
    let text = "[FileInfo]\nFileName = old.eds\n";
    let mended = fix::mend(lexican_eds::read("a/pump.eds", text.into()), |reading| {
        rules::check(reading, &levels)
    });
    assert_eq!(
        mended.reading.document.source().text(),
        "[FileInfo]\nFileName = pump.eds\n"
    );
}

/// `text` with its safe cures made.
fn fixed(text: &str) -> String {
    let mended = fix::mend(lexican_eds::read("x.eds", text.into()), check);
    mended.reading.document.source().text().to_owned()
}

#[test]
fn a_ctrl_z_goes_where_the_file_ends_and_stays_where_it_goes_on() {
    for end in ["\x1A", "\r\n\x1A", "\r\n\x1A\x1A\0\0", "\r\n\x1A\r\n"] {
        let ended = fixed(&format!("[FileInfo]\r\nFileRevision=1{end}"));
        assert_eq!(
            ended.trim_end_matches("\r\n"),
            "[FileInfo]\r\nFileRevision=1",
            "{end:?}"
        );
    }
    let goes_on = "[FileInfo]\r\nFileVersion=1\r\n\x1A\r\nFileRevision=1\r\n";
    assert_eq!(fixed(goes_on), goes_on);
}

#[test]
fn a_sub_index_zero_gets_the_value_that_is_missing_where_nothing_contradicts_it() {
    let with = |lines: &str| {
        let sub = "[2100sub1]\nParameterName=One\nDataType=0x0005\nAccessType=ro\n";
        let object = "[2100]\nParameterName=Points\nObjectType=0x8\nSubNumber=2\n";
        let zero = format!("[2100sub0]\nParameterName=Count\nAccessType=ro\n{lines}");
        let text = fixed(&format!("{object}{zero}{sub}"));
        let (_, zero) = text.split_once("AccessType=ro\n").unwrap();
        zero.split('[').next().unwrap().to_owned()
    };
    assert_eq!(with(""), "DefaultValue=1\n");
    assert_eq!(with("DefaultValue =\n"), "DefaultValue =1\n");
    for doubtful in [
        "DataType=0x0006\n",
        "LowLimit=2\n",
        "DefaultValue=one\n",
        "ParameterValue=\n",
    ] {
        assert_eq!(with(doubtful), doubtful);
    }
}

#[test]
fn a_rule_that_always_or_never_fixes_does_so_in_real_files() {
    for case in cases() {
        for diagnostic in &case.found {
            let rule = rules::find(diagnostic.code.as_str()).unwrap();
            let (name, code, offered) = (case.name(), rule.code(), diagnostic.fix.is_some());
            match rule.fixable() {
                Fixable::Always => assert!(offered, "{name}: {code} {}", diagnostic.message),
                Fixable::Never => assert!(!offered, "{name}: {code} {}", diagnostic.message),
                Fixable::Sometimes => {}
            }
        }
    }
}

#[test]
fn a_fixed_file_has_nothing_left_to_fix_and_fixing_it_again_changes_nothing() {
    for case in cases() {
        let (name, remaining) = (case.name(), &case.mended.remaining);
        let left: Vec<_> = remaining.iter().filter(|diagnostic| diagnostic.fix.is_some()).collect();
        assert!(left.is_empty(), "{name}: {left:#?}");
        let bytes = case.mended.reading.document.to_bytes();
        let again = check(&lexican_eds::read(name, bytes));
        assert_eq!(&again, remaining, "{name}");
    }
}

#[test]
fn a_fixed_file_has_no_new_findings_but_notes() {
    let grave = |found: &[Diagnostic]| {
        let mut counts = BTreeMap::<&str, usize>::new();
        for diagnostic in found.iter().filter(|diagnostic| diagnostic.level > Level::Note) {
            *counts.entry(diagnostic.code.as_str()).or_default() += 1;
        }
        counts
    };
    for case in cases() {
        let before = grave(&case.found);
        for (code, number) in grave(&case.mended.remaining) {
            let known = before.get(code).copied().unwrap_or_default();
            let name = case.name();
            assert!(number <= known, "{name}: {number} of {code}, {known} before");
        }
    }
}

/// What the fixes of a rule may change of the device, made the same in `dictionary`.
fn without_what_changes(code: &str, dictionary: &mut Dictionary) {
    match code {
        "EDS006" | "EDS008" | "EDS015" => dictionary.objects.iter_mut().for_each(|object| object.list = None),
        "EDS013" | "EDS017" | "EDS018" => dictionary.file = FileInfo::default(),
        "OBJ027" => entries(dictionary, |entry| {
            if entry.address.sub == 0 {
                entry.default = None;
            }
        }),
        "OBJ021" => entries(dictionary, |entry| {
            (entry.default, entry.low, entry.high) = (None, None, None);
        }),
        "DEV001" => (dictionary.device.nr_of_rx_pdo, dictionary.device.nr_of_tx_pdo) = (None, None),
        "PDO015" => dictionary.device.granularity = 0,
        _ => {}
    }
}

fn entries(dictionary: &mut Dictionary, change: impl Fn(&mut lexican_eds::ir::Entry)) {
    dictionary
        .objects
        .iter_mut()
        .flat_map(|object| &mut object.entries)
        .for_each(change);
}

fn without_places(mut dictionary: Dictionary) -> Dictionary {
    dictionary
        .objects
        .iter_mut()
        .for_each(|object| object.span = Span::default());
    entries(&mut dictionary, |entry| entry.spans = EntrySpans::default());
    dictionary
}

/// The rules whose fixes change what they are about.
const CHANGING: [&str; 10] = [
    "EDS006", "EDS008", "EDS013", "EDS015", "EDS017", "EDS018", "OBJ021", "OBJ027", "DEV001", "PDO015",
];

#[test]
fn the_device_stays_the_same_but_for_what_the_rules_are_about() {
    for case in cases() {
        let mut before = without_places(case.reading.dictionary.clone());
        let mut after = without_places(case.mended.reading.dictionary.clone());
        for code in CHANGING.into_iter().filter(|code| case.fixes(code)) {
            without_what_changes(code, &mut before);
            without_what_changes(code, &mut after);
        }
        assert_same(&before, &after, case.name());
    }
}

#[test]
fn the_device_stays_the_same_to_the_last_detail_without_the_rules_that_change_one() {
    let allowed = CHANGING.map(|code| LevelChange::new(code, Level::Allow));
    let levels = allowed.into_iter().flatten().fold(Levels::default(), Levels::with);
    for case in cases()
        .iter()
        .filter(|case| CHANGING.iter().any(|code| case.fixes(code)))
    {
        let mended = fix::mend(case.reading.clone(), |reading| rules::check(reading, &levels));
        let before = without_places(case.reading.dictionary.clone());
        assert_same(&before, &without_places(mended.reading.dictionary), case.name());
    }
}

fn assert_same(before: &Dictionary, after: &Dictionary, what: &str) {
    for (one, other) in before.objects.iter().zip(&after.objects) {
        assert!(one == other, "{what}: {:04X}h, {:04X}h", one.index, other.index);
    }
    assert!(before == after, "{what}: {:#?} {:#?}", before.device, after.device);
}
