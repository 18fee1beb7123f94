//! The command `fmc force`, run as a user runs it.

mod command;
mod refusals;
mod results;
