//! Completions and manual pages.

use std::fs;

use crate::lexican::Lexican;

const COMMANDS: [&str; 4] = ["check", "explain", "generate", "validate"];

#[test]
fn each_shell_learns_the_commands_and_options() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let ran = Lexican::with(&[]).run(&["completions", shell]);
        let script = ran.printed(0);
        for word in COMMANDS.into_iter().chain(["min-level", "no-config"]) {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}

#[cfg(unix)]
#[test]
fn bash_completes_a_command_and_an_option() {
    let lexican = Lexican::with(&[]);
    let script = lexican.run(&["completions", "bash"]).printed(0).to_owned();
    let complete = |words: &str, number: usize| {
        let ask = format!(
            "COMP_WORDS=({words}); COMP_CWORD={number}; _lexican lexican \"${{COMP_WORDS[{number}]}}\" \"${{COMP_WORDS[$(({number} - 1))]}}\"; echo \"${{COMPREPLY[@]}}\""
        );
        let output = std::process::Command::new("bash")
            .args(["-c", &format!("{script}\n{ask}")])
            .output()
            .unwrap();
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    };
    assert_eq!(complete("lexican val", 1), "validate");
    assert_eq!(complete("lexican check --min", 2), "--min-level");
    assert_eq!(complete("lexican check --format s", 3), "sarif");
}

#[test]
fn an_unknown_shell_is_refused() {
    let ran = Lexican::with(&[]).run(&["completions", "dos"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("possible values: bash"), "{}", ran.stderr);
}

#[test]
fn the_manual_page_names_the_commands() {
    let ran = Lexican::with(&[]).run(&["man"]);
    let page = ran.printed(0);
    assert!(page.contains(".TH lexican 1"), "{page}");
    for command in COMMANDS {
        assert!(page.contains(&format!("lexican\\-{command}(1)")), "{page}");
    }
}

#[test]
fn each_command_has_a_page_with_its_options() {
    let lexican = Lexican::with(&[]);
    let page = lexican.run(&["man", "check"]).printed(0).to_owned();
    assert!(page.contains(".TH lexican-check 1"), "{page}");
    assert!(page.contains("\\-\\-min\\-level"), "{page}");
    lexican.run(&["man", "-o", "man1"]).printed(0);
    let mut names: Vec<String> = fs::read_dir(lexican.path().join("man1"))
        .unwrap()
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert!(names.contains(&"lexican.1".to_owned()), "{names:?}");
    for command in COMMANDS {
        assert!(names.contains(&format!("lexican-{command}.1")), "{names:?}");
    }
    assert_eq!(
        fs::read_to_string(lexican.path().join("man1/lexican-check.1")).unwrap(),
        page
    );
}

#[test]
fn a_page_of_no_command_is_refused() {
    let ran = Lexican::with(&[]).run(&["man", "chekc"]);
    assert_eq!(
        ran.failed(),
        "error: there is no command `chekc`; `lexican --help` lists them all\n"
    );
}
