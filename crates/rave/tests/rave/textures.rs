//! Textures, bitmaps and colour tables.

use fillrate_rave::constants::context::DOUBLE_BUFFER;
use fillrate_rave::constants::{multi_texture, quality, texture, texture_op};
use fillrate_rave::gestalt::{Answer, selector};
use fillrate_rave::memory::{EngineKind, MemoryConfig};
use fillrate_rave::tags::{float, int, pointer};
use fillrate_rave::{
    Call, EngineId, ImageValue, IndexedTriangle, PixelType, RaveConfig, RaveError, RaveRect, Reply,
    TextureId, VGouraud, VMultiTexture, VTexture,
};

use crate::scene::{Scene, channels, colored, config, context_new, image, textured};

const R: u32 = 0xffff_0000;
const G: u32 = 0xff00_ff00;
const B: u32 = 0xff00_00ff;
const W: u32 = 0xffff_ffff;
const ALL: [f32; 4] = [0.0, 0.0, 16.0, 16.0];

fn scene() -> Scene {
    let mut scene = Scene::new(16, 16, PixelType::Rgb32);
    scene.color(float::COLOR_BG_A, [1.0, 0.0, 0.0, 0.0]);
    scene
}

fn frame(scene: &mut Scene, draw: impl FnOnce(&mut Scene)) {
    scene.start();
    draw(scene);
    assert_eq!(scene.end(), Ok(()));
}

/// The middle of each quarter.
fn quarters(scene: &mut Scene) -> [u32; 4] {
    [(4, 4), (12, 4), (4, 12), (12, 12)].map(|(x, y)| scene.pixel(x, y))
}

fn texture_of(
    scene: &mut Scene,
    flags: u32,
    pixel_type: PixelType,
    images: &[ImageValue],
) -> Reply {
    let (pixel_type, images) = (pixel_type.number(), images.to_vec());
    scene.call(Call::TextureNew { engine: 1, flags, pixel_type, images })
}

#[test]
fn v_runs_up_and_rows_are_stored_from_the_top() {
    let mut scene = scene();
    let upright = scene.texture_new(2, &[R, G, B, W]);
    let flipped =
        texture_of(&mut scene, texture::FLIP_ORIGIN, PixelType::Argb32, &[image(2, &[R, G, B, W])]);
    scene.texture(upright);
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert_eq!(quarters(&mut scene), [R, G, B, W]);
    scene.texture(flipped.created());
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert_eq!(quarters(&mut scene), [B, W, R, G]);
}

/// Coordinates of -0.5 to 1.5.
fn rect_twice(scene: &mut Scene) {
    let at = |x: f32, y: f32| VTexture {
        x,
        y,
        u_over_w: x / 8.0 - 0.5,
        v_over_w: 1.5 - y / 8.0,
        ..textured(0.5)
    };
    let [a, b, c, d] = [at(0.0, 0.0), at(16.0, 0.0), at(0.0, 16.0), at(16.0, 16.0)];
    scene.tri_texture([a, b, c]);
    scene.tri_texture([b, d, c]);
}

#[test]
fn coordinates_repeat_or_are_limited() {
    let mut scene = scene();
    let texture = scene.texture_new(2, &[R, G, B, W]);
    scene.texture(texture);
    frame(&mut scene, rect_twice);
    let corners = [(1, 1), (14, 1), (1, 14), (14, 14)];
    assert_eq!(corners.map(|(x, y)| scene.pixel(x, y)), [W, B, G, R]);
    for (tag, value) in [(int::TEXTURE_OP, texture_op::SHRINK), (int::GL_TEXTURE_WRAP_U, 1)] {
        scene.int(tag, value);
        scene.int(int::GL_TEXTURE_WRAP_V, 1);
        frame(&mut scene, rect_twice);
        assert_eq!(corners.map(|(x, y)| scene.pixel(x, y)), [R, G, B, W]);
        scene.int(int::TEXTURE_OP, 0);
    }
}

