//! What `make install` leaves behind: usable through pkg-config and CMake, also after the folder has been moved.

use super::program::{built, compiler, root, scratch, succeed};
use super::readme;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Installs into a folder and moves that away, so that no path of the installation itself can be used.
fn installed(name: &str, libdir: &str) -> PathBuf {
    let folder = scratch(name);
    let mut make = Command::new("make");
    make.current_dir(root()).arg("install").arg(format!("BUILT={}", built().display()));
    make.arg(format!("LIBDIR={libdir}")).arg(format!("PREFIX={}", folder.join("before").display()));
    // What a calling make has set is none of this one's business.
    succeed(make.env_remove("MAKEFLAGS").env_remove("MAKELEVEL").env_remove("DESTDIR"));
    fs::rename(folder.join("before"), folder.join("after")).expect("a move");
    folder.join("after")
}

fn pkg_config(prefix: &Path, arguments: &str) -> Vec<String> {
    let path = prefix.join("lib/pkgconfig");
    let words =
        succeed(Command::new("pkg-config").args(arguments.split(' ')).arg("fmc_contact").env("PKG_CONFIG_PATH", path));
    words.split_whitespace().map(str::to_owned).collect()
}

/// What a host prints that is built as the CMake project of its folder.
fn by_cmake(prefix: &Path, language: &str, host: &str) -> String {
    let build = prefix.join(format!("cmake-build-{language}"));
    let mut configure = Command::new("cmake");
    configure.arg("-S").arg(root().join("hosts").join(language)).arg("-B").arg(&build);
    succeed(configure.arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display())));
    succeed(Command::new("cmake").arg("--build").arg(&build));
    succeed(&mut Command::new(build.join(host)))
}

#[test]
fn programs_find_the_installed_library() {
    let prefix = installed("install", "lib");
    let host = root().join("hosts/c/two_squares.c");

    let program = prefix.join("by_pkg_config");
    let mut cc = compiler("CC", "cc");
    cc.arg(&host).args(pkg_config(&prefix, "--cflags")).args(pkg_config(&prefix, "--libs"));
    succeed(cc.arg(format!("-Wl,-rpath,{}/lib", prefix.display())).arg("-o").arg(&program));
    let by_pkg_config = succeed(&mut Command::new(&program));
    assert!(by_pkg_config.starts_with("overlap 0.008\n"));
    assert_eq!(pkg_config(&prefix, "--modversion"), [env!("CARGO_PKG_VERSION")]);
    let needed = succeed(Command::new("readelf").arg("-d").arg(&program));
    let name = concat!("libfmc_contact.so.", env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
    assert!(needed.contains(&format!("[{name}]")), "{needed}");

    let (source, by_cpp) = (prefix.join("squares.cpp"), prefix.join("squares_cpp"));
    fs::write(&source, readme::program("cpp")).expect("a writable folder");
    let mut cxx = compiler("CXX", "c++");
    cxx.arg(&source).args(pkg_config(&prefix, "--cflags")).args(pkg_config(&prefix, "--libs"));
    succeed(cxx.arg(format!("-Wl,-rpath,{}/lib", prefix.display())).arg("-o").arg(&by_cpp));
    readme::expect_forces(&succeed(&mut Command::new(&by_cpp)));

    assert_eq!(by_cmake(&prefix, "c", "two_squares"), by_pkg_config);
    assert_eq!(by_cmake(&prefix, "cpp", "approach").lines().count(), 5);

    let program = prefix.join("static");
    let mut cc = compiler("CC", "cc");
    cc.arg(&host).args(pkg_config(&prefix, "--cflags")).arg(prefix.join("lib/libfmc_contact.a"));
    succeed(cc.args(["-lpthread", "-ldl", "-lm", "-o"]).arg(&program));
    assert_eq!(succeed(&mut Command::new(&program)), by_pkg_config);

    // Without any shared library, as pkg-config says; glibc warns of what it would still load.
    let program = prefix.join("all_static");
    let mut cc = compiler("CC", "cc");
    cc.arg("-static").arg(&host).args(pkg_config(&prefix, "--cflags")).args(pkg_config(&prefix, "--static --libs"));
    succeed(cc.arg("-o").arg(&program));
    assert_eq!(succeed(&mut Command::new(&program)), by_pkg_config);

    let library = prefix.join("lib").join(concat!("libfmc_contact.so.", env!("CARGO_PKG_VERSION")));
    let sections = succeed(Command::new("readelf").arg("-S").arg(&library));
    assert!(!sections.contains(".debug_info") && fs::metadata(&library).expect("a file").len() < 20_000_000);
    for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
        assert!(prefix.join("share/doc/fmc-contact").join(file).exists());
    }

    let program = prefix.join("in_fortran");
    let mut fortran = compiler("FC", "gfortran");
    fortran.current_dir(&prefix);
    fortran.args(["include/fmc_contact_c.f90", "include/fmc_contact.f90"]);
    fortran.arg(root().join("hosts/fortran/two_squares.f90")).args(pkg_config(&prefix, "--libs"));
    succeed(fortran.arg(format!("-Wl,-rpath,{}/lib", prefix.display())).arg("-o").arg(&program));
    assert!(succeed(&mut Command::new(&program)).starts_with("overlap 0.008\n"));
}

