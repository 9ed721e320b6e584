//! A second writer of commands, straight from the document's tables: what a
//! program does that writes words itself.

/// Appends the words of commands.
#[derive(Default)]
pub struct Words(pub Vec<u32>);

impl Words {
    /// The state's word and its value.
    pub fn state(&mut self, word: u32, value: u32) {
        self.0.extend([word, value]);
    }

    /// A primitive: type and opcode, words before the vertices, the vertices.
    pub fn primitive(&mut self, vertex: u32, opcode: u32, head: &[u32], vertices: &[u32]) {
        self.0.push(vertex << 16 | opcode);
        self.0.extend(head);
        self.0.extend(vertices);
    }

    /// Any other command.
    pub fn command(&mut self, first: u32, words: &[u32]) {
        self.0.push(first);
        self.0.extend(words);
    }
}
