//! Tests of RAVE through its calls.

mod calls;
mod conformance;
mod scene;
