//! Triangles launched register by register.
//!
//! Source: SST1, triangle registers; indices count words from the start of the
//! register map.

use fillrate_engine::{Param, Registers, WideParam, fixed};

use crate::board::Board;
use crate::draw::launch::{after_launch, without_adjustment};
use crate::registers::color_path;

/// Which of a parameter's three registers.
#[derive(Clone, Copy)]
enum Slot {
    Start,
    Dx,
    Dy,
}

/// What a register of the triangle set-up holds.
#[derive(Clone, Copy)]
enum Field {
    /// Corner's x or y: number of the corner, and whether it is y.
    Corner(usize, bool),
    /// Parameter by place: red, green, blue, z, alpha, s, t, w.
    Parameter(u32, Slot),
}

/// The field of a register counted from the first of its block (fixed or
/// float).
fn field(index: u32) -> Field {
    match index {
        0..6 => Field::Corner(index as usize / 2, !index.is_multiple_of(2)),
        6..14 => Field::Parameter(index - 6, Slot::Start),
        14..22 => Field::Parameter(index - 14, Slot::Dx),
        _ => Field::Parameter(index - 22, Slot::Dy),
    }
}

fn narrow(param: &mut Param, slot: Slot) -> &mut i32 {
    match slot {
        Slot::Start => &mut param.start,
        Slot::Dx => &mut param.dx,
        Slot::Dy => &mut param.dy,
    }
}

fn wide(param: &mut WideParam, slot: Slot) -> &mut i64 {
    match slot {
        Slot::Start => &mut param.start,
        Slot::Dx => &mut param.dx,
        Slot::Dy => &mut param.dy,
    }
}

/// The value of a fixed-point register: colours are 12.12 in 24 bits, z is
/// 20.12.
fn fixed_value(place: u32, value: u32) -> i32 {
    if place == 3 { value as i32 } else { (value << 8) as i32 >> 8 }
}

/// The value of a fixed-point s or t (14.18) or w (2.30) with 32 fraction
/// bits.
fn fixed_wide(place: u32, value: u32) -> i64 {
    i64::from(value as i32) << if place == 7 { 2 } else { 14 }
}

impl Board {
    /// Writes a register of the triangle set-up, 2..=31 in fixed point or
    /// 34..=63 as a float. `units` are the texture units reached, and `pixel`
    /// says whether the pixel chip is.
    pub(crate) fn write_set_up(
        &mut self,
        register: u32,
        value: u32,
        units: core::ops::Range<usize>,
        pixel: bool,
    ) {
        let float = (register >= 34).then(|| f32::from_bits(value));
        let index = if float.is_some() { register - 34 } else { register - 2 };
        let to = &mut self.set_up;
        match field(index) {
            Field::Corner(corner, is_y) if pixel => {
                let axis = if is_y { &mut to.y } else { &mut to.x };
                axis[corner] = float.map_or(i32::from(value as i16), fixed::coord);
            }
            Field::Parameter(place @ (0..=2 | 4), slot) if pixel => {
                // Alpha comes after z here, and after blue in the engine.
                let param = &mut to.color[place.min(3) as usize];
                *narrow(param, slot) = float.map_or(fixed_value(place, value), fixed::color);
            }
            Field::Parameter(3, slot) if pixel => {
                *narrow(&mut to.z, slot) = float.map_or(fixed_value(3, value), fixed::depth);
            }
            Field::Parameter(place @ 5..=7, slot) => {
                let value = float.map_or(fixed_wide(place, value), fixed::wide);
                for unit in units {
                    *wide(&mut to.tmu[unit][place as usize - 5], slot) = value;
                }
                if place == 7 && pixel {
                    *wide(&mut to.w, slot) = value;
                }
            }
            _ => {}
        }
    }

    /// Launches the triangle in the registers. Bit 31 of the command is the
    /// sign of its area. The start registers keep what the sub-pixel
    /// adjustment, where it is on, made of them.
    pub(crate) fn launch_set_up(&mut self, command: u32) {
        self.update();
        let registers = Registers { negative: command >> 31 != 0, ..self.set_up };
        if self.fbi.fbz_color_path & color_path::PARAMETER_ADJUST == 0 {
            return self.launch_helper(&without_adjustment(&registers));
        }
        self.launch_helper(&registers);
        self.set_up = after_launch(&registers);
    }
}

#[cfg(test)]
mod tests {
    use crate::{Call, Context, GlideConfig, GrVertex};
    use fillrate_engine::DeviceConfig;
    use fillrate_engine::setup::{Outcome, triangle};
    use fillrate_engine::{Cull, Registers};

