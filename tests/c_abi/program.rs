//! Programs that the tests call, and the places they work in.

use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs};

/// Root of the package.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where cargo has put the libraries that belong to this test.
pub(crate) fn built() -> PathBuf {
    env::current_exe().expect("a test has a path").parent().expect("a folder").to_owned()
}

/// A new, empty folder for one test.
pub(crate) fn scratch(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c_abi").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

/// The shared library under its soname, by which programs ask for it, in a folder that is then their path.
pub(crate) fn shared_library(folder: &Path) -> PathBuf {
    let name = concat!("libfmc_contact.so.", env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
    symlink(built().join("libfmc_contact.so"), folder.join(name)).expect("a link");
    folder.join(name)
}

/// Runs a program to its end, with a word of help where it is missing.
pub(crate) fn run(command: &mut Command) -> Output {
    command.output().unwrap_or_else(|error| panic!("{command:?} cannot be run ({error}): `make tools` installs it"))
}

/// Runs a program that must succeed, and gives back what it printed.
pub(crate) fn succeed(command: &mut Command) -> String {
    let output = run(command);
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{command:?}\n{}\n{out}\n{err}", output.status);
    out.into_owned()
}

/// A compiler, as the environment names it, with flags behind the name as make has them.
pub(crate) fn compiler(variable: &str, otherwise: &str) -> Command {
    let given = env::var(variable).unwrap_or(otherwise.to_owned());
    let mut words = given.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or(otherwise));
    command.args(words);
    command
}

/// Whether sanitizers watch the hosts (`make sanitizers`), which keep what is given back for a while.
pub(crate) fn is_sanitized() -> bool {
    ["CC", "CXX", "FC"].into_iter().any(|name| env::var(name).is_ok_and(|compiler| compiler.contains("-fsanitize")))
}

/// What a program prints under valgrind, which must find nothing; not where sanitizers watch it already, since both want the same
/// memory.
pub(crate) fn watched(program: &Path, arguments: &[&str]) -> Option<String> {
    if is_sanitized() {
        return None;
    }
    // Worker threads may outlive the pool that started them by a moment, so blocks that they hold are no leak.
    let leaks =
        ["--leak-check=full", "--errors-for-leak-kinds=definite,indirect", "--show-leak-kinds=definite,indirect"];
    let mut valgrind = Command::new("valgrind");
    Some(succeed(valgrind.args(["-q", "--error-exitcode=9"]).args(leaks).arg(program).args(arguments)))
}
