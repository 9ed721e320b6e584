//! Fragments of known values against the naive model, bit for bit.

use fillrate_rave::constants::context::{DOUBLE_BUFFER, NO_DITHER};
use fillrate_rave::tags::{float, int};
use fillrate_rave::{PixelType, VGouraud, VTexture};

use crate::model::{Fragment, Model, Pixel};
use crate::scene::{Scene, config};

/// Cells across and down.
const CELLS: u32 = 8;
/// Pixels of a cell's side.
const CELL: u32 = 5;

/// Numbers that follow from a seed.
pub struct Dice(pub u64);

impl Dice {
    pub fn below(&mut self, limit: u32) -> u32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(limit)) as u32
    }

    fn byte(&mut self) -> u32 {
        // The ends matter most.
        match self.below(4) {
            0 => 0,
            1 => 255,
            _ => self.below(256),
        }
    }

    fn bytes<const N: usize>(&mut self) -> [u32; N] {
        core::array::from_fn(|_| self.byte())
    }

    fn of(&mut self, choices: &[u32]) -> u32 {
        choices[self.below(choices.len() as u32) as usize]
    }
}

/// A float that becomes this many 255ths.
fn unit(byte: u32) -> f32 {
    // More than 1 would be another rule of modulation.
    if byte == 255 { 1.0 } else { (byte as f32 + 0.25) / 255.0 }
}

fn model(dice: &mut Dice) -> Model {
    const FACTORS: [u32; 8] = [0, 1, 0x302, 0x303, 0x304, 0x305, 0x306, 0x307];
    const TO: [u32; 8] = [0, 1, 0x300, 0x301, 0x302, 0x303, 0x304, 0x305];
    Model {
        op: dice.below(32) & !8,
        blend: dice.below(3),
        gl: (dice.of(&FACTORS), dice.of(&TO)),
        alpha_test: (dice.of(&[0, 0, 1, 2, 3, 4, 5, 6, 7]), dice.byte()),
        z_function: dice.below(9),
        z_mask: dice.below(2) != 0,
        channels: dice.of(&[15, 15, 7, 8, 5, 0]),
        alpha_fog: (dice.below(4) == 0).then(|| dice.bytes()),
        env: dice.bytes(),
    }
}

fn set(scene: &mut Scene, model: &Model) {
    let color = |[r, g, b]: [u32; 3]| [0.0, unit(r), unit(g), unit(b)];
    for (tag, value) in [
        (int::TEXTURE_OP, model.op),
        (int::BLEND, model.blend),
        (int::GL_BLEND_SRC, model.gl.0),
        (int::GL_BLEND_DST, model.gl.1),
        (int::ALPHA_TEST_FUNC, model.alpha_test.0),
        (int::Z_FUNCTION, model.z_function),
        (int::Z_BUFFER_MASK, u32::from(model.z_mask)),
        (int::CHANNEL_MASK, model.channels),
        (int::FOG_MODE, u32::from(model.alpha_fog.is_some())),
    ] {
        scene.int(tag, value);
    }
    scene.float(float::ALPHA_TEST_REF, unit(model.alpha_test.1));
    scene.color(float::FOG_COLOR_A, color(model.alpha_fog.unwrap_or_default()));
    scene.color(float::GL_TEXTURE_ENV_COLOR_A, color(model.env));
}

fn draw(scene: &mut Scene, at: [f32; 4], f: &Fragment) {
    let [r, g, b, a] = f.v.map(unit);
    let z = (f.z as f32 + 0.25) / 65_535.0;
    let Some([tr, tg, tb, ta]) = f.texel else {
        scene.texture(0);
        return scene.rect(at, VGouraud { z, inv_w: 1.0, r, g, b, a, ..VGouraud::default() });
    };
    let texture = scene.texture_new(1, &[ta << 24 | tr << 16 | tg << 8 | tb]);
    scene.texture(texture);
    let ([kd_r, kd_g, kd_b], [ks_r, ks_g, ks_b]) = (f.kd.map(unit), f.ks.map(unit));
    let v = VTexture { z, inv_w: 1.0, r, g, b, a, ..VTexture::default() };
    scene.rect_texture(at, VTexture { kd_r, kd_g, kd_b, ks_r, ks_g, ks_b, ..v });
}

fn fragment(dice: &mut Dice) -> Fragment {
    let kd = match dice.below(3) {
        0 => dice.bytes().map(|k: u32| k * dice.below(8)),
        _ => dice.bytes(),
    };
    let texel = (dice.below(4) != 0).then(|| dice.bytes());
    Fragment { v: dice.bytes(), texel, kd, ks: dice.bytes(), z: dice.below(4) * 20_000 }
}

fn check(pixel_type: PixelType, seed: u64) {
    let side = CELLS * CELL;
    let mut scene = Scene::with(config(), side, side, pixel_type, DOUBLE_BUFFER | NO_DITHER);
    let mut dice = Dice(seed);
    let background: [u32; 4] = dice.bytes();
    let [r, g, b, a] = background.map(unit);
    scene.color(float::COLOR_BG_A, [a, r, g, b]);
    scene.start();
    let has_alpha = pixel_type == PixelType::Argb32;
    let mut cells = Vec::new();
    for cell in 0..CELLS * CELLS {
        let (x, y) = ((cell % CELLS * CELL) as f32, (cell / CELLS * CELL) as f32);
        let mut pixel = Pixel { rgba: background, z: 65_535 };
        let mut story = Vec::new();
        for _ in 0..3 {
            let (model, fragment) = (model(&mut dice), fragment(&mut dice));
            set(&mut scene, &model);
            draw(&mut scene, [x, y, x + CELL as f32, y + CELL as f32], &fragment);
            model.draw(&fragment, &mut pixel, has_alpha);
            story.push((model, fragment, pixel));
        }
        cells.push((pixel, story));
    }
    assert_eq!(scene.end(), Ok(()));
    let shown = scene.library.shown().expect("a frame is shown");
    for (cell, (pixel, story)) in cells.iter().enumerate() {
        let (x, y) = (cell as u32 % CELLS * CELL, cell as u32 / CELLS * CELL);
        let [r, g, b, a] = pixel.rgba;
        let expected = (if has_alpha { a } else { 255 }) << 24 | r << 16 | g << 8 | b;
        for (dx, dy) in [(0, 0), (2, 2), (4, 4), (4, 0)] {
            let actual = shown.argb(x + dx, y + dy);
            assert_eq!(
                actual, expected,
                "{actual:08x} {expected:08x} seed {seed} cell {cell}: {story:#?}"
            );
        }
    }
}

#[test]
fn fragments_follow_the_model_with_alpha() {
    (0..12).for_each(|seed| check(PixelType::Argb32, seed));
}

#[test]
fn fragments_follow_the_model_without_alpha() {
    (100..112).for_each(|seed| check(PixelType::Rgb32, seed));
}
