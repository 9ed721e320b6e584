//! Calls whose arguments are numbers.

use fillrate_guard::guard;
use fillrate_raw::call::Call;
use fillrate_raw::color::pack;
use fillrate_raw::opcode::Opcode;

use crate::session::{ask, call, client};

/// Exports whose arguments are numbers: each makes a call's value.
macro_rules! calls {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $type:ty),*) = $call:expr;)*) => {$(
        $(#[$doc])*
        #[unsafe(no_mangle)]
        pub extern "C" fn $name($($arg: $type),*) {
            guard((), || { call($call); })
        }
    )*};
}
pub(crate) use calls;

calls! {
    /// Enters scene-streaming mode.
    RBeginScene() = Call::BeginScene {};
    /// Leaves scene-streaming mode.
    REndScene() = Call::EndScene {};
    /// Begins a primitive.
    RBeginPrim() = Call::BeginPrim {};
    /// Ends a primitive.
    REndPrim() = Call::EndPrim {};
    /// A vertex.
    RVertex(x: f32, y: f32, z: f32, u: f32, v: f32) = Call::Vertex { x, y, z, u, v };
    /// The colour of later vertices.
    RColorRGBA(rgba: u32) = Call::Color { rgba };
    /// The colour of later vertices, each channel cut to 8 bits.
    RColor(r: u32, g: u32, b: u32, a: u32) = Call::Color { rgba: pack(r, g, b, a) };
    /// The normal of later vertices.
    RNormal(x: f32, y: f32, z: f32) = Call::Normal { x, y, z };
    /// The weight of the colour in blend mode.
    RColTexBalance(balance: f32) = Call::ColTexBalance { balance };
    /// The threshold of hard alpha.
    RAlphaThresh(threshold: u32) = Call::AlphaThresh { threshold };
    /// Ambient light.
    RAmbColorRGBI(rgbi: u32) = Call::AmbColor { rgbi };
    /// Ambient light by channel.
    RAmbColor(r: u32, g: u32, b: u32, i: u32) =
        Call::AmbColor { rgbi: client(|c| c.light_color(r, g, b, i)) };
    /// Directional light.
    RDirColorRGBI(rgbi: u32) = Call::DirColor { rgbi };
    /// Directional light by channel.
    RDirColor(r: u32, g: u32, b: u32, i: u32) =
        Call::DirColor { rgbi: client(|c| c.light_color(r, g, b, i)) };
    /// The direction in which the light travels.
    RDirLight(x: f32, y: f32, z: f32) = Call::DirLight { x, y, z };
    /// Ambient reflectance.
    RAmbReflect(amount: u32) = Call::AmbReflect { amount };
    /// Directional reflectance.
    RDirReflect(amount: u32) = Call::DirReflect { amount };
    /// Fills pages.
    RClearFBRGBX(pages: u32, rgbx: u32) = Call::ClearFb { pages, rgbx };
    /// Fills pages with a colour by channel.
    RClearFB(pages: u32, r: u32, g: u32, b: u32) =
        Call::ClearFb { pages, rgbx: pack(r, g, b, 0) };
    /// Clears the depths.
    RClearZ() = Call::ClearZ {};
    /// Chooses the pages to draw to.
    RSetPage(pages: u32) = Call::SetPage { pages };
    /// Swaps the pages.
    RFlipPage(wait: u32) = Call::FlipPage { wait };
    /// Frees a texture.
    RDeallocTexture(id: i32) = Call::DeallocTexture { id: id as u32 };
    /// Moves textures together.
    RCompactTexMem() = Call::CompactTexMem {};
    /// Writes a pixel.
    RWriteFBRGBX(x: u32, y: u32, pages: u32, rgbx: u32) = Call::WriteFb { x, y, pages, rgbx };
    /// Writes a pixel by channel.
    RWriteFB(x: u32, y: u32, pages: u32, r: u32, g: u32, b: u32) =
        Call::WriteFb { x, y, pages, rgbx: pack(r, g, b, 0) };
    /// Writes a depth.
    RWriteZ(x: u32, y: u32, z: i32) = Call::WriteZ { x, y, z };
    /// Stops the device.
    RHalt() = Call::Halt {};
    /// What the vertices of a primitive make up.
    RXSetPrimitive(kind: u32) = Call::SetPrimitive { kind };
    /// What is done at the borders of the view.
    RXSetClip(planes: u32) = Call::SetClip { planes };
    /// How levels of a texture are used.
    RXSetMipMap(mode: u32) = Call::SetMipMap { mode };
    /// The side of a point.
    RXSetPointSize(pixels: u32) = Call::SetPointSize { pixels };
    /// Keeps a vertex.
    RXStoreVertex(index: u32, x: f32, y: f32, z: f32, u: f32, v: f32) =
        Call::StoreVertex { index, x, y, z, u, v };
    /// Adds a kept vertex to the primitive.
    RXIndex(index: u32) = Call::Index { index };
    /// A further light.
    RXLight(number: u32, rgbi: u32, x: f32, y: f32, z: f32) =
        Call::Light { number, rgbi, x, y, z };
    /// Highlights.
    RXSpecular(rgbi: u32, exponent: u32) = Call::Specular { rgbi, exponent };
    /// Where the viewer stands.
    RXEye(x: f32, y: f32, z: f32) = Call::Eye { x, y, z };
    /// Makes the levels of a texture.
    RXMakeMipMaps(id: i32) = Call::MakeMipMaps { id: id as u32 };
    /// Changes the resolution.
    RXResize(width: u32, height: u32) = Call::Resize { width, height };
}

