//! The plugin for FEBio: compiled against stubs of FEBio's headers, loaded as FEBio loads it, and run by a small host.

use super::program::{compiler, root, scratch, shared_library, succeed};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Compiles a source of the plugin's folder against the stubs.
fn compile(source: &str, folder: &Path, library: &Path, flags: &[&str]) -> PathBuf {
    let made = folder.join(source.replace('/', "_")).with_extension("out");
    let mut command = compiler("CXX", "c++");
    command.args([
        "-std=c++17",
        "-g",
        "-O1",
        "-ffp-contract=off",
        "-pedantic",
        "-Wall",
        "-Wextra",
        "-Wconversion",
        "-Werror",
    ]);
    for include in ["include", "hosts/febio/stubs", "benchmarks/host_checks/cpp"] {
        command.arg("-I").arg(root().join(include));
    }
    command.args(flags).arg("-o").arg(&made).arg(root().join("hosts/febio").join(source)).arg(library);
    succeed(command.arg(format!("-Wl,-rpath,{}", folder.display())).args(["-ldl", "-lm", "-pthread"]));
    made
}

/// Not under valgrind, which would take half a minute: the library's calls are watched in other programs.
#[test]
fn plugin_of_febio_in_a_small_host() {
    let folder = scratch("febio");
    let library = shared_library(&folder);
    let plugin = compile("fmc_febio.cpp", &folder, &library, &["-fPIC", "-shared"]);
    // The plugin and its host share the kernel that the stubs define.
    let check = compile("check/check.cpp", &folder, &library, &["-rdynamic"]);
    assert_eq!(succeed(Command::new(check).arg(plugin)), "0 failures\n");
}
