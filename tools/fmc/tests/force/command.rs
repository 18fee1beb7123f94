//! A run of the command.

use serde_json::Value;
use std::path::PathBuf;
use std::process::Output;

/// What a run printed and how it ended.
pub(crate) struct Run {
    pub(crate) status: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// `fmc force` in the root of the repository, with words separated by blanks; `{}` stands for a folder of this test.
pub(crate) fn force(test: &str, words: &str) -> Run {
    let folder = folder(test);
    let words = words.replace("{}", folder.to_str().unwrap());
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_fmc"));
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).arg("force");
    command.args(words.split_whitespace()).arg("--out").arg(folder.join("out"));
    let Output { status, stdout, stderr } = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Run { status: status.code(), stdout: text(stdout), stderr: text(stderr) }
}

/// The same, successful, as the JSON on standard output.
pub(crate) fn json(test: &str, words: &str) -> Value {
    let run = force(test, &format!("{words} --json -"));
    assert_eq!(run.status, Some(0), "{words}: {}", run.stderr);
    assert_eq!(run.stderr, "");
    serde_json::from_str(&run.stdout).unwrap()
}

/// A folder for the files of one test.
pub(crate) fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
