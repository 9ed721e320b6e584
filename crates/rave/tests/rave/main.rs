//! Tests of RAVE through its calls.

mod calls;
