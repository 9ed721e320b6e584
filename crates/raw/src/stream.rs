//! Scene-streaming: blocks of words, commands inside them, primitives between zero counts.
//!
//! Source: RAW, section 4.1 (stream framing) and the stage-1 listing.

use crate::errata::Errata;
use crate::error::StreamError;
use crate::opcode::Opcode;
use crate::stage::{InputVertex, assembly};
use crate::state::RenderState;

/// What a word completed.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneEvent {
    /// Nothing yet.
    More,
    /// A state command; the state has been changed.
    State(Opcode),
    /// A vertex, latched with the current colour and normal.
    Vertex,
    /// The end of a primitive with enough vertices for its kind.
    Primitive(Vec<InputVertex>),
    /// The end of a primitive with fewer vertices: nothing is drawn.
    Empty,
    /// The end of the scene.
    EndScene,
    /// A fault; reading goes on behind it.
    Fault(StreamError),
}

/// Reads a scene stream word by word.
#[derive(Clone, Debug, Default)]
pub struct SceneReader {
    /// Words left in the current block; 0 when the next word is a count.
    left: u32,
    command: Option<Opcode>,
    params: Vec<u32>,
    vertices: Vec<InputVertex>,
    ended: bool,
}

/// Vertices of one primitive; later ones are ignored.
pub const MAX_VERTICES: usize = 4096;

impl SceneReader {
    /// Whether the next word is the count of a block.
    pub fn expects_count(&self) -> bool {
        self.left == 0
    }

    /// The parameters of the state command just reported.
    pub fn last_params(&self) -> &[u32] {
        &self.params
    }

    /// Consumes one word; state commands are carried out on `state`.
    ///
    /// `offset` is the word's place in the stream, for messages.
    pub fn push(
        &mut self,
        word: u32,
        offset: u64,
        state: &mut RenderState,
        errata: &Errata,
    ) -> SceneEvent {
        if self.left == 0 {
            return self.count_word(word, offset, state, errata);
        }
        self.left -= 1;
        let Some(op) = self.command else { return self.opcode(word, offset, state, errata) };
        self.params.push(word);
        if self.params.len() == op.inputs() {
            self.complete(op, state, errata)
        } else {
            SceneEvent::More
        }
    }

    fn count_word(
        &mut self,
        count: u32,
        offset: u64,
        state: &RenderState,
        errata: &Errata,
    ) -> SceneEvent {
        self.left = count;
        if count > 0 {
            return SceneEvent::More;
        }
        let mut vertices = std::mem::take(&mut self.vertices);
        let topology = state.prim.mode.topology();
        let enough = vertices.len() >= assembly::fewest(topology);
        vertices.truncate(assembly::most(topology));
        let ended = std::mem::take(&mut self.ended);
        self.params.clear();
        match self.command.take() {
            Some(op) => SceneEvent::Fault(short_command(op, offset, errata)),
            None if ended => SceneEvent::EndScene,
            None if enough => SceneEvent::Primitive(vertices),
            None => SceneEvent::Empty,
        }
    }

    fn opcode(
        &mut self,
        word: u32,
        offset: u64,
        state: &mut RenderState,
        errata: &Errata,
    ) -> SceneEvent {
        let known = Opcode::in_scene_mode(word).filter(|op| state.allows(*op));
        let Some(op) = known else {
            return SceneEvent::Fault(StreamError::Opcode { word, offset, mode: "scene" });
        };
        self.params.clear();
        if op.inputs() == 0 {
            return self.complete(op, state, errata);
        }
        self.command = Some(op);
        SceneEvent::More
    }

    fn complete(&mut self, op: Opcode, state: &mut RenderState, errata: &Errata) -> SceneEvent {
        self.command = None;
        match op {
            Opcode::EndScene => {
                self.ended = true;
                SceneEvent::More
            }
            Opcode::Vertex => {
                self.add(state.latch(&self.params));
                SceneEvent::Vertex
            }
            Opcode::Index => {
                let stored = state.beyond.stored.get(self.params[0] as usize);
                self.add(stored.copied().unwrap_or_default());
                SceneEvent::Vertex
            }
            _ => {
                state.execute(op, &self.params, errata);
                SceneEvent::State(op)
            }
        }
    }

    fn add(&mut self, vertex: InputVertex) {
        if self.vertices.len() < MAX_VERTICES {
            self.vertices.push(vertex);
        }
    }
}

fn short_command(op: Opcode, offset: u64, errata: &Errata) -> StreamError {
    let command = op.name();
    if errata.zero_count_hangs {
        StreamError::Hung { command, offset }
    } else {
        StreamError::ShortCommand { command, offset }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn feed(words: &[u32]) -> Vec<SceneEvent> {
        let (mut reader, mut state) = (SceneReader::default(), RenderState::default());
        (0..)
            .zip(words)
            .map(|(i, w)| reader.push(*w, i, &mut state, &Errata::CORRECT))
            .filter(|e| *e != SceneEvent::More)
            .collect()
    }

    fn vertex() -> Vec<u32> {
        vec![6, 3, 0, 0, 0, 0, 0]
    }

    #[test]
    fn three_vertices_make_a_primitive_and_a_fourth_is_ignored() {
        for count in [3, 4] {
            let mut words: Vec<u32> = (0..count).flat_map(|_| vertex()).collect();
            words.push(0);
            let events = feed(&words);
            assert!(matches!(events.last(), Some(SceneEvent::Primitive(_))), "{count}");
        }
        assert_eq!(feed(&[vertex(), vec![0]].concat()).last(), Some(&SceneEvent::Empty));
    }

    #[test]
    fn blocks_may_split_anywhere() {
        let events = feed(&[1, 4, 1, 0x1122_3344, 2, 8, 1, 0]);
        let want = [
            SceneEvent::State(Opcode::Color),
            SceneEvent::State(Opcode::SetLit),
            SceneEvent::Empty,
        ];
        assert_eq!(events, want);
    }

    #[test]
    fn marker_inside_a_command_drops_the_primitive() {
        let events = feed(&[2, 3, 0, 0, 1, 2, 0]);
        let fault = StreamError::ShortCommand { command: "RENDER_VERTEX", offset: 3 };
        assert_eq!(events[..], [SceneEvent::Fault(fault), SceneEvent::EndScene][..]);
        let events = feed(&[2, 30, 99]);
        assert_eq!(events.len(), 2);
    }
}
