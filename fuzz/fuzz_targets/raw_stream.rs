//! Any bytes through the ways into the Raw renderer and its simulator: no panic, no hang.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| fillrate_raw::hostile::feed(bytes));
