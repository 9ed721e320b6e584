//! What can go wrong with a command stream.

/// A fault in the words a host sent. The device goes on as each variant says.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StreamError {
    /// An opcode that does not exist, or not in this mode. The word is skipped.
    #[error("word {offset}: opcode {word:#010x} is not a command of {mode} mode; skipped")]
    Opcode {
        /// The word.
        word: u32,
        /// Its place in the stream, counted from 0.
        offset: u64,
        /// The device mode: "command" or "scene".
        mode: &'static str,
    },
    /// An end-of-primitive marker inside a command. The primitive is dropped and the next one
    /// begins.
    #[error("word {offset}: primitive ends inside {command}; primitive dropped")]
    ShortCommand {
        /// The command that was being read.
        command: &'static str,
        /// The place of the zero count in the stream.
        offset: u64,
    },
    /// As [`StreamError::ShortCommand`], with the listing's behaviour: the device hangs.
    #[error("word {offset}: primitive ends inside {command}; the device hangs")]
    Hung {
        /// The command that was being read.
        command: &'static str,
        /// The place of the zero count in the stream.
        offset: u64,
    },
    /// A texture id that names no texture. The command has no effect; its data is drained.
    #[error("word {offset}: texture {id} does not exist")]
    Texture {
        /// The id.
        id: u32,
        /// The place of the command's last parameter in the stream.
        offset: u64,
    },
    /// The stream ends inside a command. What came of a block has been written; anything else of the
    /// command is dropped.
    #[error("word {offset}: the stream ends inside {command}, words missing: {missing}")]
    Unfinished {
        /// The command that was being read.
        command: &'static str,
        /// Words of it that did not come.
        missing: u32,
        /// The place in the stream where the next word would have been.
        offset: u64,
    },
    /// The stream ends inside a scene. What was sent of it may be drawn or not.
    #[error("word {offset}: the stream ends inside a scene")]
    OpenScene {
        /// The place in the stream where the next word would have been.
        offset: u64,
    },
    /// Words after the device was halted. They are dropped.
    #[error("word {offset}: the device is halted")]
    Halted {
        /// The place of the word in the stream.
        offset: u64,
    },
}
