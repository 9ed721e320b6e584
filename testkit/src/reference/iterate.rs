//! Iterators: the value of every parameter at every pixel.
//!
//! Source: SST1, triangle registers and sub-pixel correction.

use fillrate_engine::state::ZOverflow;
use fillrate_engine::{Param, Registers, WideParam};

/// The registers with all start values moved from the first vertex to the
/// centre of the pixel that holds it.
pub fn centred(registers: &Registers) -> Registers {
    let dx = 8 - (registers.x[0] & 15);
    let dy = 8 - (registers.y[0] & 15);
    let mut out = *registers;
    let second = out.specular.iter_mut().chain(&mut out.base);
    let narrow = out.color.iter_mut().chain([&mut out.z]).chain(second);
    for param in narrow {
        let moved = dx.wrapping_mul(param.dx).wrapping_add(dy.wrapping_mul(param.dy)) >> 4;
        param.start = param.start.wrapping_add(moved);
    }
    let (dx, dy) = (i64::from(dx), i64::from(dy));
    let wide = out.tmu.as_flattened_mut().iter_mut();
    for param in wide.chain([&mut out.w, &mut out.deep_z]) {
        let moved = dx.wrapping_mul(param.dx).wrapping_add(dy.wrapping_mul(param.dy)) >> 4;
        param.start = param.start.wrapping_add(moved);
    }
    out
}

/// Columns and rows from the first vertex's pixel to (x, y).
fn offset(registers: &Registers, x: u32, y: u32) -> (i32, i32) {
    ((x as i32).wrapping_sub(registers.x[0] >> 4), (y as i32).wrapping_sub(registers.y[0] >> 4))
}

fn narrow(registers: &Registers, param: &Param, x: u32, y: u32) -> i32 {
    let (columns, rows) = offset(registers, x, y);
    param
        .start
        .wrapping_add(columns.wrapping_mul(param.dx))
        .wrapping_add(rows.wrapping_mul(param.dy))
}

/// A wide iterator at drawing coordinates (x, y), 32 fraction bits.
pub fn wide(registers: &Registers, param: &WideParam, x: u32, y: u32) -> i64 {
    let (columns, rows) = offset(registers, x, y);
    param
        .start
        .wrapping_add(i64::from(columns).wrapping_mul(param.dx))
        .wrapping_add(i64::from(rows).wrapping_mul(param.dy))
}

/// Red, green, blue and alpha, 8 bits. One step below 0 is still 0, one above
/// 255 still 255; beyond, values wrap.
pub fn colors(centred: &Registers, x: u32, y: u32) -> [i32; 4] {
    centred.color.map(|param| wrapped(narrow(centred, &param, x, y)))
}

/// The second colour and the fog factor, the same way.
pub fn second(centred: &Registers, x: u32, y: u32) -> [i32; 4] {
    centred.specular.map(|param| wrapped(narrow(centred, &param, x, y)))
}

/// The third colour, the same way.
pub fn third(centred: &Registers, x: u32, y: u32) -> [i32; 3] {
    centred.base.map(|param| wrapped(narrow(centred, &param, x, y)))
}

/// Red, green and blue as signed 12-bit integers.
pub fn whole_colors(centred: &Registers, x: u32, y: u32) -> [i32; 3] {
    let [r, g, b, _] = centred.color;
    [r, g, b].map(|param| narrow(centred, &param, x, y) << 8 >> 20)
}

fn wrapped(value: i32) -> i32 {
    match value >> 12 & 0xfff {
        0xfff => 0,
        0x100 => 0xff,
        value => value & 0xff,
    }
}

/// z, 16 bits, wrapping like the colours or limited.
pub fn z(centred: &Registers, overflow: ZOverflow, x: u32, y: u32) -> i32 {
    let whole = narrow(centred, &centred.z, x, y) >> 12;
    if overflow != ZOverflow::Wrap {
        return whole.clamp(0, 0xffff);
    }
    match whole & 0xf_ffff {
        0xf_ffff => 0,
        0x1_0000 => 0xffff,
        value => value & 0xffff,
    }
}

/// Whether z is no 16-bit number.
pub fn is_z_outside(centred: &Registers, x: u32, y: u32) -> bool {
    !(0..=0xffff).contains(&(narrow(centred, &centred.z, x, y) >> 12))
}

/// 1/w of the pixel pipeline.
pub fn w(centred: &Registers, x: u32, y: u32) -> i64 {
    wide(centred, &centred.w, x, y)
}
