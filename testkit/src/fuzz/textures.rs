//! Texture downloads of every format, each texel compared with its decoding.

use fillrate_glide::gu::{File3df, Header3df};
use fillrate_glide::texture::{NccTable, decode, layout};
use fillrate_glide::{Call, Context, GrVertex, TextureInfo};

use super::Bytes;

/// Formats there are.
const FORMATS: [i32; 13] = [0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 12, 13, 14];

/// A texture in memory, and what its bytes mean.
struct Loaded {
    info: TextureInfo,
    start: u32,
    even_odd: u32,
    data: Vec<u8>,
    palette: [u32; 256],
    ncc: NccTable,
}

impl Loaded {
    fn new(from: &mut Bytes<'_>) -> Loaded {
        let large_lod = if from.byte() > 250 { 0 } else { 3 + i32::from(from.byte() % 6) };
        let info = TextureInfo {
            format: FORMATS[usize::from(from.byte()) % FORMATS.len()],
            aspect: i32::from(from.byte() % 7),
            large_lod,
            small_lod: large_lod + i32::from(from.byte()) % (9 - large_lod),
        };
        let (a, b) = (usize::from(from.byte()) | 1, from.byte());
        let data = (0..total(&info)).map(|i| (i * a + i / 251) as u8 ^ b).collect();
        let (p, q) = (from.word(), u32::from(from.byte()));
        let mut ncc = NccTable::default();
        for word in 0..12 {
            ncc.set_word(word, ncc_word(p, word));
        }
        Loaded {
            info,
            start: u32::from(from.unsigned_half()) * 8,
            even_odd: 1 + u32::from(from.byte()) % 3,
            data,
            palette: core::array::from_fn(|i| (p ^ (i as u32 * (2 * q + 1) * 0x0301)) & 0xff_ffff),
            ncc,
        }
    }

    /// The colour of a texel by its format.
    fn texel(&self, lod: i32, x: u32, y: u32) -> u32 {
        let before: usize = (self.info.large_lod..lod).map(|l| level(&self.info, l)).sum();
        let (width, _) = layout::size(self.info.aspect, lod as u32);
        let bytes = layout::texel_bytes(self.info.format) as usize;
        let at = before + (y * width + x) as usize * bytes;
        let low = u16::from(self.data[at]);
        let high = if bytes == 2 { u16::from(self.data[at + 1]) << 8 } else { 0 };
        decode(self.info.format, low | high, &self.palette, &self.ncc)
    }
}

fn ncc_word(seed: u32, word: usize) -> u32 {
    seed.rotate_left(word as u32 * 5).wrapping_mul(0x9e37_79b1) & 0x7fff_ffff
}

fn level(info: &TextureInfo, lod: i32) -> usize {
    let (width, height) = layout::size(info.aspect, lod as u32);
    (width * height * layout::texel_bytes(info.format)) as usize
}

fn total(info: &TextureInfo) -> usize {
    (info.large_lod..=info.small_lod).map(|lod| level(info, lod)).sum()
}

/// Loads a texture, whole or in parts, through the calls or the texture
/// manager, and compares texels of every level it has with their decoding.
///
/// # Panics
/// Where a texel is not what its bytes say.
pub fn run_texture(context: &mut Context, bytes: &[u8]) {
    let mut from = Bytes::new(bytes);
    reset(context);
    let loaded = Loaded::new(&mut from);
    let managed = from.byte() > 200;
    let in_parts = from.byte() > 128;
    tables(context, &loaded);
    let TextureInfo { small_lod, large_lod, aspect, format } = loaded.info;
    let (start, even_odd) = (loaded.start, loaded.even_odd);
    if managed {
        load_managed(context, &loaded);
    } else {
        if in_parts {
            load_in_parts(context, &loaded);
        } else {
            let data = loaded.data[..].into();
            context.execute(&Call::GrTexDownloadMipMap {
                tmu: 0,
                start,
                even_odd,
                small_lod,
                large_lod,
                aspect,
                format,
                data,
            });
        }
        context.execute(&Call::GrTexSource {
            tmu: 0,
            start,
            even_odd,
            small_lod,
            large_lod,
            aspect,
            format,
        });
        context.execute(&Call::GrTexMipMapMode { tmu: 0, mode: 1, blend: 0 });
        context.execute(&Call::GrTexFilterMode { tmu: 0, minify: 0, magnify: 0 });
    }
    for lod in large_lod..=small_lod {
        if layout::is_selected(even_odd, lod as u32) {
            compare_level(context, &loaded, lod, &mut from);
        }
    }
    context.take_reports();
}

