//! Any stream of RAVE's calls: no panic, no hang.
//!
//! The same function of bytes runs over seeded inputs in the tests and in the
//! program `fuzz` of the test kit.

#![no_main]

use fillrate_testkit::fuzz::run_rave;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| drop(run_rave(bytes, 1)));
