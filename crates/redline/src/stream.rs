//! Cutting a stream of words into commands.
//!
//! Every command says by its first words how long it is. The iterator checks
//! what a command needs to be carried out: known opcode and vertex type,
//! allowed counts, enough words. It allocates nothing.
//!
//! Source: RR, FIFO commands.

use crate::board::Chip;
use crate::opcode::{Opcode, Register, SET_CURRENT_TEXTURE, TEXTURE_PALETTE};
use crate::vertex::VertexType;

/// One command of a stream, its words still packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command<'a> {
    /// Loads a register: all of it, or the bits of `mask` where that is not 0.
    State {
        /// Which one.
        register: Register,
        /// Bits that change, in the low half; 0 for all 32.
        mask: u32,
        /// The new value.
        value: u32,
    },
    /// Base, stride code, masks (V in the high half), U and V multiplier of the
    /// source.
    CurrentTexture(&'a [u32; 5]),
    /// Sixteen palette entries, the first of a word in its high half.
    TexturePalette(&'a [u32; 8]),
    /// A primitive whose vertices have a type.
    Draw {
        /// What is drawn.
        opcode: Opcode,
        /// The type of the vertices.
        vertex: VertexType,
        /// Counts or sizes, where the command has them.
        head: &'a [u32],
        /// The vertices.
        vertices: &'a [u32],
    },
    /// Any other command.
    Other {
        /// What is done.
        opcode: Opcode,
        /// The high half of the first word.
        flags: u32,
        /// The words after the first.
        words: &'a [u32],
    },
}

impl Command<'_> {
    /// Whether another picture is shown from here on.
    #[inline]
    pub fn is_switch(&self) -> bool {
        let switches = |opcode| matches!(opcode, Opcode::Display | Opcode::StereoDisplay);
        matches!(*self, Command::Other { opcode, .. } if switches(opcode))
    }
}

/// What is wrong with a stream, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[error("word {at}: {kind}")]
pub struct StreamError {
    /// Index of the first word of the command.
    pub at: usize,
    /// What is wrong with it.
    pub kind: StreamErrorKind,
}

/// What can be wrong with a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[non_exhaustive]
pub enum StreamErrorKind {
    /// No command starts with this word.
    #[error("unknown command {0:#010x}")]
    UnknownCommand(u32),
    /// No vertex type has this code, or the chip lacks it.
    #[error("unknown vertex type {0}")]
    UnknownVertexType(u32),
    /// A count that the command does not allow.
    #[error("count {0} is not allowed")]
    Count(u32),
    /// The stream ends within the command.
    #[error("{needed} words are needed, {left} are left")]
    Incomplete {
        /// Words of the command.
        needed: u64,
        /// Words there are.
        left: usize,
    },
}

/// The commands of a stream.
///
/// Ends after the first error.
#[derive(Clone, Debug)]
pub struct Commands<'a> {
    words: &'a [u32],
    at: usize,
    chip: Chip,
    /// The last triangle's, since triangles come in runs.
    last: Option<Triangle>,
}

/// What follows from a triangle's first word.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    first: u32,
    vertex: VertexType,
    /// Words of its vertices.
    words: u32,
}

impl<'a> Commands<'a> {
    /// The commands in `words` as `chip` understands them.
    pub fn new(words: &'a [u32], chip: Chip) -> Commands<'a> {
        Commands::starting(words, 0, chip)
    }

    /// The commands from word `at` on, with which one begins.
    pub(crate) fn starting(words: &'a [u32], at: usize, chip: Chip) -> Commands<'a> {
        Commands { words, at, chip, last: None }
    }

    /// Index of the next command's first word.
    pub fn position(&self) -> usize {
        self.at
    }

    /// The next `count` words after the first, which are then passed.
    #[inline]
    fn take(&mut self, count: u64) -> Result<&'a [u32], StreamErrorKind> {
        let left = &self.words[self.at + 1..];
        let Some(body) = usize::try_from(count).ok().and_then(|count| left.get(..count)) else {
            let (needed, left) = (count.saturating_add(1), left.len() + 1);
            return Err(StreamErrorKind::Incomplete { needed, left });
        };
        self.at += 1 + body.len();
        Ok(body)
    }

    /// A word after the first, without passing it.
    fn peek(&self, index: usize) -> Result<u32, StreamErrorKind> {
        let (needed, left) = (index as u64 + 1, self.words.len() - self.at);
        let word = self.words.get(self.at + index).copied();
        word.ok_or(StreamErrorKind::Incomplete { needed, left })
    }

    /// The type and the words of the next command's vertices, where it begins as
    /// the triangle before did.
    #[inline(always)]
    pub(crate) fn next_alike(&mut self) -> Option<(VertexType, &'a [u32])> {
        let Triangle { first, vertex, words } = self.last?;
        let (at, end) = (self.at + 1, self.at + 1 + words as usize);
        if *self.words.get(self.at)? != first {
            return None;
        }
        let vertices = self.words.get(at..end)?;
        self.at = end;
        Some((vertex, vertices))
    }

    #[inline(never)]
    fn next_other(&mut self) -> Option<Result<Command<'a>, StreamError>> {
        let first = *self.words.get(self.at)?;
        let at = self.at;
        let command = self.command(first);
        if let Ok(Command::Draw { opcode: Opcode::Triangle, vertex, vertices, .. }) = command {
            self.last = Some(Triangle { first, vertex, words: vertices.len() as u32 });
        }
        Some(command.map_err(|kind| {
            self.at = self.words.len();
            StreamError { at, kind }
        }))
    }

