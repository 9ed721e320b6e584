//! Tests of the Raw pipeline against the thesis.

mod beyond;
mod common;
mod distribution;
mod experiment;
mod fast;
mod fragments;
mod hostile;
mod mixes;
mod parallel;
