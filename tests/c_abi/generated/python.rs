//! Python modules with the same declarations, for ctypes.

use super::pointers::{is_array, is_index_list};
use crate::declarations::{Declarations, Enum, Function, Struct, Variable};
use std::collections::BTreeSet;
use std::fmt::Write;

const NOTE: &str =
    "Generated from the header by ``make header``; do not edit.\n\"\"\"\n\nfrom __future__ import annotations\n\n";

/// Longest line.
const WIDTH: usize = 120;

/// `FMC_LAW_DEPTH = 2`, and for every enumeration `FMC_LAW = {2: "depth", ...}`.
pub(super) fn constants(found: &Declarations) -> String {
    let mut text = format!(
        "\"\"\"Constants of ``include/fmc_contact.h``, and of every enumeration the names of its entries by their values.\n\n{NOTE}"
    );
    for (name, value) in &found.constants {
        let _ = writeln!(text, "{name} = {value}");
    }
    for one in &found.enums {
        let start = prefix(one);
        let entries = one.entries.iter();
        let items: Vec<_> =
            entries.map(|(name, value)| format!("{value}: \"{}\"", name[start..].to_lowercase())).collect();
        text.push('\n');
        text += &listed("", &format!("{}: dict[int, str] = {{", one.name.to_uppercase()), &items, "}");
    }
    text
}

/// Length of what all entries of an enumeration begin with, in whole words.
fn prefix(of: &Enum) -> usize {
    let first = &of.entries[0].0;
    let ends = first.match_indices('_').map(|(place, _)| place + 1);
    let is_shared = |end: &usize| of.entries.iter().all(|(name, _)| name.starts_with(&first[..*end]));
    ends.take_while(is_shared).last().unwrap_or(0)
}

/// Structs with their fields, opaque ones as pointers, and callbacks.
pub(super) fn structs(found: &Declarations) -> String {
    let mut text = format!(
        "\"\"\"Structs and callbacks of ``include/fmc_contact.h``, under the names that they have there.\n\n{NOTE}"
    );
    let mut body = String::new();
    for name in &found.opaque {
        let _ = write!(body, "\n\nclass {name}(c_void_p):\n    \"\"\"``{name} *``\"\"\"\n");
    }
    body.push('\n');
    for callback in &found.callbacks {
        let returns = &callback.returns;
        let returned = if returns.of_type == "void" { "None".to_owned() } else { number(&returns.of_type).to_owned() };
        let arguments = callback.arguments.iter().map(of_callback);
        let items: Vec<_> = std::iter::once(returned).chain(arguments).collect();
        body.push('\n');
        body += &listed("", &format!("{} = CFUNCTYPE(", returns.name), &items, ")");
    }
    for one in &found.structs {
        body += &structure(found, one);
    }
    text += &imports("ctypes", names(&body).filter(|name| is_of_ctypes(name)));
    text + &body
}

fn structure(found: &Declarations, of: &Struct) -> String {
    let field = |field: &Variable| {
        let kind = match field.pointers {
            0 if field.of_type.starts_with("fmc_") && field.of_type != "fmc_status" => field.of_type.clone(),
            0 => number(&field.of_type).to_owned(),
            _ if found.structs.iter().any(|one| one.name == field.of_type) => format!("POINTER({})", field.of_type),
            _ => "c_void_p".to_owned(),
        };
        let length = field.length.map_or(String::new(), |length| format!(" * {length}"));
        format!("        (\"{}\", {kind}{length}),\n", field.name)
    };
    let fields: String = of.fields.iter().map(field).collect();
    format!("\n\nclass {}(Structure):\n    _fields_ = [\n{fields}    ]\n", of.name)
}

/// Result and arguments of every function.
pub(super) fn signatures(found: &Declarations) -> String {
    let mut text = format!("\"\"\"Functions of ``include/fmc_contact.h``: result and arguments of each.\n\n{NOTE}");
    let mut body = "\nFUNCTIONS: dict[str, tuple[Any, list[Any]]] = {\n".to_owned();
    found.functions.iter().for_each(|function| body += &signature(found, function));
    body += "}\n\"\"\"Result and argument types by name.\"\"\"\n";
    let used: BTreeSet<&str> = names(&body).collect();
    text += &imports("ctypes", used.iter().copied().filter(|name| is_of_ctypes(name)));
    text += "from typing import Any\n\n";
    text += &imports("._pointers", used.iter().copied().filter(|name| name.ends_with("Array")));
    let is_ours = |name: &&str| {
        found.is_opaque(name) || found.is_callback(name) || found.structs.iter().any(|one| one.name == *name)
    };
    text += &imports("._structs", used.iter().copied().filter(is_ours));
    text + &body
}