    #[inline]
    fn command(&mut self, first: u32) -> Result<Command<'a>, StreamErrorKind> {
        if let Some(register) = Register::from_word(first) {
            let value = self.take(1)?[0];
            return Ok(Command::State { register, mask: first >> 16, value });
        }
        let unknown = StreamErrorKind::UnknownCommand(first);
        match first & 0xffff {
            SET_CURRENT_TEXTURE => self.exactly().map(Command::CurrentTexture),
            TEXTURE_PALETTE => self.exactly().map(Command::TexturePalette),
            code => match Opcode::from_code(code) {
                Some(opcode) => self.operation(opcode, first >> 16),
                None => Err(unknown),
            },
        }
    }

    fn exactly<const N: usize>(&mut self) -> Result<&'a [u32; N], StreamErrorKind> {
        let body = self.take(N as u64)?;
        Ok(body.try_into().expect("N words were taken"))
    }

    #[inline]
    fn operation(&mut self, opcode: Opcode, flags: u32) -> Result<Command<'a>, StreamErrorKind> {
        match opcode {
            Opcode::Triangle => self.draw(opcode, flags, 0, 3),
            Opcode::Line | Opcode::AALine | Opcode::AAEdge | Opcode::Span => {
                self.draw(opcode, flags, 0, 2)
            }
            Opcode::Dot => self.draw(opcode, flags, 0, 1),
            Opcode::Square => self.draw(opcode, flags, 1, 1),
            Opcode::Rectangle => self.draw(opcode, flags, 2, 1),
            Opcode::Polyline => {
                let segments = self.counted(1)?;
                self.draw(opcode, flags, 1, segments + 1)
            }
            Opcode::Tristrip => {
                let triangles = self.counted(1)?;
                self.draw(opcode, flags, 1, triangles + 2)
            }
            Opcode::Trifan => {
                let vertices = self.counted(3)?;
                self.draw(opcode, flags, 1, vertices)
            }
            _ => self.other(opcode, flags),
        }
    }

    /// The count after the first word, at least `least`.
    fn counted(&self, least: u32) -> Result<u64, StreamErrorKind> {
        match self.peek(1)? {
            count if count < least => Err(StreamErrorKind::Count(count)),
            count => Ok(u64::from(count)),
        }
    }

    #[inline]
    fn draw(
        &mut self,
        opcode: Opcode,
        flags: u32,
        head: usize,
        vertices: u64,
    ) -> Result<Command<'a>, StreamErrorKind> {
        let vertex = VertexType::from_code(flags);
        let known = |v: &VertexType| !v.is_specular() || self.chip.has_specular();
        let Some(vertex) = vertex.filter(known) else {
            return Err(StreamErrorKind::UnknownVertexType(flags));
        };
        let body = self.take(head as u64 + vertices * vertex.words() as u64)?;
        let (head, vertices) = body.split_at(head);
        Ok(Command::Draw { opcode, vertex, head, vertices })
    }

    fn other(&mut self, opcode: Opcode, flags: u32) -> Result<Command<'a>, StreamErrorKind> {
        if matches!(opcode, Opcode::FtriKsxyz | Opcode::FtriKsxyzuvq) && !self.chip.has_specular() {
            return Err(StreamErrorKind::UnknownCommand(opcode as u32));
        }
        let words = self.other_words(opcode)?;
        let words = self.take(words)?;
        Ok(Command::Other { opcode, flags, words })
    }

    /// Words after the first of a command without vertices.
    fn other_words(&self, opcode: Opcode) -> Result<u64, StreamErrorKind> {
        let word = |index: usize| self.peek(index).map(u64::from);
        let size = |index: usize| self.peek(index).map(|w| [w >> 16, w & 0xffff].map(u64::from));
        Ok(match opcode {
            Opcode::ContextInit
            | Opcode::WaitDisplaySwitch
            | Opcode::SyncAndRespond
            | Opcode::RleHack
            | Opcode::TimerFuncs => 0,
            Opcode::Display => 1,
            Opcode::StereoDisplay | Opcode::IntLine | Opcode::Bitfill | Opcode::FrameMarker => 2,
            Opcode::Bitblt => 3,
            Opcode::MemClearRect => 5,
            Opcode::TriFill => 6,
            Opcode::Affine => 10,
            Opcode::MemWrite => 2 + word(2)?.div_ceil(4),
            Opcode::MemWriteRect => 4 + word(3)?.div_ceil(4) * word(4)?,
            Opcode::MemWriteSprite => 2 + self.sprite_words()?,
            Opcode::IntPolyline => 2 + self.counted(1)?,
            Opcode::Warp => {
                let [width, height] = size(2)?;
                4 + 2 * width * height
            }
            Opcode::Palette => 2 + word(2)?,
            Opcode::CompositeRect => {
                let [width, height] = size(3)?;
                let format = self.peek(1)?;
                7 + padded_row(format, width) * height
            }
            Opcode::Particles => 1 + 4 * word(1)?,
            Opcode::BitbltMem => {
                let [row, height] = size(2)?;
                3 + row * height
            }
            Opcode::Lookup => {
                let [width, height] = size(2)?;
                2 + width.div_ceil(4) * height
            }
            Opcode::FtriKxyz => 12,
            Opcode::FtriKxyzuvq => 21,
            Opcode::FtriKfxyzuvq | Opcode::FtriKsxyzuvq => 24,
            Opcode::FtriKsxyz => 15,
            _ => return Err(StreamErrorKind::UnknownCommand(opcode as u32)),
        })
    }

    /// Words of a sprite's records, the closing one included.
    fn sprite_words(&self) -> Result<u64, StreamErrorKind> {
        let mut words = 0;
        loop {
            let header = self.peek(3 + words)?;
            words += 1;
            if header == 0 {
                return Ok(words as u64);
            }
            words += (header & 0xffff).div_ceil(4) as usize;
        }
    }
}

