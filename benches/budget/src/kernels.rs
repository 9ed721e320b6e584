//! The draw states that have a budget, as Glide calls.

use fillrate_glide::{Call, gu};

/// What a scene draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Draw {
    /// Full-screen layers, each nearer than the one before.
    Layers,
    /// The same, each farther: all but the first fail the depth test.
    Hidden,
    /// Triangles of that many pixels.
    Triangles(u32),
    /// Lines.
    Lines,
    /// Clears of both planes, made to matter by a pixel in every 16x16.
    Clears,
    /// A rectangle written past the pipeline.
    LfbWrite,
    /// The screen read.
    LfbRead,
    /// A texture stored and used.
    Upload,
}

/// A draw state and what is drawn with it.
pub struct Kernel {
    /// As the record names it.
    pub name: &'static str,
    /// What is drawn.
    pub draw: Draw,
    /// Appends the calls that set the state.
    pub state: fn(&mut Vec<Call>),
}

impl Kernel {
    /// What instructions are divided by.
    pub fn unit(&self) -> &'static str {
        match self.draw {
            Draw::Triangles(_) => "triangle",
            Draw::Lines => "line",
            Draw::Upload => "texel",
            _ => "pixel",
        }
    }
}

const fn kernel(name: &'static str, draw: Draw, state: fn(&mut Vec<Call>)) -> Kernel {
    Kernel { name, draw, state }
}

/// All of them.
pub static KERNELS: [Kernel; 26] = [
    kernel("flat", Draw::Layers, flat),
    kernel("gouraud", Draw::Layers, gouraud),
    kernel("gouraud_z", Draw::Layers, gouraud_z),
    kernel("gouraud_z_hidden", Draw::Hidden, gouraud_z),
    kernel("gouraud_w", Draw::Layers, gouraud_w),
    kernel("gouraud_blend", Draw::Layers, gouraud_blend),
    kernel("gouraud_stipple", Draw::Layers, gouraud_stipple),
    kernel("point", Draw::Layers, point),
    kernel("bilinear", Draw::Layers, bilinear),
    kernel("modulate_z", Draw::Layers, modulate_z),
    kernel("modulate_z_hidden", Draw::Hidden, modulate_z),
    kernel("modulate_blend", Draw::Layers, modulate_blend),
    kernel("modulate_fog", Draw::Layers, modulate_fog),
    kernel("two_textures", Draw::Layers, two_textures),
    kernel("two_textures_fog_z", Draw::Layers, two_textures_fog_z),
    kernel("trilinear", Draw::Layers, trilinear),
    kernel("alpha_test", Draw::Layers, alpha_test),
    kernel("chroma_key", Draw::Layers, chroma_key),
    kernel("triangles_2", Draw::Triangles(2), modulate_z),
    kernel("triangles_10", Draw::Triangles(10), modulate_z),
    kernel("triangles_100", Draw::Triangles(100), modulate_z),
    kernel("lines", Draw::Lines, gouraud_z),
    kernel("clear", Draw::Clears, gouraud_z),
    kernel("lfb_write", Draw::LfbWrite, gouraud),
    kernel("lfb_read", Draw::LfbRead, gouraud),
    kernel("upload", Draw::Upload, bilinear),
];

fn flat(out: &mut Vec<Call>) {
    out.extend([
        Call::GuColorCombineFunction { function: 1 },
        Call::GrConstantColorValue { value: 0x0030_60c0 },
    ]);
}

fn gouraud(out: &mut Vec<Call>) {
    out.push(Call::GuColorCombineFunction { function: 2 });
}

/// Depth buffering of a kind, less or equal.
fn depth(out: &mut Vec<Call>, mode: i32) {
    out.extend([
        Call::GrDepthBufferMode { mode },
        Call::GrDepthBufferFunction { function: 3 },
        Call::GrDepthMask { mask: 1 },
    ]);
}

fn gouraud_z(out: &mut Vec<Call>) {
    gouraud(out);
    depth(out, 1);
}

fn gouraud_w(out: &mut Vec<Call>) {
    gouraud(out);
    depth(out, 2);
}

/// Source alpha over the destination.
fn blend(out: &mut Vec<Call>) {
    out.extend([
        Call::GuAlphaSource { mode: 1 },
        Call::GrAlphaBlendFunction {
            rgb_source: 1,
            rgb_destination: 5,
            alpha_source: 4,
            alpha_destination: 0,
        },
    ]);
}