/// Versions that a project may ask for, alone or as a range, and those that it may not.
#[test]
fn versions_are_found_by_one_rule() {
    let prefix = installed("install-versions", "lib");
    let finds = |asked: &str| {
        let project = prefix.join("project");
        fs::create_dir_all(&project).expect("a folder");
        let lines = format!(
            "cmake_minimum_required(VERSION 3.19)\nproject(asks LANGUAGES NONE)\n\
             find_package(fmc_contact {asked} QUIET)\nfile(WRITE found \"${{fmc_contact_FOUND}}\")\n"
        );
        fs::write(project.join("CMakeLists.txt"), lines).expect("a writable folder");
        let mut cmake = Command::new("cmake");
        cmake.arg("-S").arg(&project).arg("-B").arg(project.join("build"));
        succeed(cmake.arg("--fresh").arg(format!("-DCMAKE_PREFIX_PATH={}", prefix.display())));
        fs::read_to_string(project.join("found")).expect("an answer") == "1"
    };
    let [major, minor] = [env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR")];
    let next: u32 = minor.parse::<u32>().expect("a number") + 1;
    let this = format!("{major}.{minor}");
    let found =
        ["", &this, &format!("{this}.0"), &format!("{major}.0...{major}.99"), &format!("{this}...<{major}.{next}")];
    for asked in found {
        assert!(finds(asked), "{asked}");
    }
    let later = [
        format!("{major}.{next}"),
        format!("{this}.99"),
        format!("{major}.{next}...{major}.99"),
        format!("0.0...<{this}"),
    ];
    for asked in later {
        assert!(!finds(&asked), "{asked}");
    }
}

/// As distributions have it: libraries in a folder of their own by architecture.
#[test]
fn libraries_may_lie_deeper() {
    let machine = succeed(compiler("CC", "cc").arg("-dumpmachine"));
    let libdir = format!("lib/{}", machine.trim());
    let prefix = installed("install-deeper", &libdir);
    let by_cmake = by_cmake(&prefix, "c", "two_squares");
    assert!(by_cmake.starts_with("overlap 0.008\n"), "{by_cmake}");
    let path = prefix.join(&libdir).join("pkgconfig");
    let libs =
        succeed(Command::new("pkg-config").args(["--libs", "--cflags", "fmc_contact"]).env("PKG_CONFIG_PATH", path));
    let program = prefix.join("program");
    let mut cc = compiler("CC", "cc");
    cc.arg(root().join("hosts/c/two_squares.c")).args(libs.split_whitespace()).arg("-o").arg(&program);
    succeed(cc.arg(format!("-Wl,-rpath,{}/{libdir}", prefix.display())));
    assert_eq!(succeed(&mut Command::new(&program)), by_cmake);
}