/// The colour of a coordinate by OpenGL's rule: between the sides of the picture,
/// four texels, those outside of the border's colour. Two texels a side.
fn with_border(at: [f64; 2], texels: [u32; 4], border: u32, clamps: [bool; 2]) -> u32 {
    let place = |at: f64, clamps: bool| {
        let at = (at * 2.0 * 256.0).floor() as i32;
        let at = if clamps { at.clamp(0, 512) } else { at } - 128;
        (at >> 8, at >> 4 & 15)
    };
    let ((column, ds), (row, dt)) = (place(at[0], clamps[0]), place(at[1], clamps[1]));
    let texel = |column: i32, row: i32| {
        let outside = |at: i32, clamps: bool| clamps && !(0..2).contains(&at);
        if outside(column, clamps[0]) || outside(row, clamps[1]) {
            return border;
        }
        texels[(row & 1) as usize * 2 + (column & 1) as usize]
    };
    let mix = |shift: u32| {
        let channel = |column: i32, row: i32| (texel(column, row) >> shift & 255) as i32;
        let across = |row: i32| channel(column, row) * (16 - ds) + channel(column + 1, row) * ds;
        ((across(row) * (16 - dt) + across(row + 1) * dt) >> 8) as u32
    };
    0xff00_0000 | mix(16) << 16 | mix(8) << 8 | mix(0)
}

#[test]
fn borders_show_where_a_filter_reaches_over_the_side() {
    const BORDER: u32 = 0xff80_4020;
    let mut scene = scene();
    let texels = [R, G, B, W];
    let texture = scene.texture_new(2, &texels);
    scene.texture(texture);
    let check = |scene: &mut Scene, border: u32, clamps: [bool; 2], what: &str| {
        frame(scene, rect_twice);
        for (x, y) in (0..256).map(|i| (i % 16, i / 16)) {
            let at = [x, y].map(|v| (f64::from(v) + 0.5) / 8.0 - 0.5);
            let expected = with_border(at, texels, border, clamps);
            assert_eq!(scene.pixel(x, y), expected, "{what}: {x}, {y}");
        }
    };
    let edge = |scene: &mut Scene, what: &str| {
        frame(scene, rect_twice);
        let corners = [(0, 0), (15, 0), (0, 15), (15, 15)];
        assert_eq!(corners.map(|(x, y)| scene.pixel(x, y)), texels, "{what}");
    };
    scene.int(int::TEXTURE_FILTER, quality::MID);
    scene.int(int::GL_TEXTURE_WRAP_U, 1);
    scene.int(int::GL_TEXTURE_WRAP_V, 1);
    edge(&mut scene, "no border is set");
    scene.color(float::GL_TEXTURE_BORDER_A, [1.0, 128.0 / 255.0, 64.0 / 255.0, 32.0 / 255.0]);
    check(&mut scene, BORDER, [true, true], "both");
    scene.int(int::GL_TEXTURE_WRAP_U, 0);
    check(&mut scene, BORDER, [false, true], "v");
    scene.int(int::GL_TEXTURE_WRAP_U, 1);
    scene.int(int::GL_TEXTURE_WRAP_V, 0);
    check(&mut scene, BORDER, [true, false], "u");
    scene.int(int::GL_TEXTURE_WRAP_V, 1);
    scene.float(float::GL_TEXTURE_BORDER_R, 0.0);
    check(&mut scene, 0xff00_4020, [true, true], "another colour");
    scene.int(int::TEXTURE_OP, texture_op::SHRINK);
    edge(&mut scene, "Shrink has none");
    scene.int(int::TEXTURE_OP, 0);
    scene.int(int::TEXTURE_FILTER, quality::FAST);
    edge(&mut scene, "one texel is always inside");
    // The border's alpha counts, where all texels are opaque.
    scene.int(int::TEXTURE_FILTER, quality::MID);
    scene.int(int::BLEND, 1);
    scene.color(float::GL_TEXTURE_BORDER_A, [0.0, 1.0, 0.0, 0.0]);
    frame(&mut scene, rect_twice);
    let [_, r, _, _] = channels(scene.pixel(0, 0));
    assert!((60..68).contains(&r), "a quarter of red is left: {r}");
}

