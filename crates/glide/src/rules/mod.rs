//! Checking mode: every misuse that the documents name, as a table.
//!
//! A rule looks at a call before it is carried out. What only the C border
//! sees (null pointers, the size of a description), and what holds for every
//! call (a board is open), is in [`GENERAL`].
//!
//! Source: G22, error handling and the text of each function; G246, the
//! conditions of the debugging library.

mod draw;
mod frame;
mod pixel;
mod texture;

use fillrate_call::Tagged;

use crate::board::Board;
use crate::call::Call;
use crate::card::Card;
use crate::context::Context;
use crate::error::historic_name;
use crate::variables::Variables;

/// One rule. A message is "function: argument text".
#[derive(Clone, Copy)]
pub struct Rule {
    /// The entry point.
    pub function: &'static str,
    /// The argument as the headers name it; empty where it is about the call
    /// as a whole.
    pub argument: &'static str,
    /// What is wrong.
    pub text: &'static str,
    /// Whether the original would have ended the program.
    pub fatal: bool,
    broken: fn(&Call, &Situation<'_>) -> bool,
}

/// Rules that do not look at calls: argument and text.
pub const GENERAL: [(&str, &str); 3] = [NOT_OPEN, NULL_POINTER, INFO_SIZE];
pub(crate) const NOT_OPEN: (&str, &str) = ("", "no board is open");
pub(crate) const NULL_POINTER: (&str, &str) = ("a pointer", "is null");
pub(crate) const INFO_SIZE: (&str, &str) = ("info->size", "is not that of GrLfbInfo_t");

/// Functions that are another function's call with other arguments, and that
/// function, whose rules they share. What is told has their own name.
pub const SHARED: [(&str, &str); 8] = [
    ("grDrawPolygonVertexList", "grDrawPolygon"),
    ("grDrawPlanarPolygonVertexList", "grDrawPlanarPolygon"),
    ("grAADrawPolygonVertexList", "grAADrawPolygon"),
    ("grTexDownloadMipMapLevel", "grTexDownloadMipMapLevelPartial"),
    ("grTexDownloadTablePartial", "grTexDownloadTable"),
    ("guTexCombineFunction", "grTexCombineFunction"),
    ("grLfbGetReadPtr", "grLfbLock"),
    ("grLfbGetWritePtr", "grLfbLock"),
];

/// All rules that look at calls.
pub fn all() -> impl Iterator<Item = &'static Rule> {
    frame::RULES.iter().chain(pixel::RULES).chain(draw::RULES).chain(texture::RULES)
}

/// What rules may look at besides the call.
pub(crate) struct Situation<'a> {
    pub card: &'a Card,
    pub started: bool,
    pub boards: usize,
    /// The current board, open or not.
    pub board: Option<&'a Board>,
    pub variables: &'a Variables,
}

impl Situation<'_> {
    /// The current board where it is open.
    fn open(&self) -> Option<&Board> {
        self.board.filter(|board| board.is_open())
    }

    fn has_unit(&self, tmu: i32) -> bool {
        usize::try_from(tmu).is_ok_and(|tmu| tmu < self.card.units)
    }

    fn register(&self, read: fn(&Board) -> u32, bits: u32) -> bool {
        self.open().is_some_and(|board| read(board) & bits != 0)
    }

    fn size(&self) -> (u32, u32) {
        let buffers = self.open().and_then(|board| board.buffers.as_ref());
        buffers.map_or((0, 0), |buffers| (buffers.width, buffers.height))
    }

    fn has_aux(&self) -> bool {
        let buffers = self.open().and_then(|board| board.buffers.as_ref());
        buffers.is_some_and(|buffers| buffers.aux.is_some())
    }

    fn has_third_color(&self) -> bool {
        let buffers = self.open().and_then(|board| board.buffers.as_ref());
        buffers.is_some_and(|buffers| buffers.colors.len() > 2)
    }
}

/// Declares rules: each looks at one call's fields, and at the situation by
/// the name that is given first.
macro_rules! rules {
    ($at:ident; $($function:literal: $($call:ident)|+ $fields:tt $argument:literal $text:literal $severity:ident
        if $broken:expr;)*) => {
        pub(super) const RULES: &[Rule] = &[$(Rule {
            function: $function,
            argument: $argument,
            text: $text,
            fatal: crate::rules::severity!($severity),
            broken: |call, $at| {
                let _ = $at;
                match call {
                    $(crate::rules::pattern!($call $fields) => $broken,)+
                    _ => false,
                }
            },
        }),*];
    };
}
macro_rules! severity {
    (fatal) => {
        true
    };
    (warning) => {
        false
    };
}
macro_rules! pattern {
    ($call:ident ($($field:ident),*)) => { Call::$call { $($field,)* .. } };
}
use {pattern, rules, severity};

impl Context {
    /// Tells of every rule that a call breaks; true where there was one.
    pub(crate) fn apply_rules(&mut self, call: &Call) -> bool {
        let name = historic_name(call.name());
        let situation = Situation {
            card: &self.config.card,
            started: self.initialized,
            boards: self.boards.len(),
            board: self.boards.get(self.current),
            variables: &self.variables,
        };
        let broken: Vec<&Rule> =
            all().filter(|rule| rule.function == name && (rule.broken)(call, &situation)).collect();
        for rule in &broken {
            self.add_report(rule.function, rule.argument, rule.text.to_string(), rule.fatal);
        }
        !broken.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_rule_is_there_once() {
        let names: BTreeSet<_> = all().map(|r| (r.function, r.argument, r.text)).collect();
        assert_eq!(names.len(), all().count());
        assert!(names.len() > 130, "{}", names.len());
    }
}