fn signature(found: &Declarations, of: &Function) -> String {
    let returned = match (of.returns.of_type.as_str(), of.returns.pointers) {
        ("char", 1) => "c_char_p",
        (of_type, _) => number(of_type),
    };
    let arguments: Vec<String> = of.arguments.iter().map(|argument| of_function(found, argument)).collect();
    let line = format!("    \"{}\": ({returned}, [{}]),\n", of.returns.name, arguments.join(", "));
    if line.len() <= WIDTH {
        return line;
    }
    let list = listed("        ", "[", &arguments, "],");
    format!("    \"{}\": (\n        {returned},\n{list}    ),\n", of.returns.name)
}

fn of_function(found: &Declarations, argument: &Variable) -> String {
    let of_type = argument.of_type.as_str();
    match (of_type, argument.pointers) {
        ("char", 1) => "c_char_p".into(),
        ("char", _) => "POINTER(c_char_p)".into(),
        ("void", _) if is_index_list(argument) => "IndexArray".into(),
        ("void", _) => "c_void_p".into(),
        _ if found.is_callback(of_type) => of_type.into(),
        (name, 1) if found.is_opaque(name) => name.into(),
        (name, 0) => number(name).into(),
        ("double" | "int32_t" | "int64_t", 1) if is_array(argument) => match of_type {
            "double" => "Float64Array".into(),
            "int32_t" => "Int32Array".into(),
            _ => "Int64Array".into(),
        },
        (name, _) if name.starts_with("fmc_") => format!("POINTER({name})"),
        (name, _) => format!("POINTER({})", number(name)),
    }
}

fn of_callback(argument: &Variable) -> String {
    match (argument.of_type.as_str(), argument.pointers) {
        ("char", _) => "c_char_p".into(),
        ("void", _) => "c_void_p".into(),
        (name, 0) => number(name).into(),
        // Structs come after the callbacks.
        (name, _) if name.starts_with("fmc_") => "c_void_p".into(),
        (name, _) => format!("POINTER({})", number(name)),
    }
}

fn number(c: &str) -> &'static str {
    match c {
        "double" => "c_double",
        "int32_t" | "fmc_status" => "c_int32",
        "int64_t" => "c_int64",
        "uint32_t" => "c_uint32",
        "uint64_t" => "c_uint64",
        "size_t" => "c_size_t",
        "ptrdiff_t" => "c_ssize_t",
        name => panic!("'{name}' has no counterpart in ctypes"),
    }
}

/// Words of code, without strings.
fn names(code: &str) -> impl Iterator<Item = &str> {
    let outside = code.split('"').step_by(2);
    outside.flat_map(|part| part.split(|letter: char| !letter.is_alphanumeric() && letter != '_'))
}

fn is_of_ctypes(name: &str) -> bool {
    name.starts_with("c_") || matches!(name, "CFUNCTYPE" | "POINTER" | "Structure")
}

/// Constants, then classes, then the rest, as ruff and isort have it.
fn imports<'a>(module: &str, used: impl Iterator<Item = &'a str>) -> String {
    let used: BTreeSet<&str> = used.collect();
    let rank = |name: &&str| match name {
        name if name.chars().all(|letter| !letter.is_lowercase()) => 0,
        name if name.starts_with(char::is_uppercase) => 1,
        _ => 2,
    };
    let mut items: Vec<String> = Vec::new();
    (0..3).for_each(|at| items.extend(used.iter().filter(|name| rank(name) == at).map(|name| (*name).to_owned())));
    let line = format!("from {module} import {}\n", items.join(", "));
    if items.is_empty() || line.len() <= WIDTH {
        return if items.is_empty() { String::new() } else { line };
    }
    listed("", &format!("from {module} import ("), &items, ")")
}

/// Items on one line where they fit, else each on its own.
fn listed(indent: &str, open: &str, items: &[String], close: &str) -> String {
    let line = format!("{indent}{open}{}{close}\n", items.join(", "));
    if line.len() <= WIDTH {
        return line;
    }
    let items: String = items.iter().map(|item| format!("{indent}    {item},\n")).collect();
    format!("{indent}{open}\n{items}{indent}{close}\n")
}