#[test]
fn layers_have_borders_and_filters_of_their_own() {
    let mut scene = scene();
    let (base, layer) = (scene.texture_new(1, &[0xff00_0000]), scene.texture_new(1, &[R]));
    scene.texture(base);
    let (context, tag) = (scene.context, pointer::MULTI_TEXTURE);
    scene.int(int::MULTI_TEXTURE_ENABLE, 1);
    scene.call(Call::SetTexture { context, tag, texture: layer });
    scene.int(int::MULTI_TEXTURE_WRAP_U, 1);
    scene.int(int::MULTI_TEXTURE_WRAP_V, 1);
    // Far to the right, in the middle of the texture's height.
    let params = vec![VMultiTexture { inv_w: 1.0, u_over_w: 5.0, v_over_w: 0.5 }; 3];
    scene.call(Call::SubmitMultiTextureParams { context, layer: 0, params });
    let shows = |scene: &mut Scene| {
        frame(scene, |scene| scene.rect_texture(ALL, textured(0.5)));
        scene.pixel(8, 8)
    };
    scene.color(float::MULTI_TEXTURE_BORDER_A, [1.0, 0.0, 0.0, 1.0]);
    assert_eq!(shows(&mut scene), R, "one texel");
    scene.int(int::MULTI_TEXTURE_FILTER, quality::MID);
    assert_eq!(shows(&mut scene), 0xff7f_007f);
    scene.int(int::MULTI_TEXTURE_MAG_FILTER, 0);
    assert_eq!(shows(&mut scene), R, "OpenGL's filter counts from when it is set");
    scene.int(int::MULTI_TEXTURE_MAG_FILTER, 1);
    assert_eq!(shows(&mut scene), 0xff7f_007f);
    scene.int(int::MULTI_TEXTURE_FILTER, quality::FAST);
    assert_eq!(shows(&mut scene), R);
    scene.int(int::MULTI_TEXTURE_WRAP_U, 0);
    scene.int(int::MULTI_TEXTURE_FILTER, quality::MID);
    assert_eq!(shows(&mut scene), R, "no border where it repeats");
}

/// The division by w: half of the texture's width is far left of the middle.
#[test]
fn coordinates_are_divided_by_w() {
    let mut scene = scene();
    let texture = scene.texture_new(2, &[R, G, R, G]);
    scene.texture(texture);
    frame(&mut scene, |scene| {
        let at = |x: f32, y: f32, u: f32, w: f32| VTexture {
            x,
            y,
            inv_w: w,
            u_over_w: u * w,
            v_over_w: 0.5 * w,
            ..textured(0.5)
        };
        let [a, c] = [at(0.0, 0.0, 0.0, 1.0), at(0.0, 16.0, 0.0, 1.0)];
        let [b, d] = [at(16.0, 0.0, 1.0, 0.25), at(16.0, 16.0, 1.0, 0.25)];
        scene.tri_texture([a, b, c]);
        scene.tri_texture([b, d, c]);
    });
    // u = (x/16 * 0.25) / (1 - 0.75 * x/16) reaches a half at x of 12.8.
    assert_eq!([11, 12, 13].map(|x| scene.pixel(x, 8)), [R, R, G]);
}

#[test]
fn a_smaller_picture_takes_a_smaller_level() {
    let mut scene = scene();
    let chain = [
        image(16, &[R; 256]),
        image(8, &[G; 64]),
        image(4, &[B; 16]),
        image(2, &[W; 4]),
        image(1, &[R]),
    ];
    let texture = texture_of(&mut scene, texture::MIPMAP, PixelType::Argb32, &chain).created();
    scene.texture(texture);
    for (side, level) in [(16.0, R), (8.0, G), (4.0, B), (2.0, W), (1.0, R)] {
        frame(&mut scene, |scene| scene.rect_texture([0.0, 0.0, side, side], textured(0.5)));
        assert_eq!(scene.pixel(0, 0), level, "{side}");
    }
    scene.float(float::MIPMAP_BIAS, 1.5);
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert_eq!(scene.pixel(3, 3), G, "a bias of 1.5 is one level");
}

#[test]
fn better_filters_mix() {
    let mut scene = scene();
    let black = 0xff00_0000;
    let texture = scene.texture_new(2, &[black, W, black, W]);
    scene.texture(texture);
    scene.int(int::GL_TEXTURE_WRAP_U, 1);
    for (filter, mixes) in [(0, false), (1, true), (2, true)] {
        scene.int(int::TEXTURE_FILTER, filter);
        frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
        let middle = scene.pixel(7, 8) & 255;
        assert_eq!((1..255).contains(&middle), mixes, "filter {filter}: {middle}");
    }
    scene.int(int::TEXTURE_FILTER, 0);
    scene.int(int::GL_TEXTURE_MAG_FILTER, 1);
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert!((1..255).contains(&(scene.pixel(7, 8) & 255)));
}

