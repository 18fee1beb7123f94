//! The binary interface as it is recorded: functions with their arguments, constants, and the places of all fields.

use super::declarations::{Declarations, Function, Variable};
use super::program::{compiler, root, scratch, succeed};
use std::fmt::Write;
use std::process::Command;
use std::{env, fs};

/// A type with its pointers, as in C.
fn type_of(variable: &Variable) -> String {
    let constant = if variable.is_const { "const " } else { "" };
    format!("{constant}{}{}", variable.of_type, "*".repeat(variable.pointers))
}

fn signature(function: &Function) -> String {
    let arguments: Vec<String> = function.arguments.iter().map(type_of).collect();
    format!("{} {}({})", type_of(&function.returns), function.returns.name, arguments.join(", "))
}

/// Sizes and offsets are those of the C compiler.
fn layouts(declared: &Declarations) -> String {
    let mut source = "#include <fmc_contact.h>\n#include <stddef.h>\n#include <stdio.h>\nint main(void) {\n".to_owned();
    for one in &declared.structs {
        let name = &one.name;
        writeln!(source, "printf(\"struct {name}: %zu bytes, aligned to %zu\\n\", sizeof({name}), _Alignof({name}));")
            .unwrap();
        for field in &one.fields {
            let length = field.length.map_or(String::new(), |length| format!("[{length}]"));
            let (of_type, field) = (type_of(field), &field.name);
            writeln!(source, "printf(\"  %4zu %3zu {of_type} {field}{length}\\n\", offsetof({name}, {field}), sizeof((({name} *)0)->{field}));").unwrap();
        }
    }
    source += "return 0;\n}\n";
    let folder = scratch("record");
    let (code, program) = (folder.join("layouts.c"), folder.join("layouts"));
    fs::write(&code, source).expect("a program");
    succeed(compiler("CC", "cc").arg("-I").arg(root().join("include")).arg("-o").arg(&program).arg(&code));
    succeed(&mut Command::new(&program))
}

fn described() -> String {
    let header = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    let declared = Declarations::of(&header);
    let mut text =
        "# The binary interface of fmc_contact on 64-bit systems, one item a line: see docs/abi.md.\n".to_owned();
    for (name, value) in &declared.constants {
        writeln!(text, "constant {name} = {value}").unwrap();
    }
    for (kind, functions) in [("callback", &declared.callbacks), ("function", &declared.functions)] {
        functions.iter().for_each(|function| writeln!(text, "{kind} {}", signature(function)).unwrap());
    }
    text + &layouts(&declared)
}

/// A difference is a change of the binary interface. One that docs/abi.md allows is recorded with `UPDATE_ABI=1`, and told in the
/// CHANGELOG; any other needs a new number of the interface.
#[test]
fn the_interface_is_the_recorded_one() {
    let path = root().join("tests/c_abi/interface.txt");
    let found = described();
    if env::var_os("UPDATE_ABI").is_some() {
        fs::write(&path, &found).expect("tests/c_abi/interface.txt can be written");
    }
    let recorded = fs::read_to_string(&path).unwrap_or_default();
    let differs = recorded.lines().zip(found.lines()).find(|(before, now)| before != now);
    assert!(recorded == found, "not the recorded interface, from {differs:?} on: see docs/abi.md");
    assert!(found.lines().filter(|line| line.starts_with("function ")).count() > 80);
}

/// Every status, by its number and name: none is used again.
#[test]
fn no_two_statuses_share_a_number() {
    let header = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    let declared = Declarations::of(&header);
    let mut statuses: Vec<i64> =
        declared.constants.iter().filter(|(name, _)| name.starts_with("FMC_ERROR_")).map(|(_, value)| *value).collect();
    let count = statuses.len();
    statuses.sort_unstable();
    statuses.dedup();
    assert!(count > 40 && statuses.len() == count);
}
