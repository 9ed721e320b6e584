//! The hash by which a replay proves that it draws what was recorded.

use xxhash_rust::xxh3::Xxh3;

/// Pixels are hashed in pieces of this many.
const PIECE: usize = 2048;

/// The pixels of a frame, row by row from the top left, without gaps between rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PixelsRef<'a> {
    /// Four bytes each: red, green, blue, alpha.
    Rgba8(&'a [u8]),
    /// Five bits of red (the highest), six of green, five of blue.
    Rgb565(&'a [u16]),
}

impl PixelsRef<'_> {
    /// The number of the format in the hashed bytes.
    fn format(self) -> u32 {
        match self {
            Self::Rgba8(_) => 0,
            Self::Rgb565(_) => 1,
        }
    }
}

/// The hash of a frame as stored in a trace: a function of size, format and pixels only.
///
/// `width` and `height` are in pixels. Definition: `docs/trace-format.md`, FRAM.
pub fn hash_frame(width: u32, height: u32, pixels: PixelsRef<'_>) -> u64 {
    let mut hasher = Xxh3::new();
    for field in [width, height, pixels.format()] {
        hasher.update(&field.to_le_bytes());
    }
    match pixels {
        PixelsRef::Rgba8(bytes) => hasher.update(bytes),
        PixelsRef::Rgb565(pixels) => update_little_endian(&mut hasher, pixels),
    }
    hasher.digest()
}

/// Hashes 16-bit pixels as little-endian bytes, whatever the machine.
fn update_little_endian(hasher: &mut Xxh3, pixels: &[u16]) {
    let mut bytes = [0; 2 * PIECE];
    for piece in pixels.chunks(PIECE) {
        let (pairs, _) = bytes.as_chunks_mut::<2>();
        for (pair, pixel) in pairs.iter_mut().zip(piece) {
            *pair = pixel.to_le_bytes();
        }
        hasher.update(&bytes[..2 * piece.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use xxhash_rust::xxh3::xxh3_64;

    #[test]
    fn hash_is_over_header_and_little_endian_pixels() {
        let pixels: Vec<u16> = (0..3 * PIECE + 7).map(|i| (i * 40503) as u16).collect();
        let mut bytes = vec![3, 0, 0, 0, 7, 0, 0, 0, 1, 0, 0, 0];
        bytes.extend(pixels.iter().flat_map(|pixel| pixel.to_le_bytes()));
        assert_eq!(hash_frame(3, 7, PixelsRef::Rgb565(&pixels)), xxh3_64(&bytes));
    }

    #[test]
    fn hash_depends_on_size_format_and_pixels() {
        let hashes = [
            hash_frame(2, 1, PixelsRef::Rgba8(&[0; 8])),
            hash_frame(1, 2, PixelsRef::Rgba8(&[0; 8])),
            hash_frame(2, 1, PixelsRef::Rgb565(&[0; 4])),
            hash_frame(2, 1, PixelsRef::Rgba8(&[0, 0, 0, 0, 0, 0, 0, 1])),
        ];
        for (index, hash) in hashes.iter().enumerate() {
            assert!(!hashes[..index].contains(hash), "{index}");
        }
    }
}