#[test]
fn nibbles_and_the_transparent_index() {
    let mut scene = scene();
    let entries: Vec<u8> = (0..16u32).flat_map(|i| (i * 0x0011_0000).to_le_bytes()).collect();
    let table = scene.call(Call::ColorTableNew {
        engine: 1,
        table_type: 1,
        entries: entries.into(),
        transparent_index: 1,
    });
    let table = table.created();
    let image = ImageValue { width: 2, height: 1, pixels: vec![0xf0].into() };
    let texture = texture_of(&mut scene, 0, PixelType::Cl4, &[image]).created();
    let bind = |scene: &mut Scene, table| {
        scene.call(Call::TextureBindColorTable { engine: 1, texture, table })
    };
    assert_eq!(bind(&mut scene, table), Reply::Status(Ok(())));
    scene.texture(texture);
    scene.color(float::COLOR_BG_A, [1.0, 0.0, 1.0, 0.0]);
    scene.int(int::BLEND, 1);
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert_eq!([scene.pixel(4, 4), scene.pixel(12, 4)], [R, G]);
    // What is bound stays, and other tables do not fit.
    scene.call(Call::ColorTableDelete { engine: 1, table });
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert_eq!(scene.pixel(4, 4), R);
    let large = scene.call(Call::ColorTableNew {
        engine: 1,
        table_type: 0,
        entries: vec![0; 1024].into(),
        transparent_index: 0,
    });
    assert_eq!(bind(&mut scene, large.created()), Reply::Status(Err(RaveError::Parameter)));
}

#[test]
fn sizes_are_checked() {
    let mut scene = scene();
    let error = |reply: Reply| match reply {
        Reply::Created(result) => result.err(),
        other => panic!("{other:?}"),
    };
    let odd = image(3, &[R; 6]);
    let reply = texture_of(&mut scene, 0, PixelType::Argb32, std::slice::from_ref(&odd));
    assert_eq!(error(reply), Some(RaveError::Parameter));
    let pixel_type = PixelType::Argb32.number();
    let reply = scene.call(Call::BitmapNew { engine: 1, flags: 0, pixel_type, image: odd });
    assert_eq!(error(reply), None);
    let reply = texture_of(&mut scene, texture::MIPMAP, PixelType::Argb32, &[image(2, &[R; 4])]);
    assert_eq!(error(reply), Some(RaveError::Parameter));
    let short = ImageValue { width: 2, height: 2, pixels: vec![0; 15].into() };
    let reply = texture_of(&mut scene, 0, PixelType::Argb32, &[short]);
    assert_eq!(error(reply), Some(RaveError::Parameter));
    for (width, height) in [(0, 1), (-1, 1), (i32::MAX, i32::MAX), (4096, 1)] {
        let image = ImageValue { width, height, pixels: vec![0; 64].into() };
        assert!(error(texture_of(&mut scene, 0, PixelType::Argb32, &[image])).is_some());
    }
    let reply = scene.call(Call::TextureNew { engine: 7, flags: 0, pixel_type: 4, images: vec![] });
    assert_eq!(error(reply), Some(RaveError::Parameter), "no such engine");
}

#[test]
fn a_deleted_texture_draws_nothing_new() {
    let mut scene = scene();
    let texture = scene.texture_new(1, &[R]);
    scene.texture(texture);
    scene.start();
    scene.rect_texture([0.0, 0.0, 8.0, 16.0], textured(0.5));
    scene.call(Call::TextureDelete { engine: 1, texture });
    scene.rect_texture([8.0, 0.0, 16.0, 16.0], textured(0.5));
    assert_eq!(scene.end(), Err(RaveError::Parameter));
    assert_eq!([scene.pixel(4, 4), scene.pixel(12, 4)], [R, W], "the second as without a texture");
    scene.texture(texture);
    assert_eq!(scene.library.get_texture(scene.id(), pointer::TEXTURE), None);
    let sync = scene.call(Call::Sync { context: scene.context });
    assert_eq!(sync, Reply::Status(Err(RaveError::Parameter)));
}

