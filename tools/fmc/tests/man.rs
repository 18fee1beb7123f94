//! `fmc man`: the pages of the manual have every command and every option that `--help` has.

#[path = "../../../benchmarks/tests/folder/folder.rs"]
mod folder;

use folder::Folder;
use std::process::Command;

fn fmc(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_fmc")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// What `--help` lists under "Commands:".
fn commands(help: &str) -> Vec<&str> {
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names = listed.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").collect()
}

/// Long options, as lines of the help begin with them.
fn options(help: &str) -> Vec<String> {
    let words = help.lines().filter_map(|line| line.split_whitespace().find(|word| word.starts_with("--")));
    words.map(|word| word.trim_end_matches(|c: char| !c.is_alphanumeric()).to_owned()).collect()
}

/// Compares the page of a command with its help, then those of the commands below it; returns how many options were seen.
fn compare(folder: &Folder, command: &[&str]) -> usize {
    let name = [&["fmc"], command].concat().join("-");
    let page = folder.text(&format!("{name}.1")).replace("\\-", "-");
    let help = fmc(&[command, &["--help"]].concat());
    let options = options(&help);
    for option in &options {
        assert!(page.contains(option.as_str()), "{name}.1 lacks {option}");
    }
    let below = commands(&help);
    below.iter().fold(options.len(), |seen, below| {
        assert!(page.contains(&format!("{name}-{below}(1)")), "{name}.1 lacks {below}");
        seen + compare(folder, &[command, &[*below]].concat())
    })
}

#[test]
fn the_manual_has_what_the_help_has() {
    let folder = Folder::new("man");
    fmc(&["man", folder.0.to_str().unwrap()]);
    let seen = compare(&folder, &[]);
    assert!(seen > 20, "only {seen} options were found");
}