/// Exports that set a mode field or the texture id.
macro_rules! modes {
    ($($(#[$doc:meta])* $name:ident = $opcode:ident;)*) => {$(
        $(#[$doc])*
        #[unsafe(no_mangle)]
        pub extern "C" fn $name(value: u32) {
            guard((), || { call(Call::Set { opcode: Opcode::$opcode as u32, value }); })
        }
    )*};
}

modes! {
    /// Turns lighting on.
    RSetLit = SetLit;
    /// Uses the ambient term.
    RSetUseAmb = SetUseAmb;
    /// Uses the directional term.
    RSetUseDir = SetUseDir;
    /// How colour and texture are combined.
    RSetTexMode = SetTexMode;
    /// How texture alpha is conditioned.
    RSetTexAlpha = SetTexAlpha;
    /// How colour alpha is conditioned.
    RSetColAlpha = SetColAlpha;
    /// Interpolates colours.
    RSetColInterp = SetColInterp;
    /// Interpolates the directional intensity.
    RSetLitInterp = SetLitInterp;
    /// Bilinear instead of nearest texels.
    RSetTexInterp = SetTexInterp;
    /// Lets primitives be drawn out of order.
    RSetOutOfOrder = SetOutOfOrder;
    /// How texture coordinates outside 0..1 are treated.
    RSetTexTile = SetTexTile;
    /// Skips the depth test.
    RSetNoUseZ = SetNoUseZ;
    /// Skips the depth write.
    RSetNoWriteZ = SetNoWriteZ;
    /// Chooses the texture.
    RSetTextureID = SetTextureId;
}

/// Exports that bring back one word.
macro_rules! questions {
    ($($(#[$doc:meta])* $name:ident($($arg:ident: $type:ty),*) -> $out:ty = $call:expr, $fallback:expr;)*) => {$(
        $(#[$doc])*
        #[unsafe(no_mangle)]
        pub extern "C" fn $name($($arg: $type),*) -> $out {
            let fallback: $out = $fallback;
            guard(fallback, || ask($call, fallback as u32) as $out)
        }
    )*};
}

questions! {
    /// Allocates a texture; returns its id, or -1.
    RAllocateTexture(width: u32, height: u32) -> i32 = Call::AllocateTexture { width, height }, -1;
    /// Allocates a texture with all its levels; returns its id, or -1.
    RXAllocateMipMapped(width: u32, height: u32) -> i32 =
        Call::AllocateMipMapped { width, height }, -1;
    /// Free texture memory in bytes; 0 in a scene.
    RTexMemAvail() -> u32 = Call::TexMemAvail {}, 0;
    /// A pixel; 0 in a scene.
    RReadFB(x: u32, y: u32, page: u32) -> u32 = Call::ReadFb { x, y, page }, 0;
    /// A depth; 0 in a scene.
    RReadZ(x: u32, y: u32) -> i32 = Call::ReadZ { x, y }, 0;
}
