//! Any stream of Glide calls: no panic, no hang.
//!
//! The same function of bytes runs over seeded inputs in the tests and in the
//! program `fuzz` of the test kit.

#![no_main]

use std::cell::RefCell;

use fillrate_testkit::fuzz::{Fuzzer, Target};
use libfuzzer_sys::fuzz_target;

thread_local! {
    static FUZZER: RefCell<Fuzzer> = RefCell::new(Fuzzer::new(Target::Calls));
}

fuzz_target!(|bytes: &[u8]| FUZZER.with_borrow_mut(|fuzzer| fuzzer.run(bytes)));