/// A change after a draw does not reach back.
#[test]
fn what_was_submitted_keeps_its_texels() {
    for asynchronous in [false, true] {
        let config = RaveConfig { asynchronous, ..config() };
        let mut scene = Scene::with(config, 16, 16, PixelType::Rgb32, DOUBLE_BUFFER);
        let texture = scene.texture_new(1, &[R]);
        scene.texture(texture);
        frame(&mut scene, |scene| {
            scene.rect_texture([0.0, 0.0, 8.0, 16.0], textured(0.5));
            let context = Call::AccessTexture { engine: 1, texture, level: 0, flags: 0 };
            assert_eq!(scene.call(context), Reply::Status(Ok(())));
            let (pixel_type, level) = scene.library.accessed_texture(TextureId(texture)).unwrap();
            assert_eq!((pixel_type, &*level.pixels), (PixelType::Argb32, &[0u8, 0, 255, 255][..]));
            let (rect, pixels) = (RaveRect::new(0, 0, 1, 1), B.to_le_bytes().to_vec().into());
            let end = Call::AccessTextureEnd { engine: 1, texture, rect, pixels };
            assert_eq!(scene.call(end), Reply::Status(Ok(())));
            scene.rect_texture([8.0, 0.0, 16.0, 16.0], textured(0.5));
        });
        assert_eq!([scene.pixel(4, 4), scene.pixel(12, 4)], [R, B]);
    }
}

#[test]
fn a_frame_becomes_a_texture() {
    let mut scene = scene();
    let screen = scene.context;
    scene.context = scene.call(context_new(8, 8, PixelType::Rgb16, DOUBLE_BUFFER)).created();
    let (context, flags) = (scene.context, 0);
    let texture = scene.call(Call::TextureFromContext { context, flags }).created();
    for (color, expected) in [([1.0, 0.0, 0.0], R), ([0.0, 1.0, 0.0], G)] {
        scene.context = context;
        frame(&mut scene, |scene| scene.rect([0.0, 0.0, 8.0, 8.0], colored(color, 0.5)));
        scene.context = screen;
        scene.texture(texture);
        frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
        assert_eq!(scene.pixel(5, 5), expected);
    }
    let odd = scene.call(context_new(9, 8, PixelType::Rgb16, DOUBLE_BUFFER)).created();
    let reply = scene.call(Call::TextureFromContext { context: odd, flags });
    assert_eq!(reply, Reply::Created(Err(RaveError::Parameter)));
    assert_ne!(scene.call(Call::BitmapFromContext { context: odd, flags }).created(), 0);
}

#[test]
fn bitmaps_are_cut_and_scaled() {
    let mut scene = scene();
    let pixel_type = PixelType::Argb32.number();
    let picture = image(3, &[R, G, B, W, W, W]);
    let bitmap =
        scene.call(Call::BitmapNew { engine: 1, flags: 0, pixel_type, image: picture }).created();
    let draw = |scene: &mut Scene, x: f32, y: f32| {
        let v = VGouraud { x, y, ..colored([0.0; 3], 0.5) };
        scene.call(Call::DrawBitmap { context: scene.context, v, bitmap });
    };
    frame(&mut scene, |scene| {
        draw(scene, -1.0, 3.0);
        draw(scene, 14.0, -1.0);
        draw(scene, 5.4, 5.6);
    });
    assert_eq!([0, 1, 2].map(|x| scene.pixel(x, 3)), [G, B, 0xff00_0000]);
    assert_eq!([13, 14, 15].map(|x| scene.pixel(x, 0)), [0xff00_0000, W, W]);
    assert_eq!([4, 5, 6, 7, 8].map(|x| scene.pixel(x, 6)), [0xff00_0000, R, G, B, 0xff00_0000]);
    scene.float(float::BITMAP_SCALE_X, 4.0);
    scene.float(float::BITMAP_SCALE_Y, 2.0);
    frame(&mut scene, |scene| draw(scene, 0.0, 0.0));
    assert_eq!([3, 4, 8, 11, 12].map(|x| scene.pixel(x, 1)), [R, G, B, B, 0xff00_0000]);
    assert_eq!([scene.pixel(0, 3), scene.pixel(0, 4)], [W, 0xff00_0000]);
}

#[test]
fn a_color_can_be_cut_out() {
    let mut scene = scene();
    let texture = scene.texture_new(2, &[R, G, B, W]);
    scene.texture(texture);
    scene.int(int::CHROMAKEY_ENABLE, 1);
    scene.float(float::CHROMAKEY_G, 1.0);
    frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
    assert_eq!(quarters(&mut scene), [R, 0xff00_0000, B, W]);
}

