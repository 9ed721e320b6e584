//! Run-length coding: of 565 pictures, and of the 8-bit sprites that
//! `ConvertAndDownloadRle` takes.
//!
//! Source: G246, `guEncodeRLE16`, `ConvertAndDownloadRle`.

/// The longest run of a word.
const MAX_RUN: usize = 0xffff;

/// Codes a picture: a word for each run, its length in the high half, its
/// colour in the low one.
///
/// The original counts one pixel too many after each run, and lets bright
/// colours spill into the length; nothing decodes that, so neither is done.
pub fn encode_rle16(pixels: impl IntoIterator<Item = u16>) -> Vec<u32> {
    let mut runs: Vec<u32> = Vec::new();
    for pixel in pixels {
        match runs.last_mut() {
            Some(run) if *run as u16 == pixel && (*run >> 16) as usize != MAX_RUN => {
                *run += 1 << 16
            }
            _ => runs.push(1 << 16 | u32::from(pixel)),
        }
    }
    runs
}

/// Bytes of a sprite before its row lengths.
const SPRITE_HEADER: usize = 4;

/// The three bits that mark a run; the others are its length.
const RUN: u8 = 0xe0;

/// A run-length coded sprite of 8-bit pixels: four bytes that are not used, a
/// byte with the length of each row, the rows. In a row, a byte below 0xe0 is a
/// pixel; one from there on says in its low five bits how often the byte after
/// it is repeated, or ends the row with 0.
#[derive(Clone, Copy, Debug)]
pub struct Sprite<'a> {
    bytes: &'a [u8],
    rows: usize,
}

impl<'a> Sprite<'a> {
    /// A sprite of that many rows.
    pub fn new(bytes: &'a [u8], rows: usize) -> Sprite<'a> {
        Sprite { bytes, rows }
    }

    /// Bytes of a sprite, from its header and row lengths.
    pub fn size(lengths: &[u8]) -> usize {
        SPRITE_HEADER + lengths.len() + lengths.iter().map(|&n| usize::from(n)).sum::<usize>()
    }

    /// Bytes in front of the rows of a sprite with that many.
    pub fn lengths_at() -> usize {
        SPRITE_HEADER
    }

    fn lengths(&self) -> &'a [u8] {
        self.bytes.get(SPRITE_HEADER..SPRITE_HEADER + self.rows).unwrap_or_default()
    }

    /// The coded bytes of a row; `None` past the last one.
    fn coded(&self, row: usize) -> Option<&'a [u8]> {
        let lengths = self.lengths();
        let length = usize::from(*lengths.get(row)?);
        let before: usize = lengths[..row].iter().map(|&n| usize::from(n)).sum();
        let start = SPRITE_HEADER + self.rows + before;
        self.bytes.get(start..(start + length).min(self.bytes.len()))
    }

    /// Decodes a row over `line`, which keeps what the row does not reach.
    /// False past the last row.
    pub fn decode(&self, row: usize, line: &mut [u8]) -> bool {
        let Some(coded) = self.coded(row) else { return false };
        let (mut codes, mut at) = (coded.iter().copied(), 0);
        while let Some(code) = codes.next() {
            let (pixel, count) = if code & RUN != RUN {
                (code, 1)
            } else {
                match (code & !RUN, codes.next()) {
                    (0, _) | (_, None) => break,
                    (count, Some(pixel)) => (pixel, usize::from(count)),
                }
            };
            let Some(rest) = line.get_mut(at..) else { break };
            rest.iter_mut().take(count).for_each(|to| *to = pixel);
            at += count;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_565() {
        let coded = encode_rle16([1, 1, 1, 0xffff, 0, 0]);
        assert_eq!(coded, [3 << 16 | 1, 1 << 16 | 0xffff, 2 << 16]);
        assert_eq!(encode_rle16([]), [0u32; 0]);
        let long = encode_rle16(std::iter::repeat_n(0x8000, 0x1_0001));
        assert_eq!(long, [0xffff_8000, 2 << 16 | 0x8000]);
    }

    #[test]
    fn runs_decode_to_the_picture() {
        let pixels: Vec<u16> = (0..1000).map(|i: u32| (i * i / 700) as u16 | 0xf000).collect();
        let decoded: Vec<u16> = encode_rle16(pixels.iter().copied())
            .into_iter()
            .flat_map(|run| std::iter::repeat_n(run as u16, (run >> 16) as usize))
            .collect();
        assert_eq!(decoded, pixels);
    }

    #[test]
    fn sprites() {
        let bytes = [0, 0, 0, 0, 4, 3, 0xe3, 7, 9, 0xe0, 0xdf, 0xe1, 0xff];
        assert_eq!(Sprite::size(&bytes[4..6]), bytes.len());
        let sprite = Sprite::new(&bytes, 2);
        let mut line = [0; 6];
        assert!(sprite.decode(0, &mut line));
        assert_eq!(line, [7, 7, 7, 9, 0, 0]);
        assert!(sprite.decode(1, &mut line));
        assert_eq!(line, [0xdf, 0xff, 7, 9, 0, 0]);
        assert!(!sprite.decode(2, &mut line));
    }

    #[test]
    fn damaged_sprites_end() {
        for bytes in [&[][..], &[0; 4], &[0, 0, 0, 0, 255], &[0, 0, 0, 0, 1, 0xff]] {
            let mut line = [0; 3];
            Sprite::new(bytes, 1).decode(0, &mut line);
            Sprite::new(bytes, usize::MAX / 2).decode(7, &mut line);
        }
    }
}
