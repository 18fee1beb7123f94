//! The C ABI: checks, conversions and the panic boundary; no mechanics. `include/fmc_contact.h` is made from it.
//!
//! Four floors; imports point down:
//!
//! - [`calls`]: the functions of the header, in rooms as its sections are;
//! - [`context`]: a contact of either dimension, what was found with it, and its lock;
//! - [`structs`]: ids, options, shapes, poses and results, and the types of the crate that they become;
//! - [`boundary`]: statuses, pointers that become slices, and the panic boundary in which every entry runs: a panic
//!   becomes a status, an error leaves its text behind, nothing is printed.
//!
//! Results are kept in the context as plain C structs until the next successful evaluation.
//!
//! The library has no state but two: the text of a thread's last error, and the panic hook (see [`boundary::entry`]).

// C names, so that a search for a name of the header finds it here.
#![allow(non_camel_case_types)]
// The functions are reached through their symbols, not through paths.
#![allow(unreachable_pub)]
// Whom a caller in C must obey is in the text of every function; "Safety" headings would go into the header.
#![allow(clippy::missing_safety_doc)]

mod boundary;
mod calls;
mod context;
mod structs;
