//! `.3df` texture files.
//!
//! Four lines of text, then big-endian data: a compression table or palette
//! where the format has one, and the levels from the largest to the smallest.
//!
//! ```text
//! 3df v1.1
//! argb1555
//! lod range: 1 256
//! aspect ratio: 1 1
//! ```
//!
//! Source: G246, `gu3dfGetInfo`, `gu3dfLoad`.

use crate::enums::*;
use crate::texture::layout;
use crate::texture_state::TextureInfo;

/// The most bytes of the four lines.
pub const MAX_HEADER: usize = 100;

/// The most bytes of a file.
pub const MAX_FILE: usize = MAX_HEADER + 4 * 256 + 2 * 87381;

/// Format names, in capitals.
const FORMATS: [(&str, i32); 13] = [
    ("I8", 3),
    ("A8", 2),
    ("AI44", 4),
    ("YIQ", TEXFMT_YIQ_422),
    ("RGB332", 0),
    ("RGB565", 0xa),
    ("ARGB8332", 8),
    ("ARGB1555", 0xb),
    ("AYIQ8422", TEXFMT_AYIQ_8422),
    ("ARGB4444", 0xc),
    ("AI88", 0xd),
    ("P8", TEXFMT_P_8),
    ("AP88", TEXFMT_AP_88),
];

/// Why bytes are no `.3df` file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error3df {
    /// The four lines do not have their form, or are too long.
    #[error("the header is not that of a .3df file")]
    Header,
    /// The format's name is unknown.
    #[error("unknown texel format")]
    Format,
    /// Sizes of levels are powers of two from 1 to 256, the smaller one first.
    #[error("the range of levels is impossible")]
    Levels,
    /// Aspect ratios are powers of two up to 8.
    #[error("the aspect ratio is impossible")]
    Aspect,
    /// The data ends too early.
    #[error("the file has {found} bytes of {expected}")]
    Short {
        /// Bytes that the header promises.
        expected: usize,
        /// Bytes there are.
        found: usize,
    },
}

/// What a file's four lines say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Header3df {
    /// Levels, aspect ratio and format.
    pub info: TextureInfo,
    /// Bytes of the four lines.
    pub length: usize,
}

/// A compression table in the form of the files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ncc3df {
    /// Brightness.
    pub y: [u8; 16],
    /// Red, green, blue of each I: nine bits, two's complement.
    pub i: [[i16; 3]; 4],
    /// Red, green, blue of each Q: nine bits, two's complement.
    pub q: [[i16; 3]; 4],
}

impl Ncc3df {
    /// The twelve words that the hardware takes.
    pub fn packed(&self) -> [u32; 12] {
        let mut words = [0; 12];
        for (word, y) in words.iter_mut().zip(self.y.as_chunks::<4>().0) {
            *word = u32::from_le_bytes(*y);
        }
        for (word, rgb) in words[4..].iter_mut().zip(self.i.iter().chain(&self.q)) {
            *word = rgb.iter().fold(0, |word, &part| word << 9 | u32::from(part as u16 & 0x1ff));
        }
        words
    }
}

/// The table that comes with a texture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Table3df {
    /// Colours need none.
    None,
    /// A compression table.
    Ncc(Ncc3df),
    /// 256 colours, 0x00RRGGBB.
    Palette(Vec<u32>),
}

/// A whole file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File3df {
    /// Levels, aspect ratio and format.
    pub info: TextureInfo,
    /// The table of the format.
    pub table: Table3df,
    /// All levels, the largest first; 16-bit texels little endian.
    pub texels: Vec<u8>,
}

impl Header3df {
    /// Reads the four lines at the start of a file.
    ///
    /// # Errors
    /// Every [`Error3df`] but `Short`.
    pub fn parse(bytes: &[u8]) -> Result<Header3df, Error3df> {
        let start = &bytes[..bytes.len().min(MAX_HEADER)];
        let mut ends = (0..start.len()).filter(|&i| start[i] == b'\n');
        let last = ends.nth(3).ok_or(Error3df::Header)?;
        let text = str::from_utf8(&start[..last]).map_err(|_| Error3df::Header)?;
        let words: Vec<&str> = text.split_ascii_whitespace().collect();
        let ["3df", version, format, "lod", "range:", small, large, "aspect", "ratio:", w, h] =
            words[..]
        else {
            return Err(Error3df::Header);
        };
        if !version.starts_with('v') || version.len() < 2 {
            return Err(Error3df::Header);
        }
        let name = format.to_ascii_uppercase();
        let format = FORMATS.iter().find(|(n, _)| *n == name).ok_or(Error3df::Format)?.1;
        let (small_lod, large_lod) = (lod(small)?, lod(large)?);
        let info = TextureInfo { small_lod, large_lod, aspect: aspect(w, h)?, format };
        if !info.is_valid() {
            return Err(Error3df::Levels);
        }
        Ok(Header3df { info, length: last + 1 })
    }

