//! Textures: decoded once, immutable, shared by reference.

use crate::error::EngineError;

/// The most levels of a texture: sides of 2048 down to 1.
pub const MAX_LEVELS: usize = 12;

/// The shape of a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureDesc {
    /// log2 of the width of level 0, 0..=11. Level n is half as wide as level
    /// n - 1, at least one texel.
    pub s_bits: u8,
    /// log2 of the height of level 0, 0..=11.
    pub t_bits: u8,
    /// The finest level that holds texels.
    pub first: u8,
    /// The coarsest one. A level outside is replaced by the nearest inside.
    pub last: u8,
    /// Whether the right neighbour of the last column is itself (clamp), or
    /// the first column (repeat). Must agree with
    /// [`crate::state::TextureUnit::clamp_s`].
    pub clamp_s: bool,
}

/// One level as the sampler addresses it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Level {
    /// Index of the level's first entry.
    pub base: u32,
    /// Entries from one row to the next.
    pub pitch: u32,
    /// Width - 1.
    pub s_mask: u32,
    /// Height - 1.
    pub t_mask: u32,
    /// Bits to shift a level-0 coordinate right by.
    pub shift: u32,
}

/// Extra entries at the end of each row, so that rows of neighbouring lines do
/// not fall onto the same cache set.
const ROW_PAD: u32 = 8;

/// Decoded texels of all levels.
///
/// An entry is 64 bits: the texel and its right neighbour, ordered for the
/// byte dot product: r0 r1 b0 b1 g0 g1 a0 a1, r0 lowest.
#[derive(Clone, Debug)]
pub struct Texture {
    desc: TextureDesc,
    levels: [Level; MAX_LEVELS],
    entries: Vec<u64>,
    /// What lies around every level, 0xAARRGGBB.
    border: Option<u32>,
    /// Which texels are keyed, in the same places: [`KEYED`] or 0.
    keys: Vec<u64>,
}

/// The mark of a keyed texel: 64 or more of it is left of a sample half of whose
/// weight or more is keyed.
const KEYED: u32 = 0x80_0000;

impl Texture {
    /// Builds a texture; `texels(level, out)` appends the level's texels as
    /// 0xAARRGGBB, row by row.
    ///
    /// # Errors
    /// [`EngineError::TextureShape`] for a side above 2048 or `first > last`,
    /// [`EngineError::TextureData`] where a level has the wrong texel count.
    pub fn build(
        desc: TextureDesc,
        texels: impl FnMut(u8, &mut Vec<u32>),
    ) -> Result<Texture, EngineError> {
        Texture::build_with(desc, None, texels)
    }

    /// As [`Texture::build`], with one texel of a colour, 0xAARRGGBB, around
    /// every level. Where a unit clamps, coordinates go from one side of the
    /// level to the other, and the filter's neighbours outside are the border: a
    /// filtered sample at a side is half of it. Single texels are always inside.
    /// A unit that repeats, or repeats along one axis, has no border there.
    ///
    /// # Errors
    /// Those of [`Texture::build`].
    pub fn build_bordered(
        desc: TextureDesc,
        border: u32,
        texels: impl FnMut(u8, &mut Vec<u32>),
    ) -> Result<Texture, EngineError> {
        Texture::build_with(desc, Some(border), texels)
    }

    fn build_with(
        desc: TextureDesc,
        border: Option<u32>,
        mut texels: impl FnMut(u8, &mut Vec<u32>),
    ) -> Result<Texture, EngineError> {
        if usize::from(desc.s_bits.max(desc.t_bits)) >= MAX_LEVELS {
            return Err(EngineError::TextureShape("a side is above 2048"));
        }
        if desc.first > desc.last || usize::from(desc.last) >= MAX_LEVELS {
            return Err(EngineError::TextureShape("levels are out of range"));
        }
        let levels = [Level::default(); MAX_LEVELS];
        let mut texture = Texture { desc, levels, entries: vec![], border, keys: vec![] };
        let mut data = Vec::new();
        for number in desc.first..=desc.last {
            data.clear();
            texels(number, &mut data);
            texture.push_level(number, &data)?;
        }
        for number in 0..MAX_LEVELS as u8 {
            let nearest = number.clamp(desc.first, desc.last);
            texture.levels[usize::from(number)] = texture.levels[usize::from(nearest)];
        }
        Ok(texture)
    }

