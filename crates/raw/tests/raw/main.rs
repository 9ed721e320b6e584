//! Tests of the Raw pipeline against the thesis.

mod common;
mod fragments;
mod parallel;