    /// Columns and rows of the largest level.
    pub fn size(&self) -> (u32, u32) {
        layout::size(self.info.aspect, self.info.large_lod as u32)
    }

    /// Bytes of all levels.
    pub fn texel_bytes(&self) -> usize {
        texel_bytes(&self.info)
    }
}

/// The LOD number of a side in texels.
fn lod(side: &str) -> Result<i32, Error3df> {
    match side.parse::<u32>() {
        Ok(side @ 1..=256) if side.is_power_of_two() => Ok(8 - side.ilog2() as i32),
        _ => Err(Error3df::Levels),
    }
}

/// The aspect number of a width and height.
fn aspect(width: &str, height: &str) -> Result<i32, Error3df> {
    let side = |text: &str| text.parse::<u16>().ok().filter(|&side| side > 0);
    let (Some(w), Some(h)) = (side(width), side(height)) else { return Err(Error3df::Aspect) };
    let ratio = w.max(h) / w.min(h);
    if w.max(h) % w.min(h) != 0 || !matches!(ratio, 1 | 2 | 4 | 8) {
        return Err(Error3df::Aspect);
    }
    let steps = ratio.ilog2() as i32;
    Ok(if w > h { 3 - steps } else { 3 + steps })
}

fn texel_bytes(info: &TextureInfo) -> usize {
    let level = |lod: i32| {
        let (width, height) = layout::size(info.aspect, lod as u32);
        (width * height * layout::texel_bytes(info.format)) as usize
    };
    (info.large_lod..=info.small_lod).map(level).sum()
}

fn table_bytes(format: i32) -> usize {
    match format {
        TEXFMT_YIQ_422 | TEXFMT_AYIQ_8422 => 2 * (16 + 12 + 12),
        TEXFMT_P_8 | TEXFMT_AP_88 => 4 * 256,
        _ => 0,
    }
}

impl File3df {
    /// Reads a file; what follows the last level is ignored.
    ///
    /// # Errors
    /// Any [`Error3df`].
    pub fn parse(bytes: &[u8]) -> Result<File3df, Error3df> {
        let header = Header3df::parse(bytes)?;
        let info = header.info;
        let texels_at = header.length + table_bytes(info.format);
        let expected = texels_at + header.texel_bytes();
        let found = bytes.len();
        let whole = bytes.get(..expected).ok_or(Error3df::Short { expected, found })?;
        let table = read_table(info.format, &whole[header.length..texels_at]);
        let mut texels = whole[texels_at..].to_vec();
        if layout::texel_bytes(info.format) == 2 {
            swap_pairs(&mut texels);
        }
        Ok(File3df { info, table, texels })
    }

    /// The bytes of the file.
    ///
    /// Texels that are missing count as 0; a table that the format has not is
    /// left out, a missing one is zeros.
    pub fn to_bytes(&self) -> Vec<u8> {
        let info = &self.info;
        let format = FORMATS.iter().find(|(_, number)| *number == info.format);
        let side = |lod: i32| 256u32 >> lod.clamp(0, 8);
        let (bits, wide) = layout::aspect_bits(info.aspect);
        let (w, h) = if wide { (1 << bits, 1) } else { (1, 1 << bits) };
        let mut out = format!(
            "3df v1.1\n{}\nlod range: {} {}\naspect ratio: {w} {h}\n",
            format.map_or("RGB565", |(name, _)| name).to_ascii_lowercase(),
            side(info.small_lod),
            side(info.large_lod),
        )
        .into_bytes();
        write_table(info.format, &self.table, &mut out);
        let mut texels = self.texels.clone();
        texels.resize(texel_bytes(info), 0);
        if layout::texel_bytes(info.format) == 2 {
            swap_pairs(&mut texels);
        }
        out.extend(texels);
        out
    }
}

fn swap_pairs(bytes: &mut [u8]) {
    bytes.as_chunks_mut::<2>().0.iter_mut().for_each(|pair| pair.reverse());
}

fn read_table(format: i32, bytes: &[u8]) -> Table3df {
    match format {
        TEXFMT_P_8 | TEXFMT_AP_88 => {
            let words = bytes.as_chunks().0.iter();
            Table3df::Palette(words.map(|&word| u32::from_be_bytes(word)).collect())
        }
        TEXFMT_YIQ_422 | TEXFMT_AYIQ_8422 => {
            let mut numbers = bytes.as_chunks().0.iter().map(|&pair| u16::from_be_bytes(pair));
            let mut next = || numbers.next().unwrap_or_default();
            let y = core::array::from_fn(|_| next() as u8);
            let mut rgb = || core::array::from_fn(|_| core::array::from_fn(|_| nine(next())));
            Table3df::Ncc(Ncc3df { y, i: rgb(), q: rgb() })
        }
        _ => Table3df::None,
    }
}