/// Words of a row of `width` pixels, padded; formats that are none have no
/// pixels.
pub(crate) fn padded_row(format: u32, width: u64) -> u64 {
    let bits = crate::format::PixFmt::from_code(format).map_or(0, |format| format.bits());
    (width * u64::from(bits)).div_ceil(32)
}

impl<'a> Iterator for Commands<'a> {
    type Item = Result<Command<'a>, StreamError>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        match self.next_alike() {
            Some((vertex, vertices)) => {
                let (opcode, head) = (Opcode::Triangle, &[][..]);
                Some(Ok(Command::Draw { opcode, vertex, head, vertices }))
            }
            None => self.next_other(),
        }
    }
}

/// Checks that `words` are whole commands that `chip` knows.
///
/// # Errors
/// The first error.
pub fn validate(words: &[u32], chip: Chip) -> Result<(), StreamError> {
    Commands::new(words, chip).try_for_each(|command| command.map(|_| ()))
}

impl std::fmt::Display for Command<'_> {
    /// In one line: names, counts, the first words in hexadecimal.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Command::State { register, mask: 0, value } => {
                write!(f, "{} {value:#x}", register.name())
            }
            Command::State { register, mask, value } => {
                write!(f, "{} {value:#x} of {mask:#x}", register.name())
            }
            Command::CurrentTexture(words) => show_words(f, "V_FIFO_SET_CURRENT_TEXTURE", *words),
            Command::TexturePalette(words) => show_words(f, "V_FIFO_TEX4PAL", *words),
            Command::Draw { opcode, vertex, head, vertices } => {
                write!(f, "{} {}", opcode.name(), vertex.name())?;
                show_words(f, "", head)?;
                vertices.chunks(vertex.words()).take(4).try_for_each(|vertex| {
                    f.write_str(" (")?;
                    for (i, word) in vertex.iter().enumerate() {
                        write!(f, "{}{word:#x}", if i == 0 { "" } else { " " })?;
                    }
                    f.write_str(")")
                })
            }
            Command::Other { opcode, flags, words } => {
                write!(f, "{} flags {flags:#x}", opcode.name())?;
                show_words(f, "", words)
            }
        }
    }
}

/// Words that are shown before the rest is only counted.
const SHOWN_WORDS: usize = 12;

fn show_words(f: &mut std::fmt::Formatter<'_>, name: &str, words: &[u32]) -> std::fmt::Result {
    f.write_str(name)?;
    for word in words.iter().take(SHOWN_WORDS) {
        write!(f, " {word:#x}")?;
    }
    match words.len().saturating_sub(SHOWN_WORDS) {
        0 => Ok(()),
        more => write!(f, " and {more} more words"),
    }
}

/// How many commands switch the display.
///
/// # Errors
/// What is wrong with the first wrong command.
pub fn switches(words: &[u32], chip: Chip) -> Result<u32, StreamError> {
    let mut count = 0;
    for command in Commands::new(words, chip) {
        count += u32::from(command?.is_switch());
    }
    Ok(count)
}

/// A valid stream in parts that show one frame each: every part but the first
/// begins with the command that switches the display.
pub fn frames(words: &[u32], chip: Chip) -> Vec<&[u32]> {
    let mut commands = Commands::new(words, chip);
    let (mut parts, mut from, mut switched) = (Vec::new(), 0, false);
    let mut at = 0;
    while let Some(Ok(command)) = commands.next() {
        if command.is_switch() {
            if switched {
                parts.push(&words[from..at]);
                from = at;
            }
            switched = true;
        }
        at = commands.position();
    }
    parts.push(&words[from..]);
    parts
}
