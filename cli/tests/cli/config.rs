//! `lexican.toml`

use crate::lexican::Lexican;

/// One finding at deny, of OBJ002.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");
/// One finding at warn, of EDS005.
const WARNED: &[u8] = include_bytes!("../../../tests/fixtures/rules/EDS005.eds");

/// The last line of what `check` says with these files there.
fn summary(files: &[(&str, &str)], arguments: &[&str]) -> String {
    let devices: [(&str, &[u8]); 3] = [
        ("devices/denied.eds", DENIED),
        ("devices/old/denied.eds", DENIED),
        ("devices/old/warned.eds", WARNED),
    ];
    let others = files.iter().map(|(name, text)| (*name, text.as_bytes()));
    let files: Vec<(&str, &[u8])> = devices.into_iter().chain(others).collect();
    let ran = Lexican::with(&files).run(&[&["check", "devices"], arguments].concat());
    assert_eq!(ran.stderr, "");
    let summary = ran
        .stdout
        .lines()
        .find_map(|line| line.strip_prefix("3 files checked: "));
    summary.unwrap().to_owned()
}

#[test]
fn levels_of_the_nearest_configuration_hold() {
    assert_eq!(summary(&[], &[]), "2 errors, 1 warning");
    let above = ("lexican.toml", "[levels]\nOBJ002 = \"note\"\n");
    assert_eq!(summary(&[above], &[]), "1 warning, 2 notes");
    let below = ("devices/old/lexican.toml", "[levels]\nEDS = \"allow\"\n");
    assert_eq!(summary(&[below], &[]), "2 errors");
    assert_eq!(
        summary(&[above, below], &[]),
        "1 error, 1 note",
        "the nearest alone counts"
    );
}

