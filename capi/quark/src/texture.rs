//! Textures.

use fillrate_guard::{bytes, guard, read, write};
use fillrate_quark::{Call, MAX_TEXTURE_SIDE, apply_key};

use crate::layout::RawTexture;
use crate::session::{Session, session};
use crate::sync::KnownTexture;

/// Prepares a texture. Returns 1 where triangles can use it. With a null
/// pointer, or sides outside 1 to 2048, it becomes empty and draws nothing.
///
/// # Safety
/// `texture` is null or points to a texture; `texels` is null or points to
/// `x * y` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn quark_texture_init(
    texture: *mut RawTexture,
    texels: *const u8,
    x: i32,
    y: i32,
    key: i32,
) -> i32 {
    guard(0, || {
        if texture.is_null() {
            return 0;
        }
        let allowed = 1..=MAX_TEXTURE_SIDE;
        let valid = !texels.is_null() && allowed.contains(&x) && allowed.contains(&y);
        let count = if valid { x as usize * y as usize } else { 0 };
        // SAFETY: the caller gives that many.
        let texels = unsafe { bytes(texels, count) };
        let mut session = session();
        let (raw, result) = session.texture_init(texture as usize, texels, [x, y], key);
        // SAFETY: the caller's promise.
        unsafe { write(texture, raw) };
        result
    })
}

impl Session {
    /// The texture's members and what `Init` returns.
    fn texture_init(
        &mut self,
        address: usize,
        texels: &[u8],
        [x, y]: [i32; 2],
        key: i32,
    ) -> (RawTexture, i32) {
        let mut prepared = texels.to_vec();
        let keyed = apply_key(&mut prepared, key);
        let known = self.known_texture(address);
        let (number, old) = (known.number, known.block);
        known.keyed = keyed;
        known.version += 1;
        // A block that is large enough is used again, so that copies of the
        // object never point to memory that is gone.
        let reused = self.memory.size_of(old).is_some_and(|size| size >= prepared.len());
        let block = if reused && !prepared.is_empty() {
            // SAFETY: the block is ours and large enough.
            unsafe { old.copy_from_nonoverlapping(prepared.as_ptr(), prepared.len()) };
            Some(old)
        } else {
            // Twice the size, so that all blocks left behind together are no
            // larger than this one.
            let block = self.memory.allocate(prepared.len() * 2);
            if let Some(block) = block {
                // SAFETY: the block is new and large enough.
                unsafe { block.copy_from_nonoverlapping(prepared.as_ptr(), prepared.len()) };
            }
            block
        };
        let Some(block) = block.filter(|_| !prepared.is_empty()) else {
            let empty = RawTexture {
                size_x: 0,
                size_y: 0,
                texels: std::ptr::null_mut(),
                mask_x: 0,
                mask_y: 0,
            };
            return (empty, 0);
        };
        self.known_texture(address).block = block;
        let texels = texels.into();
        let result = self.call(&Call::TextureInit { texture: number, texels, x, y, key }).number();
        let mask = |side: i32| (side - 1) as u32;
        let (mask_x, mask_y) = (mask(x), mask(y));
        (RawTexture { size_x: x, size_y: y, texels: block, mask_x, mask_y }, result)
    }

    /// What is known of the texture at an address.
    pub fn known_texture(&mut self, address: usize) -> &mut KnownTexture {
        let next = self.last_texture + 1;
        let known = self.textures.entry(address).or_insert_with(|| KnownTexture::new(next));
        self.last_texture = self.last_texture.max(known.number);
        known
    }

    /// The number and version of a texture as it is now, number 0 for none;
    /// one that changed crosses the border first.
    ///
    /// # Safety
    /// `texture` is null or points to a texture whose texels can be read.
    pub unsafe fn sync_texture(&mut self, texture: *const RawTexture) -> (u32, u64) {
        // SAFETY: the caller's promise.
        let Some(raw) = (unsafe { read(texture) }) else { return (0, 0) };
        let allowed = 1..=MAX_TEXTURE_SIDE;
        let valid = allowed.contains(&raw.size_x) && allowed.contains(&raw.size_y);
        if !valid || raw.texels.is_null() {
            return (0, 0);
        }
        let count = raw.size_x as usize * raw.size_y as usize;
        if self.memory.size_of(raw.texels).is_some_and(|size| size < count) {
            return (0, 0);
        }
        // SAFETY: the caller's promise; of our own block the size was checked.
        let texels = unsafe { bytes(raw.texels, count) };
        let known = self.known_texture(texture as usize);
        let (number, keyed) = (known.number, known.keyed);
        let same = self.context.texture(number).is_some_and(|known| {
            (known.width(), known.height()) == (raw.size_x, raw.size_y)
                && known.texels() == texels
                && known.is_keyed() == keyed
        });
        if !same {
            let (x, y) = (raw.size_x, raw.size_y);
            self.call(&Call::Texture { texture: number, texels: texels.into(), x, y, keyed });
            self.known_texture(texture as usize).version += 1;
        }
        (number, self.known_texture(texture as usize).version)
    }
}
