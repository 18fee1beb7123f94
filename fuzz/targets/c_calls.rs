//! The C interface, called in any order with anything a host may hand over.
#![no_main]

use fmc_fuzz::{host, leaks, program::Program, timed};

#[global_allocator]
static ALLOCATOR: leaks::Counting = leaks::Counting;

libfuzzer_sys::fuzz_target!(|program: Program| {
    timed::start();
    leaks::none_from(|| host::run(&program));
    timed::tell();
});