#[test]
fn an_override_holds_for_the_files_that_its_patterns_match() {
    let with = |files: &str| {
        let text = format!("[[override]]\nfiles = {files}\nlevels.OBJ = \"allow\"\n");
        summary(&[("lexican.toml", &text)], &[])
    };
    assert_eq!(with(r#"["devices/old/**"]"#), "1 error, 1 warning");
    assert_eq!(with(r#"["devices/old/"]"#), "1 error, 1 warning");
    assert_eq!(with(r#"["denied.eds"]"#), "1 warning", "a name, in any folder");
    assert_eq!(
        with(r#"["devices/*.eds"]"#),
        "1 error, 1 warning",
        "`*` stays in its folder"
    );
    assert_eq!(with(r#"["**/*.eds"]"#), "1 warning");
    assert_eq!(with(r#"["*.dcf", "warned.eds"]"#), "2 errors, 1 warning");
}

#[test]
fn a_later_override_beats_an_earlier_one_and_both_beat_the_rest() {
    let text = "\
        [levels]\nOBJ002 = \"allow\"\n\
        [[override]]\nfiles = [\"devices/**\"]\n[override.levels]\nOBJ = \"note\"\n\
        [[override]]\nfiles = [\"devices/old/**\"]\n[override.levels]\nOBJ = \"warn\"\n";
    assert_eq!(summary(&[("lexican.toml", text)], &[]), "2 warnings, 1 note");
}

#[test]
fn an_argument_beats_the_configuration() {
    let config = ("lexican.toml", "[levels]\nOBJ002 = \"allow\"\n");
    assert_eq!(summary(&[config], &["--level", "OBJ=warn"]), "3 warnings");
    assert_eq!(summary(&[config], &["--no-config"]), "2 errors, 1 warning");
    let other = ("other.toml", "[levels]\nEDS005 = \"deny\"\n");
    assert_eq!(summary(&[config, other], &["--config", "other.toml"]), "3 errors");
}

#[test]
fn a_profile_is_forced_by_argument_or_configuration() {
    // A drive of CiA 402, which knows nothing of what an encoder has to have.
    let good = include_str!("../../../tests/fixtures/rules/INI001.fixed.eds");
    let drive = good.replace("DefaultValue=0x00000000", "DefaultValue=0x00020192");
    let run = |config: &str, arguments: &[&str]| {
        let files: &[(&str, &[u8])] = &[("drive.eds", drive.as_bytes()), ("lexican.toml", config.as_bytes())];
        let ran = Lexican::with(files).run(&[&["check", "drive.eds"], arguments].concat());
        ran.stdout.contains("[ENC")
    };
    assert!(!run("", &[]));
    assert!(run("", &["--profile", "406"]));
    assert!(run("profile = 406", &[]));
    assert!(!run("profile = 406", &["--profile", "402"]));
    assert!(run("[[override]]\nfiles = [\"*.eds\"]\nprofile = 406", &[]));
}

#[test]
fn patterns_of_a_named_configuration_start_in_its_folder() {
    let text = "[[override]]\nfiles = [\"old/*\"]\nlevels.OBJ = \"allow\"\n";
    let arguments = ["--config", "devices/settings.toml"];
    assert_eq!(
        summary(&[("devices/settings.toml", text)], &arguments),
        "1 error, 1 warning"
    );
}

#[test]
fn standard_input_takes_the_configuration_of_the_working_directory() {
    let lexican = Lexican::with(&[("lexican.toml", b"[levels]\nOBJ002 = \"allow\"\n")]);
    let ran = lexican.run_with_input(&["check", "-"], DENIED);
    assert_eq!(ran.printed(0), "1 file checked: no findings\n");
}

#[test]
fn the_configuration_is_that_of_the_folder_that_a_path_leads_to() {
    let lexican = Lexican::with(&[
        ("a/lexican.toml", b"[levels]\nOBJ002 = \"allow\"\n"),
        ("b/denied.eds", DENIED),
        ("a/x", b""),
    ]);
    let mut command = lexican.command(&["check", "../b/denied.eds"]);
    let output = command.current_dir(lexican.path().join("a")).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "the file is not below a/");
}

#[test]
fn generate_and_validate_follow_it_as_well() {
    let config = (
        "lexican.toml",
        b"[levels]\nOBJ002 = \"allow\"\nDMP = \"allow\"\n".as_slice(),
    );
    let lexican = Lexican::with(&[("denied.eds", DENIED), config]);
    lexican.run(&["generate", "denied.eds"]).printed(0);
    let generated = lexican.run(&["generate", "denied.eds", "--no-config"]);
    assert_eq!(generated.code, Some(1), "{generated:#?}");
    let lexican = Lexican::with(&[
        ("pump.eds", include_bytes!("../../../tests/fixtures/rules/DMP001.eds")),
        ("node.json", include_bytes!("../../../tests/fixtures/rules/DMP001.json")),
        config,
    ]);
    let ran = lexican.run(&["validate", "pump.eds", "node.json"]);
    assert_eq!(ran.printed(0), "1 device checked: no findings\n");
}

#[test]
fn what_is_wrong_in_a_configuration_has_a_place_and_nothing_is_checked() {
    let refused = |text: &str| {
        let lexican = Lexican::with(&[("lexican.toml", text.as_bytes()), ("denied.eds", DENIED)]);
        let ran = lexican.run(&["check", "denied.eds"]);
        assert_eq!(ran.stdout, "");
        ran.failed().strip_prefix("error: ").unwrap().trim_end().to_owned()
    };
    assert_eq!(
        refused("[levels]\nINI = \"allow\"\nEDS05 = \"warn\"\n"),
        "lexican.toml:3:1: unknown rule `EDS05`; did you mean EDS005?"
    );
    assert_eq!(
        refused("[levels]\nINI = \"fatal\"\n"),
        "lexican.toml:2:7: unknown level `fatal`; use allow, note, warn or deny"
    );
    assert_eq!(
        refused("[[override]]\nfiles = [\"a\", \"b/***\"]\n"),
        "lexican.toml:2:15: bad pattern `b/***`: wildcards are either regular `*` or recursive `**`"
    );
    let unknown = refused("[lints]\n");
    assert!(
        unknown.starts_with("lexican.toml:1:2: unknown field `lints`"),
        "{unknown}"
    );
    let unfinished = refused("[levels]\nINI = allow\n");
    assert!(unfinished.starts_with("lexican.toml:2:7: "), "{unfinished}");
    let negative = refused("profile = -1\n");
    assert!(negative.starts_with("lexican.toml:1:11: "), "{negative}");
}

#[test]
fn a_configuration_that_is_missing_is_named() {
    let lexican = Lexican::with(&[("denied.eds", DENIED)]);
    let ran = lexican.run(&["check", "denied.eds", "--config", "nope.toml"]);
    assert_eq!(
        ran.failed(),
        "error: cannot read nope.toml: there is no such file or directory\n"
    );
}

#[test]
fn the_example_of_the_documentation_works() {
    let page = include_str!("../../../docs/config.md");
    let (_, rest) = page.split_once("```toml\n").unwrap();
    let (text, _) = rest.split_once("```").unwrap();
    let lexican = Lexican::with(&[
        ("lexican.toml", text.as_bytes()),
        ("denied.eds", DENIED),
        ("vendor/warned.eds", WARNED),
    ]);
    assert!(
        lexican
            .run(&["check", "denied.eds"])
            .printed(1)
            .contains("error[OBJ002]")
    );
    assert!(lexican.run(&["check", "vendor"]).printed(0).contains("note[EDS005]"));
}