    fn push_level(&mut self, number: u8, data: &[u32]) -> Result<(), EngineError> {
        let width = 1u32 << self.desc.s_bits.saturating_sub(number);
        let height = 1u32 << self.desc.t_bits.saturating_sub(number);
        if data.len() != (width * height) as usize {
            return Err(EngineError::TextureData { width, height, given: data.len() });
        }
        let pitch = width + ROW_PAD;
        if let Some(border) = self.border {
            // The row above, with the texel before it and the one before the next.
            self.entries.resize(self.entries.len() + pitch as usize + 1, pair(border, border));
        }
        self.levels[usize::from(number)] = Level {
            base: self.entries.len() as u32,
            pitch,
            s_mask: width - 1,
            t_mask: height - 1,
            shift: u32::from(number),
        };
        for row in data.chunks_exact(width as usize) {
            let after_last = match self.border {
                Some(border) if self.desc.clamp_s => border,
                _ if self.desc.clamp_s => row[row.len() - 1],
                _ => row[0],
            };
            if let (Some(border), Some(before)) = (self.border, self.entries.last_mut()) {
                *before = pair(border, row[0]);
            }
            let right = row[1..].iter().copied().chain([after_last]);
            self.entries.extend(row.iter().zip(right).map(|(&texel, right)| pair(texel, right)));
            let pad = self.border.map_or(0, |border| pair(border, border));
            self.entries.extend([pad; ROW_PAD as usize]);
        }
        if let Some(border) = self.border {
            self.entries.resize(self.entries.len() + pitch as usize, pair(border, border));
        }
        Ok(())
    }

    /// The same texels, some of which a draw state may drop: see
    /// [`crate::state::TextureUnit::drop_keyed`]. `is_keyed` is asked for every
    /// level, column and row. What keyed texels look like still counts in
    /// filtered samples that are not dropped. A border is not keyed.
    pub fn with_key(mut self, mut is_keyed: impl FnMut(u8, u32, u32) -> bool) -> Texture {
        self.keys = vec![0; self.entries.len()];
        for number in self.desc.first..=self.desc.last {
            let Level { base, pitch, s_mask, t_mask, .. } = self.levels[usize::from(number)];
            for row in 0..=t_mask {
                let keyed: Vec<u32> = (0..=s_mask)
                    .map(|column| if is_keyed(number, column, row) { KEYED } else { 0 })
                    .collect();
                let after_last = match (self.desc.clamp_s, self.border) {
                    (true, Some(_)) => 0,
                    (true, None) => keyed[s_mask as usize],
                    (false, _) => keyed[0],
                };
                let rights = keyed[1..].iter().chain([&after_last]);
                let first = (base + row * pitch) as usize;
                if self.border.is_some() {
                    self.keys[first - 1] = pair(0, keyed[0]);
                }
                for ((entry, &key), &right) in self.keys[first..].iter_mut().zip(&keyed).zip(rights)
                {
                    *entry = pair(key, right);
                }
            }
        }
        self
    }

    /// Whether a texel is keyed.
    pub fn is_keyed(&self, number: usize, column: u32, row: u32) -> bool {
        let level = self.level(number);
        let at = (level.base + row * level.pitch + column) as usize;
        self.keys.get(at).is_some_and(|entry| entry & 0xff != 0)
    }

    /// The entries of the texels' keys, in the places of the texels; empty where
    /// none is keyed.
    pub(crate) fn keys(&self) -> &[u64] {
        &self.keys
    }

    /// The colour around every level, 0xAARRGGBB, where there is one.
    pub fn border(&self) -> Option<u32> {
        self.border
    }