fn reset(context: &mut Context) {
    let calls = [
        Call::GrGlideInit {},
        Call::GrSstSelect { board: 0 },
        Call::GrSstWinClose {},
        Call::GrSstWinOpen {
            window: 0,
            resolution: 0,
            refresh: 0,
            color_format: 0,
            origin: 0,
            colors: 2,
            aux: 1,
        },
        Call::GrDitherMode { mode: 0 },
        Call::GrColorMask { rgb: 1, alpha: 1 },
        Call::GuColorCombineFunction { function: 4 },
        Call::GuAlphaSource { mode: 2 },
        Call::GrTexCombineFunction { tmu: 0, function: 1 },
    ];
    for call in &calls {
        context.execute(call);
    }
}

fn tables(context: &mut Context, loaded: &Loaded) {
    let words = loaded.palette.to_vec();
    context.execute(&Call::GrTexDownloadTable { tmu: 0, table: 2, first: 0, words });
    context.execute(&Call::GrTexDownloadTable {
        tmu: 0,
        table: 0,
        first: 0,
        words: packed(&loaded.ncc),
    });
    context.execute(&Call::GrTexNccTable { tmu: 0, table: 0 });
}

/// The words of a compression table, as the hardware takes them.
fn packed(ncc: &NccTable) -> Vec<u32> {
    let nine = |part: i16| u32::from(part as u16 & 0x1ff);
    let rgb = |c: &[i16; 3]| nine(c[0]) << 18 | nine(c[1]) << 9 | nine(c[2]);
    let y = ncc.y.as_chunks().0.iter().map(|&four| u32::from_le_bytes(four));
    y.chain(ncc.i.iter().chain(&ncc.q).map(rgb)).collect()
}

fn load_in_parts(context: &mut Context, loaded: &Loaded) {
    let TextureInfo { small_lod, large_lod, aspect, format } = loaded.info;
    let mut rest = &loaded.data[..];
    for this_lod in large_lod..=small_lod {
        let (own, after) = rest.split_at(level(&loaded.info, this_lod));
        rest = after;
        let (_, height) = layout::size(aspect, this_lod as u32);
        let pitch = own.len() / height as usize;
        for row in (0..height as i32).rev() {
            let data = own[row as usize * pitch..][..pitch].into();
            context.execute(&Call::GrTexDownloadMipMapLevelPartial {
                tmu: 0,
                start: loaded.start,
                this_lod,
                large_lod,
                aspect,
                format,
                even_odd: loaded.even_odd,
                data,
                first: row,
                last: row,
            });
        }
    }
}

fn load_managed(context: &mut Context, loaded: &Loaded) {
    let TextureInfo { small_lod, large_lod, aspect, format } = loaded.info;
    let id = context.execute(&Call::GuTexAllocateMemory {
        tmu: 0,
        even_odd: loaded.even_odd as u8,
        width: 1,
        height: 1,
        format,
        mip_map_mode: 1,
        small_lod,
        large_lod,
        aspect,
        s_clamp: 0,
        t_clamp: 0,
        minify: 0,
        magnify: 0,
        lod_bias: 0.0,
        trilinear: 0,
    });
    let mut table = vec![0; 64];
    table.extend(packed(&loaded.ncc).iter().flat_map(|word| word.to_le_bytes()));
    let (data, table) = (loaded.data[..].into(), Some(table.into()));
    context.execute(&Call::GuTexDownloadMipMap { id, data, table });
    context.execute(&Call::GuTexSource { id });
}

