//! Any stream of Quark 3D's calls: no panic, no hang.
//!
//! The same function of bytes runs over seeded inputs in the tests and in the
//! program `fuzz` of the test kit.

#![no_main]

use fillrate_testkit::fuzz::run_quark;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| drop(run_quark(bytes, 1)));
