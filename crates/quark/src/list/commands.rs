//! Commands: triangles gathered by state.

use super::{Command, TriangleList};
use crate::error::ErrorCode;
use crate::math::{convert_uv, def_u_normal};

impl TriangleList {
    /// Gathers triangles by state and makes the commands that draw them.
    ///
    /// `state_of` is the number of each triangle's state; missing ones are 0.
    /// Triangles without area, with the same corner twice, or with a corner
    /// outside the list are removed. The order of triangles with the same
    /// state stays. Texture coordinates of triangles lose the repeats they
    /// have in common.
    ///
    /// Source: QK, `BuildCmdList`.
    pub fn build_commands(&mut self, state_of: &[u16]) {
        let stride = self.layout.index_stride;
        let state = |i: usize| state_of.get(i).copied().unwrap_or(0);
        let mut kept: Vec<(u16, usize)> = (0..self.triangle_count())
            .filter(|&i| !self.is_flat(i))
            .map(|i| (state(i), i))
            .collect();
        kept.sort_by_key(|&(state, _)| state);
        let mut indices = Vec::with_capacity(kept.len() * stride);
        for &(_, i) in &kept {
            indices.extend_from_slice(&self.indices[i * stride..][..stride]);
        }
        self.indices = indices;
        self.convert_face_uv();
        self.commands = commands(&kept);
    }

    /// Replaces the commands, as a program does that builds its own.
    ///
    /// # Errors
    /// [`ErrorCode::Memory`] for more than 65,535 commands.
    pub fn set_commands(&mut self, commands: Vec<Command>) -> Result<(), ErrorCode> {
        if commands.len() > super::MAX_COUNT {
            return Err(ErrorCode::Memory);
        }
        self.commands = commands;
        Ok(())
    }

    fn is_flat(&self, index: usize) -> bool {
        let abc = self.abc(index).map(usize::from);
        if abc.iter().any(|&corner| corner >= self.vertex_count()) {
            return true;
        }
        let [a, b, c] = abc.map(|corner| self.xyz(corner).map(i32::from));
        def_u_normal(&a, &b, &c) == [0; 3]
    }

    fn convert_face_uv(&mut self) {
        let at = self.layout.index_uv;
        if at == 0 {
            return;
        }
        for triangle in self.indices.chunks_exact_mut(self.layout.index_stride) {
            let mut uv: [i16; 6] = std::array::from_fn(|i| triangle[at + i] as i16);
            convert_uv(&mut uv);
            triangle[at..at + 6].iter_mut().zip(uv).for_each(|(to, n)| *to = n as u16);
        }
    }
}

/// One command for each run of equal states; one of no triangles for none.
fn commands(kept: &[(u16, usize)]) -> Vec<Command> {
    let runs = kept.chunk_by(|a, b| a.0 == b.0);
    let mut commands: Vec<Command> =
        runs.map(|run| Command { count: run.len() as u16, state: run[0].0 }).collect();
    if commands.is_empty() {
        commands.push(Command::default());
    }
    commands
}
