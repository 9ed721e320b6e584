//! Any stream of RRedline's words: no panic, no hang.
//!
//! The same function of bytes runs over seeded inputs in the tests and in the
//! program `fuzz` of the test kit.

#![no_main]

use fillrate_testkit::fuzz::run_redline_words;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| drop(run_redline_words(bytes, 1)));