fn gouraud_blend(out: &mut Vec<Call>) {
    gouraud(out);
    blend(out);
}

fn gouraud_stipple(out: &mut Vec<Call>) {
    gouraud(out);
    // Glide has no call for it: fbzMode with clipping, both stipple bits,
    // dithering, colour writes and the back buffer; and the pattern.
    out.extend(
        [(68, 0x5305), (80, 0xa5a5_3c3c)].map(|(register, value)| Call::GrSstConfigPipeline {
            chip: 3,
            register,
            value,
        }),
    );
}

/// A texture with mip maps on a unit, filtered or not.
fn texture(out: &mut Vec<Call>, tmu: i32, filter: i32) {
    let (start, even_odd, small_lod, large_lod, aspect) = (0, 3, 8, 1, 3);
    let (format, data) = (crate::scene::TEXEL_FORMAT, crate::scene::texels().into());
    out.extend([
        Call::GrTexDownloadMipMap {
            tmu,
            start,
            even_odd,
            small_lod,
            large_lod,
            aspect,
            format,
            data,
        },
        Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format },
        Call::GrTexMipMapMode { tmu, mode: 1, blend: 0 },
        Call::GrTexFilterMode { tmu, minify: filter, magnify: filter },
        Call::GrTexClampMode { tmu, s: 0, t: 0 },
        Call::GrTexCombineFunction { tmu, function: 1 },
    ]);
}

fn point(out: &mut Vec<Call>) {
    texture(out, 0, 0);
    out.push(Call::GuColorCombineFunction { function: 4 });
}

fn bilinear(out: &mut Vec<Call>) {
    texture(out, 0, 1);
    out.push(Call::GuColorCombineFunction { function: 4 });
}

fn modulate(out: &mut Vec<Call>) {
    texture(out, 0, 1);
    out.push(Call::GuColorCombineFunction { function: 6 });
}

fn modulate_z(out: &mut Vec<Call>) {
    modulate(out);
    depth(out, 1);
}

fn modulate_blend(out: &mut Vec<Call>) {
    modulate(out);
    blend(out);
}

fn fog(out: &mut Vec<Call>) {
    out.extend([
        Call::GrFogTable { table: gu::fog_table_exp(0.35) },
        Call::GrFogColorValue { color: 0x0080_99b3 },
        Call::GrFogMode { mode: 2 },
    ]);
}

fn modulate_fog(out: &mut Vec<Call>) {
    modulate(out);
    fog(out);
}

fn two_textures(out: &mut Vec<Call>) {
    modulate(out);
    texture(out, 1, 1);
    out.push(Call::GrTexCombineFunction { tmu: 0, function: 4 });
}

fn two_textures_fog_z(out: &mut Vec<Call>) {
    two_textures(out);
    fog(out);
    depth(out, 1);
}

/// Even levels on one unit and odd ones on the other, mixed.
fn trilinear(out: &mut Vec<Call>) {
    modulate(out);
    texture(out, 1, 1);
    let split = |tmu: i32, even_odd: u32| {
        let (start, small_lod, large_lod, aspect) = (0, 8, 1, 3);
        let format = crate::scene::TEXEL_FORMAT;
        Call::GrTexSource { tmu, start, even_odd, small_lod, large_lod, aspect, format }
    };
    let mix = |tmu: i32, factor: i32| Call::GrTexCombine {
        tmu,
        rgb_function: if tmu == 0 { 7 } else { 1 },
        rgb_factor: factor,
        alpha_function: if tmu == 0 { 7 } else { 1 },
        alpha_factor: factor,
        rgb_invert: 0,
        alpha_invert: 0,
    };
    out.extend([split(0, 1), split(1, 2)]);
    out.extend([0, 1].map(|tmu| Call::GrTexMipMapMode { tmu, mode: 1, blend: 1 }));
    out.extend([mix(1, 0), mix(0, 5)]);
}

fn alpha_test(out: &mut Vec<Call>) {
    modulate(out);
    out.extend([
        Call::GuAlphaSource { mode: 1 },
        Call::GrAlphaTestFunction { function: 4 },
        Call::GrAlphaTestReferenceValue { value: 128 },
    ]);
}

fn chroma_key(out: &mut Vec<Call>) {
    point(out);
    out.extend([Call::GrChromakeyMode { mode: 1 }, Call::GrChromakeyValue { value: 0 }]);
}
