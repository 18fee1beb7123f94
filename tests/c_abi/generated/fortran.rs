//! A Fortran module with the same declarations.

use super::pointers::{is_array, is_index_list};
use crate::declarations::{Declarations, Function, Variable};
use std::fmt::Write;

const TITLE: &str = "\
! The C interface of fmc-contact, name by name, as include/fmc_contact.h documents it. Module fmc_contact is built on it.
!
! Pointers are optional arguments: an omitted one is NULL. Lists of nodes, cells and degrees of freedom, type(*), have 32 or 64 bits
! like the mesh, and count from the option index_base. Bodies, obstacles, pairs and warnings count from 0 here. Initialise structs by
! their init functions, as in the header.
!
! Generated from the header; do not edit.
module fmc_contact_c
  use, intrinsic :: iso_c_binding
  implicit none
  public
";

pub(super) fn module(found: &Declarations) -> String {
    let mut text = TITLE.to_owned();
    text.push('\n');
    for (name, value) in &found.constants {
        // Names are the same in capitals here.
        let is_taken = found.functions.iter().any(|function| function.returns.name.eq_ignore_ascii_case(name));
        let name = if is_taken { format!("{name}_OF_HEADER") } else { name.clone() };
        let _ = writeln!(text, "  integer(c_int32_t), parameter :: {name} = {value}");
    }
    // A struct that holds another one comes after it.
    for of in &found.structs {
        let _ = writeln!(text, "\n  type, bind(c) :: {}", of.name);
        for field in &of.fields {
            let length = field.length.map_or(String::new(), |length| format!("({length})"));
            let of_type = match field.pointers {
                _ if found.is_callback(&field.of_type) => "type(c_funptr)".to_owned(),
                0 => type_of(&field.of_type),
                _ => "type(c_ptr)".to_owned(),
            };
            let _ = writeln!(text, "    {of_type} :: {}{length}", field.name);
        }
        text += "  end type\n";
    }
    text += "\n  abstract interface\n";
    found.callbacks.iter().for_each(|callback| text += &procedure(found, callback, true));
    text += "  end interface\n\n  interface\n";
    found.functions.iter().for_each(|function| text += &procedure(found, function, false));
    text += "  end interface\nend module\n";
    text
}

fn procedure(found: &Declarations, of: &Function, is_callback: bool) -> String {
    let name = &of.returns.name;
    let names: Vec<&str> = of.arguments.iter().map(|argument| argument.name.as_str()).collect();
    let (kind, returned) = match (of.returns.of_type.as_str(), of.returns.pointers) {
        ("void", 0) => ("subroutine", None),
        (_, 1) => ("function", Some("type(c_ptr)".to_owned())),
        (of_type, _) => ("function", Some(type_of(of_type))),
    };
    let mut text = wrapped(&format!("    {kind} {name}({}) bind(c)", names.join(", ")));
    text += "      import\n";
    of.arguments.iter().for_each(|argument| {
        let _ = writeln!(text, "      {}", argument_of(found, argument, is_callback));
    });
    if let Some(returned) = returned {
        let _ = writeln!(text, "      {returned} :: {name}");
    }
    text + &format!("    end {kind}\n")
}

/// What a callback is given is never NULL.
fn argument_of(found: &Declarations, argument: &Variable, of_callback: bool) -> String {
    let Variable { of_type, is_const, pointers, name, .. } = argument;
    let intent = if *is_const { "in" } else { "inout" };
    let may_lack = if of_callback { "" } else { ", optional" };
    match (of_type.as_str(), pointers) {
        _ if found.is_callback(of_type) => format!("type(c_funptr), value :: {name}"),
        ("void", 1) if !of_callback && is_index_list(argument) => {
            format!("type(*), intent({intent}), optional :: {name}(*)")
        }
        (opaque, 1) if opaque == "void" || found.is_opaque(opaque) => format!("type(c_ptr), value :: {name}"),
        ("char", 1) => format!("character(kind=c_char), intent(in) :: {name}(*)"),
        (_, 2) => format!("type(c_ptr), intent(inout){may_lack} :: {name}"),
        (_, 0) => format!("{}, value :: {name}", type_of(of_type)),
        _ => {
            let shape = if is_array(argument) { "(*)" } else { "" };
            format!("{}, intent({intent}){may_lack} :: {name}{shape}", type_of(of_type))
        }
    }
}

fn type_of(c: &str) -> String {
    match c {
        "double" => "real(c_double)".into(),
        "size_t" => "integer(c_size_t)".into(),
        "ptrdiff_t" => "integer(c_ptrdiff_t)".into(),
        "int64_t" | "uint64_t" => "integer(c_int64_t)".into(),
        "int32_t" | "uint32_t" | "fmc_status" => "integer(c_int32_t)".into(),
        name => {
            assert!(name.starts_with("fmc_"), "'{name}' has no counterpart");
            format!("type({name})")
        }
    }
}

/// Lines of at most 100 letters, broken after commas.
fn wrapped(line: &str) -> String {
    let (mut text, mut rest) = (String::new(), line);
    while rest.len() > 100
        && let Some(place) = rest[..98].rfind(", ")
    {
        let _ = writeln!(text, "{}, &", &rest[..place]);
        rest = &rest[place + 2..];
        if rest.len() <= 90 {
            return text + "        " + rest + "\n";
        }
    }
    text + rest + "\n"
}