#[test]
fn layers_join_in_order() {
    let mut scene = scene();
    let base = scene.texture_new(1, &[0xff80_4020]);
    let layer = scene.texture_new(1, &[0x80ff_8040]);
    let product = |a: u32, b: u32| (a * (b + 1)) >> 8;
    let mix = |c: u32, t: u32, f: u32| {
        ((((c as i32 - t as i32) * (256 - f as i32)) >> 8) + t as i32) as u32
    };
    let expected = |op: u32, c: u32, t: u32| match op {
        multi_texture::ADD => (c + t).min(255),
        multi_texture::MODULATE => product(c, t),
        multi_texture::BLEND_ALPHA => mix(c, t, 0x80),
        _ => mix(c, t, 64),
    };
    scene.texture(base);
    scene.int(int::MULTI_TEXTURE_ENABLE, 1);
    scene.call(Call::SetTexture {
        context: scene.context,
        tag: pointer::MULTI_TEXTURE,
        texture: layer,
    });
    scene.float(float::MULTI_TEXTURE_FACTOR, 0.25);
    let params = vec![VMultiTexture { inv_w: 1.0, u_over_w: 0.5, v_over_w: 0.5 }; 3];
    scene.call(Call::SubmitMultiTextureParams { context: scene.context, layer: 0, params });
    for op in 0..4 {
        scene.int(int::MULTI_TEXTURE_OP, op);
        frame(&mut scene, |scene| scene.rect_texture(ALL, textured(0.5)));
        let [r, g, b] = [(0x80, 0xff), (0x40, 0x80), (0x20, 0x40)].map(|(c, t)| expected(op, c, t));
        assert_eq!(scene.pixel(4, 4), 0xff00_0000 | r << 16 | g << 8 | b, "operation {op}");
    }
    // Too few parameters are an error.
    scene.call(Call::SubmitMultiTextureParams { context: scene.context, layer: 0, params: vec![] });
    scene.start();
    scene.rect_texture(ALL, textured(0.5));
    assert_eq!(scene.end(), Err(RaveError::Parameter));
}

#[test]
fn meshes_refer_to_what_is_submitted() {
    let mut scene = scene();
    let corner = |x: f32, y: f32| VGouraud { x, y, ..colored([1.0, 0.0, 0.0], 0.5) };
    let vertices = vec![corner(0.0, 0.0), corner(16.0, 0.0), corner(0.0, 16.0), corner(16.0, 16.0)];
    scene.call(Call::SubmitVerticesGouraud { context: scene.context, vertices });
    let triangle = |a, b, c| IndexedTriangle { flags: 0, vertices: [a, b, c] };
    scene.start();
    let triangles = vec![triangle(0, 1, 2), triangle(1, 3, 4), triangle(1, 3, 2)];
    scene.call(Call::DrawTriMeshGouraud { context: scene.context, triangles });
    assert_eq!(scene.end(), Err(RaveError::Parameter), "there is no vertex 4");
    assert_eq!(quarters(&mut scene), [R; 4]);
}

#[test]
fn memory_is_limited_and_told() {
    let memory =
        MemoryConfig { kind: EngineKind::VideoOnly, video_bytes: 4096, ..Default::default() };
    let config = RaveConfig { memory, ..config() };
    let mut scene = Scene::with(config, 16, 16, PixelType::Rgb32, DOUBLE_BUFFER);
    let free = |scene: &mut Scene| {
        scene.library.gestalt(EngineId::BUILT_IN, selector::FAST_TEXTURE_MEMORY).unwrap()
    };
    assert_eq!(free(&mut scene), Answer::Number(4096));
    let large = scene.texture_new(16, &[R; 256]);
    let next = scene.texture_new(32, &[G; 1024]);
    assert_eq!((free(&mut scene), next), (Answer::Number(4096 - 1024), 0));
    scene.texture(large);
    scene.start();
    scene.rect_texture(ALL, textured(0.5));
    scene.call(Call::TextureDelete { engine: 1, texture: large });
    scene.texture(0);
    // Room is made by waiting for the polygons.
    assert_ne!(scene.texture_new(32, &[G; 1024]), 0);
    assert_eq!(scene.end(), Ok(()));
    assert_eq!(scene.pixel(4, 4), R);
}
