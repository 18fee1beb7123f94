//! The command `fmc force`, run as a user runs it.

mod command;
mod mixed;
mod picture;
mod refusals;
mod results;
mod second_order;
