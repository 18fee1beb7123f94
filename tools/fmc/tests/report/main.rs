//! `fmc report` as a user runs it: the page and its pictures, what a browser makes of it, and going on after an interruption.

#[path = "../../../../benchmarks/tests/folder/folder.rs"]
mod folder;

mod browser;
mod page;
mod resume;

use folder::Folder;
use std::process::{Command, Output};

fn report(folder: &Folder, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_fmc"));
    command.arg("report").args(arguments).arg("--out").arg(&folder.0);
    command
}

fn output(folder: &Folder, arguments: &[&str]) -> Output {
    report(folder, arguments).output().expect("the command runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
