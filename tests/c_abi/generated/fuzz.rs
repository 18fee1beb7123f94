//! A Rust module with the same declarations, for the fuzz targets, which call the library as a host does.

use crate::declarations::{Declarations, Function, Struct, Variable};
use std::fmt::Write;

const TITLE: &str = "\
//! `include/fmc_contact.h`, written down for Rust.
//!
//! Generated from the header by `make header`; do not edit.

use std::ffi::{c_char, c_void};

pub type fmc_status = i32;
";

pub(super) fn declarations(found: &Declarations) -> String {
    let mut text = TITLE.to_owned();
    for (name, value) in &found.constants {
        let of_type = if is_flag(name) { "u32" } else { "i32" };
        let _ = writeln!(text, "pub const {name}: {of_type} = {value};");
    }
    for name in &found.opaque {
        let _ = writeln!(text, "\n#[repr(C)]\npub struct {name} {{\n    _private: [u8; 0],\n}}");
    }
    for callback in &found.callbacks {
        let name = &callback.returns.name;
        let _ = writeln!(
            text,
            "\npub type {name} = Option<unsafe extern \"C\" fn({}){}>;",
            arguments(callback),
            returned(callback)
        );
    }
    found.structs.iter().for_each(|one| text += &structure(found, one));
    text += "\nunsafe extern \"C\" {\n";
    for function in &found.functions {
        let _ = writeln!(text, "    pub fn {}({}){};", function.returns.name, arguments(function), returned(function));
    }
    text + "}\n"
}

/// Bits of `flags`, which is unsigned.
fn is_flag(name: &str) -> bool {
    ["FMC_EVALUATE_", "FMC_TANGENT_", "FMC_CSR_"].iter().any(|prefix| name.starts_with(prefix))
}

fn structure(found: &Declarations, of: &Struct) -> String {
    let compares = if has_callback(found, &of.name) { "" } else { ", PartialEq" };
    let fields: String = of
        .fields
        .iter()
        .map(|field| match field.length {
            Some(length) => format!("    pub {}: [{}; {length}],\n", field.name, type_of(field)),
            None => format!("    pub {}: {},\n", field.name, type_of(field)),
        })
        .collect();
    format!("\n#[repr(C)]\n#[derive(Clone, Copy, Debug, Default{compares})]\npub struct {} {{\n{fields}}}\n", of.name)
}

/// Whether a struct holds a function, itself or in what it contains: such do not compare.
fn has_callback(found: &Declarations, name: &str) -> bool {
    let fields = found.structs.iter().filter(|one| one.name == name).flat_map(|one| &one.fields);
    fields
        .filter(|field| field.pointers == 0)
        .any(|field| found.is_callback(&field.of_type) || has_callback(found, &field.of_type))
}

fn arguments(of: &Function) -> String {
    let each = of.arguments.iter().map(|argument| format!("{}: {}", argument.name, type_of(argument)));
    each.collect::<Vec<_>>().join(", ")
}

fn returned(of: &Function) -> String {
    match (of.returns.of_type.as_str(), of.returns.pointers) {
        ("void", 0) => String::new(),
        _ => format!(" -> {}", type_of(&of.returns)),
    }
}

fn type_of(of: &Variable) -> String {
    let base = match of.of_type.as_str() {
        "double" => "f64",
        "char" => "c_char",
        "void" => "c_void",
        "size_t" => "usize",
        "ptrdiff_t" => "isize",
        "int32_t" => "i32",
        "int64_t" => "i64",
        "uint8_t" => "u8",
        "uint32_t" => "u32",
        "uint64_t" => "u64",
        name => name,
    };
    let inner = if of.is_const { "*const " } else { "*mut " };
    match of.pointers {
        0 => base.to_owned(),
        levels => "*mut ".repeat(levels - 1) + inner + base,
    }
}