/// Draws some texels of a level, one pixel each, and reads colour and alpha
/// back.
fn compare_level(context: &mut Context, loaded: &Loaded, lod: i32, from: &mut Bytes<'_>) {
    let (width, height) = layout::size(loaded.info.aspect, lod as u32);
    let mut expected = Vec::new();
    for column in 0..4 {
        let (x, y) = (u32::from(from.byte()) % width, u32::from(from.byte()) % height);
        expected.push(loaded.texel(lod, x, y));
        draw_texel(context, column, lod, (x, y));
    }
    let color = context.lfb_read_region(1, (0, 0), (4, 1)).unwrap_or_default();
    let alpha = context.lfb_read_region(2, (0, 0), (4, 1)).unwrap_or_default();
    for (i, texel) in expected.into_iter().enumerate() {
        let five = |c: u32| c >> 3 & 31;
        let rgb = five(texel >> 16) << 11 | (texel >> 10 & 63) << 5 | five(texel);
        assert_eq!(u32::from(color[i]), rgb, "level {lod} of {:?}", loaded.info);
        assert_eq!(u32::from(alpha[i]), texel >> 24, "alpha, level {lod} of {:?}", loaded.info);
    }
}

/// Covers one pixel, with a gradient of s that makes `lod` the level.
fn draw_texel(context: &mut Context, column: u32, lod: i32, (x, y): (u32, u32)) {
    // A texel of the level is 2^lod of the coordinates' units. A little more
    // than that to a pixel makes it the level.
    let unit = (1 << lod) as f32;
    let step = unit * 1.25;
    let (s, t) = ((x as f32 + 0.5) * unit, (y as f32 + 0.5) * unit);
    let (px, py) = (column as f32 + 0.5, 0.5);
    let at = |dx: f32, dy: f32| {
        let mut v = GrVertex { x: px + dx, y: py + dy, oow: 1.0, ..GrVertex::default() };
        v.tmuvtx[0].sow = s + dx * step;
        v.tmuvtx[0].tow = t;
        v
    };
    // Only the pixel's centre is inside.
    let (a, b, c) = (at(-0.25, -0.25), at(0.5, -0.25), at(-0.25, 0.5));
    context.execute(&Call::GrDrawTriangle { a, b, c });
}

/// Reads bytes as a `.3df` file; what is one must come out as it went in.
///
/// # Panics
/// Where a file does not read back as it was written.
pub fn run_file(bytes: &[u8]) {
    let (header, file) = (Header3df::parse(bytes), File3df::parse(bytes));
    if let Ok(file) = file {
        assert_eq!(header.map(|h| (h.info, h.texel_bytes())), Ok((file.info, file.texels.len())));
        let written = file.to_bytes();
        assert_eq!(File3df::parse(&written), Ok(file));
    }
    // Most bytes have no header; these are given one.
    let mut from = Bytes::new(bytes);
    let made = made_file(&mut from);
    if let Ok(file) = File3df::parse(&made) {
        let written = file.to_bytes();
        assert_eq!(File3df::parse(&written), Ok(file));
    }
}

/// A file of a header in which little is wrong, and random data.
fn made_file(from: &mut Bytes<'_>) -> Vec<u8> {
    const NAMES: [&str; 16] = [
        "I8",
        "A8",
        "AI44",
        "YIQ",
        "RGB332",
        "RGB565",
        "ARGB8332",
        "argb1555",
        "AYIQ8422",
        "ARGB4444",
        "AI88",
        "P8",
        "AP88",
        "X",
        "",
        "RGB565RGB565RGB565RGB565RGB565",
    ];
    let side = |from: &mut Bytes<'_>| match from.byte() {
        k @ 0..=239 => 1i64 << (k % 9),
        _ => i64::from(from.int()),
    };
    let name = NAMES[usize::from(from.byte() & 15)];
    let (small, large, w, h) = (side(from), side(from), side(from), side(from));
    let end = if from.byte() > 250 { "\r" } else { "\n" };
    let text = format!("3df v1.1{end}{name}\nlod range: {small} {large}\naspect ratio: {w} {h}\n");
    let mut bytes = text.into_bytes();
    if from.byte() > 240 {
        let at = usize::from(from.byte()) % bytes.len();
        bytes[at] = from.byte();
    }
    let length = usize::from(from.unsigned_half()) * 3;
    let (a, b) = (usize::from(from.byte()), from.byte());
    bytes.extend((0..length).map(|i| (i * a) as u8 ^ b));
    bytes
}
