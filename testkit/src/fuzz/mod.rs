//! Fuzzing of the front ends: every target is a function of bytes, for
//! cargo-fuzz, for the program `fuzz`, and for the tests.

mod bytes;
mod calls;
mod quark;
mod rave;
mod redline;
mod streams;
mod textures;

use fillrate_engine::DeviceConfig;
use fillrate_glide::Context;

pub use bytes::Bytes;
pub use calls::any_call;
pub use quark::{any_quark_call, run_quark};
pub use rave::{any_rave_call, run_rave};
pub use redline::{any_redline_call, any_redline_words, run_redline_calls, run_redline_words};
pub use streams::{Left, context, run_stream};
pub use textures::{run_file, run_texture};

use crate::random::Rng;

/// What can be fuzzed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Streams of calls with any arguments.
    Calls,
    /// Downloads in every format, each texel compared.
    Textures,
    /// `.3df` files.
    Files,
    /// Streams of Quark 3D's calls.
    Quark,
    /// Streams of RAVE's calls.
    Rave,
    /// Streams of RRedline's words.
    RedlineWords,
    /// Streams of RRedline's calls.
    RedlineCalls,
    /// Words, records and calls of Raw, to its renderers and its simulator.
    Raw,
}

impl Target {
    /// All of them.
    pub const ALL: [Target; 8] = [
        Target::Calls,
        Target::Textures,
        Target::Files,
        Target::Quark,
        Target::Rave,
        Target::RedlineWords,
        Target::RedlineCalls,
        Target::Raw,
    ];

    /// The name on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Target::Calls => "calls",
            Target::Textures => "textures",
            Target::Files => "files",
            Target::Quark => "quark",
            Target::Rave => "rave",
            Target::RedlineWords => "redline-words",
            Target::RedlineCalls => "redline-calls",
            Target::Raw => "raw",
        }
    }

    /// The input of a seed: up to 4 KiB.
    pub fn input(self, seed: u64) -> Vec<u8> {
        match self {
            Target::Raw => fillrate_raw::hostile::stream(seed),
            _ => input(seed),
        }
    }
}

/// What a target keeps from one execution to the next, so that not each of them
/// has to make texture memory.
#[derive(Debug)]
pub struct Fuzzer {
    target: Target,
    quiet: Context,
    checking: Context,
}

impl Fuzzer {
    /// Ready for executions.
    pub fn new(target: Target) -> Fuzzer {
        let device = || DeviceConfig { threads: 1, ..DeviceConfig::default() };
        Fuzzer { target, quiet: context(device(), false), checking: context(device(), true) }
    }

    /// One execution. Nothing an execution does may matter to the next one but
    /// through texture memory and tables, which are not cleared.
    ///
    /// # Panics
    /// Where something is wrong.
    pub fn run(&mut self, bytes: &[u8]) {
        let checks = bytes.first().is_some_and(|first| first & 1 == 1);
        let context = if checks { &mut self.checking } else { &mut self.quiet };
        match self.target {
            Target::Calls => drop(run_stream(context, bytes)),
            Target::Textures => run_texture(context, bytes),
            Target::Files => run_file(bytes),
            Target::Quark => drop(run_quark(bytes, 1)),
            Target::Rave => drop(run_rave(bytes, 1)),
            Target::RedlineWords => drop(run_redline_words(bytes, 1)),
            Target::RedlineCalls => drop(run_redline_calls(bytes, 1)),
            Target::Raw => fillrate_raw::hostile::feed(bytes),
        }
    }
}

/// The input of a seed: up to 4 KiB.
pub fn input(seed: u64) -> Vec<u8> {
    let mut rng = Rng::new(seed);
    let most = if rng.one_in(8) { 4080 } else { 1000 };
    let length = 16 + rng.below(most);
    (0..length).map(|_| rng.word() as u8).collect()
}