    /// The shape it was built with.
    pub fn desc(&self) -> TextureDesc {
        self.desc
    }

    /// Level `number`, or the nearest that holds texels.
    pub fn level(&self, number: usize) -> &Level {
        &self.levels[number.min(MAX_LEVELS - 1)]
    }

    /// All levels' entries.
    pub fn entries(&self) -> &[u64] {
        &self.entries
    }

    /// The texel at a level's column and row, both inside, as 0xAARRGGBB.
    pub fn texel(&self, number: usize, column: u32, row: u32) -> u32 {
        let level = self.level(number);
        let entry = self.entries[(level.base + row * level.pitch + column) as usize];
        let byte = |at: u32| (entry >> (at * 8)) as u32 & 0xff;
        byte(6) << 24 | byte(0) << 16 | byte(4) << 8 | byte(2)
    }
}

/// A texel and its right neighbour as one entry.
fn pair(texel: u32, right: u32) -> u64 {
    let channel = |c: u32, shift: u32| u64::from(c >> shift & 0xff);
    let both = |shift: u32| channel(texel, shift) | channel(right, shift) << 8;
    both(16) | both(0) << 16 | both(8) << 32 | both(24) << 48
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_hold_the_right_neighbour() {
        let desc = TextureDesc { s_bits: 1, t_bits: 0, first: 0, last: 1, clamp_s: false };
        let texture = Texture::build(desc, |level, out| match level {
            0 => out.extend([0x1122_3344, 0x5566_7788]),
            _ => out.push(0xffff_ffff),
        })
        .unwrap();
        assert_eq!(texture.texel(0, 0, 0), 0x1122_3344);
        assert_eq!(texture.texel(0, 1, 0), 0x5566_7788);
        assert_eq!(texture.texel(7, 0, 0), 0xffff_ffff);
        assert_eq!(texture.entries()[0], 0x5511_7733_8844_6622);
        assert_eq!(texture.entries()[1], 0x1155_3377_4488_2266);
    }

    #[test]
    fn borders_surround_every_level() {
        let desc = TextureDesc { s_bits: 1, t_bits: 1, first: 0, last: 1, clamp_s: true };
        let texture = Texture::build_bordered(desc, 0xff00_00ff, |level, out| {
            out.extend(if level == 0 { vec![1, 2, 3, 4] } else { vec![5] });
        })
        .unwrap()
        .with_key(|level, column, row| (level, column, row) == (0, 0, 1));
        for (number, first, last) in [(0, [1, 3], [2, 4]), (1, [5, 5], [5, 5])] {
            let level = texture.level(number);
            let at = |column: i32, row: i32| {
                let start = level.base as i32 + row * level.pitch as i32;
                (start + column) as usize
            };
            let height = level.t_mask as i32 + 1;
            for row in 0..height {
                let (left, right) = (at(-1, row), at(level.s_mask as i32, row));
                assert_eq!(texture.entries()[left], pair(0xff00_00ff, first[row as usize]));
                assert_eq!(texture.entries()[right], pair(last[row as usize], 0xff00_00ff));
            }
            for column in -1..=level.s_mask as i32 {
                for row in [-1, height] {
                    assert_eq!(texture.entries()[at(column, row)], pair(0xff00_00ff, 0xff00_00ff));
                }
            }
        }
        let level = texture.level(0);
        let keys = &texture.keys()[(level.base + level.pitch) as usize - 1..][..3];
        assert_eq!(keys, [pair(0, KEYED), pair(KEYED, 0), 0]);
    }

    #[test]
    fn wrong_sizes_are_errors() {
        let desc = TextureDesc { s_bits: 2, t_bits: 2, first: 0, last: 0, clamp_s: true };
        assert!(matches!(
            Texture::build(desc, |_, out| out.push(0)),
            Err(EngineError::TextureData { width: 4, height: 4, given: 1 })
        ));
        assert!(Texture::build(TextureDesc { s_bits: 12, ..desc }, |_, _| {}).is_err());
    }
}