/// The low nine bits, as the original keeps them: not sign-extended.
fn nine(value: u16) -> i16 {
    (value & 0x1ff) as i16
}

fn write_table(format: i32, table: &Table3df, out: &mut Vec<u8>) {
    let end = out.len() + table_bytes(format);
    match table {
        Table3df::None => {}
        Table3df::Palette(colors) => out.extend(colors.iter().flat_map(|c| c.to_be_bytes())),
        Table3df::Ncc(ncc) => {
            let rest = ncc.i.iter().chain(&ncc.q).flatten().map(|&part| nine(part as u16) as u16);
            let numbers = ncc.y.iter().map(|&y| u16::from(y)).chain(rest);
            out.extend(numbers.flat_map(u16::to_be_bytes));
        }
    }
    out.resize(end, 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(format: i32, small_lod: i32, large_lod: i32, aspect: i32) -> File3df {
        let info = TextureInfo { small_lod, large_lod, aspect, format };
        let table = match table_bytes(format) {
            0 => Table3df::None,
            80 => Table3df::Ncc(Ncc3df {
                y: core::array::from_fn(|i| 17 * i as u8),
                i: core::array::from_fn(|i| [i as i16, 0x1ff, 0x100]),
                q: core::array::from_fn(|i| [0, 40 * i as i16, 0x180]),
            }),
            _ => Table3df::Palette((0..256).map(|i| i * 0x01_0203).collect()),
        };
        let texels = (0..texel_bytes(&info)).map(|i| (i * 7 + i / 256) as u8).collect();
        File3df { info, table, texels }
    }

    #[test]
    fn files_read_back_as_written() {
        for (_, format) in FORMATS {
            for (small, large, aspect) in [(8, 0, 3), (8, 8, 3), (4, 2, 0), (7, 1, 6), (3, 3, 5)] {
                let file = sample(format, small, large, aspect);
                let bytes = file.to_bytes();
                assert!(bytes.len() <= MAX_FILE);
                assert_eq!(File3df::parse(&bytes), Ok(file));
            }
        }
    }

    #[test]
    fn every_cut_is_noticed() {
        let bytes = sample(TEXFMT_AYIQ_8422, 8, 6, 4).to_bytes();
        for length in 0..bytes.len() {
            assert!(File3df::parse(&bytes[..length]).is_err(), "{length}");
        }
    }

    #[test]
    fn headers() {
        let header = |text: &str| Header3df::parse(text.as_bytes()).map(|h| (h.info, h.size()));
        let good = "3df v1.4\nargb1555\nlod range: 2 64\naspect ratio: 4 1\n";
        let info = TextureInfo { small_lod: 7, large_lod: 2, aspect: 1, format: 0xb };
        assert_eq!(header(good), Ok((info, (64, 16))));
        assert_eq!(
            header("3df v1.1\nP8\nlod range: 1 256\naspect ratio: 1 8").err(),
            Some(Error3df::Header)
        );
        let with = |from: &str, to: &str| header(&good.replace(from, to)).err();
        assert_eq!(with("3df", "3ds"), Some(Error3df::Header));
        assert_eq!(with("argb1555", "argb1556"), Some(Error3df::Format));
        assert_eq!(with("2 64", "3 64"), Some(Error3df::Levels));
        assert_eq!(with("2 64", "64 2"), Some(Error3df::Levels));
        assert_eq!(with("2 64", "0 64"), Some(Error3df::Levels));
        assert_eq!(with("2 64", "1 99999999999"), Some(Error3df::Levels));
        assert_eq!(with("4 1", "3 1"), Some(Error3df::Aspect));
        assert_eq!(with("4 1", "16 1"), Some(Error3df::Aspect));
        assert_eq!(with("4 1", "0 0"), Some(Error3df::Aspect));
        assert_eq!(with("4 1", "-1 1"), Some(Error3df::Aspect));
        assert_eq!(with("v1.4", &format!("v{}", "9".repeat(100))), Some(Error3df::Header));
    }

    #[test]
    fn tables_pack_as_the_hardware_takes_them() {
        let ncc = Ncc3df {
            y: core::array::from_fn(|i| i as u8),
            i: [[1, -1, 2]; 4],
            q: [[0, 0, -256]; 4],
        };
        let words = ncc.packed();
        assert_eq!((words[0], words[3]), (0x0302_0100, 0x0f0e_0d0c));
        assert_eq!(words[4], 1 << 18 | 0x1ff << 9 | 2);
        assert_eq!(words[8], 0x100);
    }
}
