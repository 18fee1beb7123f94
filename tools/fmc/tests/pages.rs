//! What the pages show for a shell exists: commands of `fmc` with their options, cases and variants, targets of make, examples of
//! cargo, and folders that pip is to install.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All pages that are shown to a reader.
fn pages() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() && !name.starts_with(['.', '_']) && !name.starts_with("target") && name != "out" {
                folders.push(path);
            } else if name.ends_with(".md") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// Lines of the pages' blocks for a shell, without comments; those that go on are joined.
fn lines() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        for block in text.split("```sh\n").skip(1) {
            let block = block.split("```").next().unwrap().replace("\\\n", " ");
            let code = block.lines().map(|line| line.split(" #").next().unwrap().trim());
            let code = code.filter(|line| !line.is_empty() && !line.starts_with('#'));
            found.extend(code.map(|line| (page.clone(), line.to_owned())));
        }
    }
    found
}

/// Cases and variants that a command of `fmc` names.
fn check_case(words: &[&str], said: &str) {
    let named = match words {
        ["run" | "mesh", case, ..] | ["study", "newton" | "convergence", case, ..] => case,
        _ => return,
    };
    if named.starts_with('-') || named.ends_with(".toml") || named.to_uppercase() == **named {
        return;
    }
    let file = root().join(format!("benchmarks/cases/{named}.toml"));
    let text = fs::read_to_string(&file).unwrap_or_else(|_| panic!("no such case: {said}"));
    if let Some(at) = words.iter().position(|word| *word == "--variant") {
        assert!(text.contains(&format!("[variants.{}]", words[at + 1])), "no such variant: {said}");
    }
}

#[test]
fn commands_for_a_shell_exist() {
    let parts = fs::read_dir(root().join("make")).unwrap().map(|part| part.unwrap().path());
    let makefile: String =
        parts.chain([root().join("Makefile")]).map(|part| fs::read_to_string(part).unwrap()).collect();
    let is_target =
        |name: &str| makefile.lines().any(|line| line.split(':').next().unwrap().split(' ').any(|t| t == name));
    let (mut of_fmc, mut of_make) = (0, 0);
    for (page, line) in lines() {
        let said = format!("{}: {line}", page.display());
        let words: Vec<&str> = line.split_whitespace().map(|word| word.trim_matches(['[', ']', '"'])).collect();
        match words.as_slice() {
            ["fmc", rest @ ..] => {
                // Behind what cannot be read there is no help.
                let help = Command::new(env!("CARGO_BIN_EXE_fmc")).args(rest).arg("--help").output().unwrap();
                assert!(help.status.success(), "{said}\n{}", String::from_utf8_lossy(&help.stderr));
                check_case(rest, &said);
                of_fmc += 1;
            }
            ["make", "-C", folder, ..] => assert!(root().join(folder).join("Makefile").exists(), "{said}"),
            ["make", target, ..] => {
                assert!(is_target(target), "{said}");
                of_make += 1;
            }
            ["cargo", "run", rest @ ..] if rest.contains(&"--example") => {
                let example = rest[rest.iter().position(|word| *word == "--example").unwrap() + 1];
                let is_there = |folder: &str| root().join(folder).join(format!("{example}.rs")).exists();
                assert!(["hosts/reference/examples", "crates/mesh-io/examples"].into_iter().any(is_there), "{said}");
            }
            ["pip", "install", rest @ ..] => {
                for folder in rest.iter().filter(|word| word.starts_with("./")) {
                    assert!(root().join(folder).join("pyproject.toml").exists(), "{said}");
                }
            }
            _ => {}
        }
    }
    assert!(of_fmc >= 10 && of_make >= 15, "{of_fmc} of fmc, {of_make} of make");
}
