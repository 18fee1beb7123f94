//! The C interface, called in any order with anything a host may hand over.
#![no_main]

use fmc_fuzz::{host, program::Program};

libfuzzer_sys::fuzz_target!(|program: Program| host::run(&program));
