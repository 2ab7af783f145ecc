//! What users copy into their repositories: the hooks of pre-commit, the workflow of GitHub.

use saphyr::{LoadableYamlNode as _, Yaml};

use crate::lexican::{Lexican, Ran};

const HOOKS: &str = include_str!("../../../.pre-commit-hooks.yaml");
const WORKFLOW: &str = include_str!("../../../docs/github-workflow.yml");
/// One finding at deny, and no cure that is safe.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");

/// Runs `command` as the file says it, in a folder with one bad file.
fn run(command: &str, more: &[&str]) -> Ran {
    let mut words = command.split_whitespace();
    assert_eq!(words.next(), Some("lexican"), "{command}");
    let words = words.take_while(|word| *word != ">");
    let arguments: Vec<&str> = words.chain(more.iter().copied()).collect();
    Lexican::with(&[("pump.eds", DENIED)]).run(&arguments)
}

#[test]
fn each_hook_of_pre_commit_runs() {
    let hooks = Yaml::load_from_str(HOOKS).unwrap();
    let hooks = hooks[0].as_sequence().unwrap();
    assert_eq!(hooks.len(), 2);
    for hook in hooks {
        for key in ["id", "name", "description", "language", "files"] {
            assert!(hook[key].as_str().is_some(), "{key}");
        }
        let ran = run(hook["entry"].as_str().unwrap(), &["pump.eds"]);
        assert!(ran.printed(1).starts_with("pump.eds:93:10: error[OBJ002]"), "{ran:#?}");
    }
}

#[test]
fn the_steps_of_the_workflow_run() {
    let workflow = Yaml::load_from_str(WORKFLOW).unwrap();
    let steps = workflow[0]["jobs"]["check"]["steps"].as_sequence().unwrap();
    let commands = steps.iter().filter_map(|step| step.as_mapping_get("run")?.as_str());
    let commands: Vec<&str> = commands.filter(|command| command.starts_with("lexican")).collect();
    let [sarif, github] = commands[..] else {
        panic!("{commands:?}")
    };
    let log: serde_json::Value = serde_json::from_str(run(sarif, &[]).printed(1)).unwrap();
    assert_eq!(log["runs"][0]["results"][0]["ruleId"], "OBJ002");
    // In a folder that is given as `.` a file's path is one from the root of the repository, as GitHub wants it.
    let uri = &log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
    assert_eq!(uri, "pump.eds");
    assert!(
        run(github, &[]).printed(1).starts_with("::error file=pump.eds,line=93"),
        "{:#?}",
        run(github, &[])
    );
}
