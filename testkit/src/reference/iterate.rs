//! Iterators: the value of every parameter at every pixel.
//!
//! Source: SST1, triangle registers and sub-pixel correction.

use fillrate_engine::{Param, Registers, WideParam};

/// The registers with all start values moved from the first vertex to the
/// centre of the pixel that holds it.
pub fn centred(registers: &Registers) -> Registers {
    let dx = 8 - (registers.x[0] & 15);
    let dy = 8 - (registers.y[0] & 15);
    let mut out = *registers;
    let narrow = out.color.iter_mut().chain([&mut out.z]);
    for param in narrow {
        let moved = dx.wrapping_mul(param.dx).wrapping_add(dy.wrapping_mul(param.dy)) >> 4;
        param.start = param.start.wrapping_add(moved);
    }
    let (dx, dy) = (i64::from(dx), i64::from(dy));
    for param in out.tmu.as_flattened_mut().iter_mut().chain([&mut out.w]) {
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
    centred.color.map(|param| match narrow(centred, &param, x, y) >> 12 & 0xfff {
        0xfff => 0,
        0x100 => 0xff,
        value => value & 0xff,
    })
}

/// z, 16 bits, wrapping like the colours.
pub fn z(centred: &Registers, x: u32, y: u32) -> i32 {
    match narrow(centred, &centred.z, x, y) >> 12 & 0xf_ffff {
        0xf_ffff => 0,
        0x1_0000 => 0xffff,
        value => value & 0xffff,
    }
}

/// 1/w of the pixel pipeline.
pub fn w(centred: &Registers, x: u32, y: u32) -> i64 {
    wide(centred, &centred.w, x, y)
}
