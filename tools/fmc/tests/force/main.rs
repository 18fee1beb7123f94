//! The command `fmc force`, run as a user runs it.

mod abaqus;
mod command;
mod mixed;
mod picture;
mod refusals;
mod results;
mod second_order;
