//! Where in the command stream a host is, told from its records alone.
//!
//! A device knows this too, but on the grid the knowledge is spread over tiles that lag behind.

use crate::error::StreamError;
use crate::opcode::Opcode;
use crate::protocol::Record;

/// A command whose words are not all there.
type Open = Option<(Opcode, u32)>;

/// What the next word of the stream is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// An opcode in command mode.
    Command,
    /// One of the last parameters of a command in command mode, so many.
    Params(Opcode, u32),
    /// One of the last words of a command's block, so many.
    Data(Opcode, u32),
    /// A word of a scene, with so many left in its block.
    Scene { block: u32, open: Open, ended: bool },
    /// Of no use: the device is halted.
    Halted,
}

/// What the last record announced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Expect {
    Word,
    Count,
    Text,
}

/// Follows the records of a host.
#[derive(Clone, Debug)]
pub struct Follower {
    place: Place,
    expect: Expect,
    words: u64,
    beyond: bool,
}

impl Follower {
    /// At the start of a stream; `beyond` says whether commands beyond the thesis are known.
    pub fn new(beyond: bool) -> Self {
        Self { place: Place::Command, expect: Expect::Word, words: 0, beyond }
    }

    /// Takes the next record.
    pub fn record(&mut self, record: Record) {
        match (std::mem::replace(&mut self.expect, Expect::Word), record) {
            (Expect::Word, Record::Data(word)) => {
                self.words += 1;
                self.place = self.after(word);
            }
            (Expect::Word, Record::Read) => self.expect = Expect::Count,
            (Expect::Word, Record::Debug) => self.expect = Expect::Text,
            (Expect::Word, Record::AsyncReset) => self.place = Place::Command,
            (Expect::Word, Record::Halt) => self.place = Place::Halted,
            _ => {}
        }
    }

    /// What is missing if the stream ends here.
    pub fn unfinished(&self) -> Option<StreamError> {
        let offset = self.words;
        match self.place {
            Place::Command | Place::Halted => None,
            Place::Params(op, missing)
            | Place::Data(op, missing)
            | Place::Scene { open: Some((op, missing)), .. } => {
                Some(StreamError::Unfinished { command: op.name(), missing, offset })
            }
            Place::Scene { .. } => Some(StreamError::OpenScene { offset }),
        }
    }

    fn after(&self, word: u32) -> Place {
        let known = |op: &Opcode| self.beyond || !op.is_beyond();
        match self.place {
            Place::Command => {
                Opcode::in_command_mode(word).filter(known).map_or(Place::Command, begin)
            }
            // The length of a block is the last parameter of its command.
            Place::Params(op, 1) if op.data_length_at().is_some() => data(op, word),
            Place::Params(op, left) => params(op, left - 1),
            Place::Data(op, left) => data(op, left - 1),
            Place::Scene { block: 0, ended: true, .. } if word == 0 => Place::Command,
            Place::Scene { block: 0, open, ended } => {
                Place::Scene { block: word, open: open.filter(|_| word > 0), ended }
            }
            Place::Scene { block, open: Some((op, left)), ended } => {
                Place::Scene { block: block - 1, open: rest(op, left - 1), ended }
            }
            Place::Scene { block, open: None, ended } => {
                let op = Opcode::in_scene_mode(word).filter(known);
                let open = op.and_then(|op| rest(op, op.inputs() as u32));
                Place::Scene {
                    block: block - 1,
                    open,
                    ended: ended || op == Some(Opcode::EndScene),
                }
            }
            Place::Halted => Place::Halted,
        }
    }
}

/// Behind the opcode of a command in command mode.
fn begin(op: Opcode) -> Place {
    match op {
        Opcode::BeginScene => Place::Scene { block: 0, open: None, ended: false },
        Opcode::Halt => Place::Halted,
        _ => params(op, op.inputs() as u32),
    }
}

fn params(op: Opcode, left: u32) -> Place {
    if left > 0 { Place::Params(op, left) } else { Place::Command }
}

fn data(op: Opcode, left: u32) -> Place {
    if left > 0 { Place::Data(op, left) } else { Place::Command }
}

fn rest(op: Opcode, left: u32) -> Open {
    (left > 0).then_some((op, left))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn end(records: impl IntoIterator<Item = Record>) -> Option<StreamError> {
        let mut follower = Follower::new(true);
        records.into_iter().for_each(|record| follower.record(record));
        follower.unfinished()
    }

    fn words(words: &[u32]) -> Option<StreamError> {
        end(words.iter().map(|word| Record::Data(*word)))
    }

    #[test]
    fn whole_streams_are_finished() {
        assert_eq!(words(&[]), None);
        assert_eq!(words(&[30, 99, 35, 0, 2, 30, 30, 29, 3, 0]), None);
        assert_eq!(words(&[39, 0, 0, 1, 0]), None);
        assert_eq!(words(&[1, 2, 4, 7, 0, 1, 2, 0, 30]), None);
        assert_eq!(words(&[1, 6, 3, 0, 0, 0, 0, 0, 0, 1, 2, 0]), None);
        assert_eq!(words(&[47, 35, 0]), None);
        let read = [Record::Data(36), Record::Read, Record::Data(1)];
        assert_eq!(end(read), None);
    }

    #[test]
    fn what_is_missing_is_counted() {
        let inside =
            |command, missing, offset| Some(StreamError::Unfinished { command, missing, offset });
        assert_eq!(words(&[29, 3]), inside("RENDER_CLEARFB", 1, 2));
        assert_eq!(words(&[35, 0, 5, 1, 1]), inside("RENDER_UPLOAD_TEXTURE", 3, 5));
        assert_eq!(words(&[1, 6, 3, 0]), inside("RENDER_VERTEX", 4, 4));
        // Blocks may end anywhere; only a marker ends a command early.
        assert_eq!(words(&[1, 2, 3, 0]), inside("RENDER_VERTEX", 4, 4));
        assert_eq!(words(&[1, 2, 3, 0, 0]), Some(StreamError::OpenScene { offset: 5 }));
        assert_eq!(words(&[1, 1, 2]), Some(StreamError::OpenScene { offset: 3 }));
        let reset = [1, 6, 3].map(Record::Data).into_iter().chain([Record::AsyncReset]);
        assert_eq!(end(reset), None);
    }
}