    fn glide() -> Context {
        let device = DeviceConfig { threads: 1, ..DeviceConfig::default() };
        let mut glide =
            Context::new(GlideConfig { device, ..GlideConfig::default() }).expect("a board");
        glide.execute(&Call::GrGlideInit {});
        let open = Call::GrSstWinOpen {
            window: 0,
            resolution: 1,
            refresh: 0,
            color_format: 0,
            origin: 0,
            colors: 2,
            aux: 1,
        };
        assert_eq!(glide.execute(&open), 1);
        glide.execute(&Call::GrDepthBufferMode { mode: 2 });
        glide.execute(&Call::GrDepthMask { mask: 1 });
        glide.execute(&Call::GrBufferClear { color: 0, alpha: 0, depth: 0xffff });
        glide
    }

    fn corners() -> [GrVertex; 3] {
        [(20.25, 30.5), (200.75, 60.0), (90.0, 180.125)].map(|(x, y)| GrVertex {
            x,
            y,
            r: x,
            g: y,
            b: 255.0 - x,
            a: 128.0,
            oow: 1.0 / (2.0 + y / 16.0),
            ..GrVertex::default()
        })
    }

    fn write(glide: &mut Context, register: u32, value: u32) {
        glide.execute(&Call::GrSstConfigPipeline { chip: 3, register, value });
    }

    fn planes(glide: &mut Context) -> [Vec<u16>; 2] {
        [1, 2].map(|b| glide.lfb_read_region(b, (0, 0), (320, 240)).expect("a buffer"))
    }

    fn set_up(glide: &Context) -> Registers {
        let [a, b, c] = corners().map(|v| glide.boards[0].rules.convert(&v));
        match triangle([&a, &b, &c], Cull::Disabled, 2) {
            Outcome::Drawn(registers) => registers,
            other => panic!("{other:?}"),
        }
    }

    /// The same triangle by call, by fixed-point and by float registers.
    #[test]
    fn raw_registers_draw_what_the_call_draws() {
        let mut by_call = glide();
        let [a, b, c] = corners();
        by_call.execute(&Call::GrDrawTriangle { a, b, c });
        let expected = planes(&mut by_call);
        let r = set_up(&by_call);
        assert!(expected[0].iter().filter(|&&p| p != 0).count() > 5000);

        let mut fixed = glide();
        for i in 0..3 {
            write(&mut fixed, 2 + 2 * i, r.x[i as usize] as u32);
            write(&mut fixed, 3 + 2 * i, r.y[i as usize] as u32);
        }
        for (i, place) in [0, 1, 2, 4].into_iter().enumerate() {
            let p = r.color[i];
            for (block, v) in [8, 16, 24].into_iter().zip([p.start, p.dx, p.dy]) {
                write(&mut fixed, block + place, v as u32 & 0xff_ffff);
            }
        }
        // Two bits less than the engine's: written so that none is lost.
        let w = r.w;
        let two_bits = [w.start, w.dx, w.dy].iter().all(|v| v & 3 == 0);
        for (block, v) in [8, 16, 24].into_iter().zip([w.start, w.dx, w.dy]) {
            write(&mut fixed, block + 7, (v >> 2) as u32);
        }
        write(&mut fixed, 32, u32::from(r.negative) << 31);
        let drawn = planes(&mut fixed);
        assert_eq!(drawn[0], expected[0]);
        // The depth of the last bits of w may be one off.
        let near = drawn[1].iter().zip(&expected[1]).all(|(a, b)| a.abs_diff(*b) <= 1);
        assert!(near && (!two_bits || drawn[1] == expected[1]));
    }

    #[test]
    fn float_registers_convert_as_the_chip_does() {
        let mut glide = glide();
        let vertices = [(10.0, 10.0), (60.0, 10.0), (10.0, 60.0)];
        for (i, (x, y)) in vertices.into_iter().enumerate() {
            write(&mut glide, 34 + 2 * i as u32, f32::to_bits(x));
            write(&mut glide, 35 + 2 * i as u32, f32::to_bits(y));
        }
        // Red 255, steps 0; w 1/4.
        write(&mut glide, 40, 255f32.to_bits());
        write(&mut glide, 47, 0.25f32.to_bits());
        // B is right of the edge from A to C: a positive area.
        write(&mut glide, 64, 0);
        let [pixels, depths] = planes(&mut glide);
        assert_eq!(pixels[20 * 320 + 20], 0xf800);
        assert!(depths[20 * 320 + 20] < 0xffff);
        assert_eq!(pixels[50 * 320 + 50], 0);
    }

    /// Corners in any order and extreme values: bounded work, no panic.
    #[test]
    fn nonsense_in_the_registers_is_harmless() {
        let mut glide = glide();
        let mut random = 7u32;
        for _ in 0..4000 {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let register = (random >> 8) % 240;
            let value = random.rotate_left(13) ^ 0x5bd1_e995;
            let chip = (random >> 28) as i32 % 5;
            glide.execute(&Call::GrSstConfigPipeline { chip, register, value });
            if random.is_multiple_of(16) {
                write(&mut glide, 32, value);
            }
        }
        glide.shown();
    }
}
