//! Integer mathematics: angles of 8192 to a turn, unit length 16384.
//!
//! Source: QK, math functions. Results are exact or correctly rounded, which
//! the document only promises within one or two per cent.

/// Bits of an angle.
pub const ANGLE_SHIFT: u32 = 13;
/// A whole turn.
pub const ANGLE2PI: i32 = 1 << ANGLE_SHIFT;
/// Fraction bits of sines, unit vectors and matrix rotations.
pub const TRIGO_SHIFT: u32 = 14;
/// The length of a unit vector.
pub const TRIGO_MUL: i32 = 1 << TRIGO_SHIFT;
/// Texture coordinate units of one repeat.
pub const UV_MUL: i32 = 256;

const QUARTER: usize = ANGLE2PI as usize / 4;
const RADIANS: f64 = core::f64::consts::TAU / ANGLE2PI as f64;

/// Degrees as an angle, without a division: slightly low, and wrapping beyond
/// 46,080 degrees. Source: QK, `DEGREE`.
pub const fn degree(degrees: i32) -> i32 {
    degrees.wrapping_mul(46_603) >> 11
}

/// Sine and cosine of 0..=pi/2 by their series, in plain arithmetic, so that
/// the tables are the same on every machine.
const fn series(angle: f64) -> (f64, f64) {
    let square = angle * angle;
    let (mut sine, mut cosine) = (1.0, 1.0);
    let mut n = 24.0;
    while n > 1.0 {
        sine = 1.0 - square / (n * (n + 1.0)) * sine;
        cosine = 1.0 - square / (n * (n - 1.0)) * cosine;
        n -= 2.0;
    }
    (sine * angle, cosine)
}

/// Sines of the first quarter turn, both ends included.
static SINES: [i16; QUARTER + 1] = {
    let mut table = [0; QUARTER + 1];
    let mut a = 0;
    while a <= QUARTER {
        let (sine, _) = series(a as f64 * RADIANS);
        table[a] = (sine * TRIGO_MUL as f64 + 0.5) as i16;
        a += 1;
    }
    table
};

/// Tangents of the angles half-way between whole ones up to an eighth of a
/// turn, 32 fraction bits.
static TANGENTS: [u64; QUARTER / 2] = {
    let mut table = [0; QUARTER / 2];
    let mut a = 0;
    while a < QUARTER / 2 {
        let (sine, cosine) = series((a as f64 + 0.5) * RADIANS);
        table[a] = (sine / cosine * 4_294_967_296.0 + 0.5) as u64;
        a += 1;
    }
    table
};

/// Sine of an angle, -16384..=16384, rounded to nearest; any angle.
/// Source: QK, `SINUS`.
pub fn sinus(angle: i32) -> i16 {
    let a = (angle & (ANGLE2PI - 1)) as usize;
    match (a / QUARTER, a % QUARTER) {
        (0, at) => SINES[at],
        (1, at) => SINES[QUARTER - at],
        (2, at) => -SINES[at],
        (_, at) => -SINES[QUARTER - at],
    }
}

/// Cosine of an angle, -16384..=16384. Source: QK, `COSINUS`.
pub fn cosinus(angle: i32) -> i16 {
    sinus(angle.wrapping_add(QUARTER as i32))
}

/// The square root, rounded down; 0 for negative numbers.
/// Source: QK, `Sqrti`.
pub fn sqrti(a: i32) -> i32 {
    if a <= 0 { 0 } else { a.isqrt() }
}

/// The angle of the vector (x, y), -4095..=4096, to the nearest whole one;
/// 0 for the null vector. Source: QK, `Atan2i`.
pub fn atan2i(x: i32, y: i32) -> i32 {
    let (ax, ay) = (u64::from(x.unsigned_abs()), u64::from(y.unsigned_abs()));
    if (ax, ay) == (0, 0) {
        return 0;
    }
    let octant = |over: u64, under: u64| {
        let tangent = (over << 32) / under;
        TANGENTS.partition_point(|&half| half <= tangent) as i32
    };
    let quarter = QUARTER as i32;
    let first = if ay <= ax { octant(ay, ax) } else { quarter - octant(ax, ay) };
    let upper = if x < 0 { 2 * quarter - first } else { first };
    if y < 0 && upper < 2 * quarter { -upper } else { upper }
}

/// The base-2 logarithm, rounded down; 0 for numbers below 1.
/// Source: QK, `Log2`.
pub fn log2(a: i32) -> i32 {
    if a <= 0 { 0 } else { a.ilog2() as i32 }
}

/// Whole repeats that all three coordinates have in common, in units.
pub(crate) fn common_repeats(values: [i32; 3]) -> i64 {
    let least = values.into_iter().min().unwrap_or(0);
    i64::from(least.div_euclid(UV_MUL)) * i64::from(UV_MUL)
}

/// Takes from three (u, v) pairs the whole repeats they have in common, so
/// that the least u and the least v are 0..=255. What does not fit a `short`
/// then becomes the greatest one. Source: QK, `ConvertUv`.
pub fn convert_uv(uv: &mut [i16; 6]) {
    for axis in 0..2 {
        let values = [uv[axis], uv[axis + 2], uv[axis + 4]].map(i32::from);
        let offset = common_repeats(values);
        for (corner, value) in values.into_iter().enumerate() {
            let moved = (i64::from(value) - offset).min(i64::from(i16::MAX));
            uv[axis + 2 * corner] = moved as i16;
        }
    }
}

/// Scales a vector to length 16384, each component rounded to nearest; the
/// null vector stays. Source: QK, `Normalize`.
pub fn normalize(vector: &mut [i32; 3]) {
    let square = |n: i32| u128::from(n.unsigned_abs()).pow(2);
    let length: u128 = vector.iter().map(|&n| square(n)).sum();
    if length == 0 {
        return;
    }
    for n in vector {
        // Twice the component, rounded down, decides the rounding exactly.
        let twice = ((square(*n) << (2 * TRIGO_SHIFT + 2)) / length).isqrt();
        *n = twice.div_ceil(2) as i32 * n.signum();
    }
}

/// A vector perpendicular to the plane of A, B, C, towards whoever sees them
/// counter-clockwise: (B - A) x (C - A), halved until no longer than 32768.
/// Source: QK, `DefUNormal`.
pub fn def_u_normal(a: &[i32; 3], b: &[i32; 3], c: &[i32; 3]) -> [i32; 3] {
    let from_a = |p: &[i32; 3], i: usize| i128::from(p[i]) - i128::from(a[i]);
    let component = |i: usize, j: usize| from_a(b, i) * from_a(c, j) - from_a(b, j) * from_a(c, i);
    let mut normal = [component(1, 2), component(2, 0), component(0, 1)];
    const LIMIT: i128 = 32_768;
    // Products of 33-bit numbers have at most 67 bits, so squares could
    // overflow: first by components, then by length.
    while normal.iter().any(|n| n.abs() > LIMIT)
        || normal.iter().map(|n| n * n).sum::<i128>() > LIMIT * LIMIT
    {
        normal = normal.map(|n| n / 2);
    }
    normal.map(|n| n as i32)
}

/// A number in decimal. Source: QK, `Itoa`.
pub fn itoa(a: i32) -> String {
    a.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// xorshift; enough for arguments.
    fn random(count: usize) -> impl Iterator<Item = i32> {
        let mut x = 0x2545_f491_4f6c_dd1du64;
        std::iter::from_fn(move || {
            x ^= x << 13;
            x ^= x >> 7;
            x ^= x << 17;
            // All magnitudes alike.
            Some((x >> 32) as i32 >> (x & 31))
        })
        .take(count)
    }

    #[test]
    fn degrees_as_documented() {
        let angles = [45, 90, 180, 360, -90].map(degree);
        assert_eq!(angles, [1023, 2047, 4095, 8191, -2048]);
        degree(i32::MAX);
    }

    #[test]
    fn sines_are_rounded_to_nearest_everywhere() {
        for a in -ANGLE2PI..2 * ANGLE2PI {
            let exact = (f64::from(a) * RADIANS).sin() * f64::from(TRIGO_MUL);
            assert!((f64::from(sinus(a)) - exact).abs() <= 0.5 + 1e-6, "{a}");
            let exact = (f64::from(a) * RADIANS).cos() * f64::from(TRIGO_MUL);
            assert!((f64::from(cosinus(a)) - exact).abs() <= 0.5 + 1e-6, "{a}");
        }
        assert_eq!([0, 2048, 4096, 6144].map(sinus), [0, 16384, 0, -16384]);
        assert_eq!((sinus(i32::MAX), sinus(i32::MIN)), (sinus(8191), 0));
        cosinus(i32::MAX);
    }

    #[test]
    fn roots_are_exact() {
        for a in (0..1_000_000).chain(random(100_000)) {
            let root = i64::from(sqrti(a));
            let a = i64::from(a.max(0));
            assert!(root * root <= a && (root + 1) * (root + 1) > a, "{a}");
        }
        assert_eq!((sqrti(i32::MAX), sqrti(-1), sqrti(i32::MIN)), (46340, 0, 0));
    }

    #[test]
    fn angles_are_the_nearest() {
        let arguments: Vec<i32> = random(2_000_000).collect();
        for [x, y] in arguments.as_chunks::<2>().0 {
            let exact = f64::from(*y).atan2(f64::from(*x)) / RADIANS;
            let angle = atan2i(*x, *y);
            assert!((-4095..=4096).contains(&angle));
            let mut off = (f64::from(angle) - exact).abs();
            off = off.min((off - 8192.0).abs());
            assert!(off <= 0.5 + 1e-5 || (*x, *y) == (0, 0), "{x} {y}: {angle} {exact}");
        }
        let at = |x, y| atan2i(x, y);
        assert_eq!([at(1, 0), at(0, 1), at(-1, 0), at(0, -1)], [0, 2048, 4096, -2048]);
        assert_eq!([at(1, 1), at(-1, -1), at(0, 0), at(-1_000_000, -1)], [1024, -3072, 0, 4096]);
        assert_eq!(at(i32::MIN, i32::MIN), -3072);
    }

    #[test]
    fn sines_and_angles_agree() {
        for a in -4095..=4096 {
            let back = atan2i(cosinus(a).into(), sinus(a).into());
            assert!((back - a).abs() <= 1, "{a} {back}");
        }
    }

    #[test]
    fn logarithms() {
        assert_eq!([-5, 0, 1, 2, 3, 4, 128, i32::MAX].map(log2), [0, 0, 0, 1, 1, 2, 7, 30]);
    }

    #[test]
    fn repeats_are_taken_away() {
        let mut uv = [515, -1, 800, 300, 600, 40];
        convert_uv(&mut uv);
        assert_eq!(uv, [3, 255, 288, 556, 88, 296]);
        let mut uv = [i16::MIN, 0, i16::MAX, 0, 0, 0];
        convert_uv(&mut uv);
        assert_eq!(uv, [0, 0, i16::MAX, 0, i16::MAX, 0]);
        for uvs in random(60_000).map(|n| n as i16).collect::<Vec<_>>().as_chunks::<6>().0 {
            let mut uv = *uvs;
            convert_uv(&mut uv);
            for axis in 0..2 {
                let least = (0..3).map(|i| uv[axis + 2 * i]).min().unwrap();
                assert!((0..256).contains(&least));
                for i in 0..3 {
                    let moved = i32::from(uvs[axis + 2 * i]) - i32::from(uv[axis + 2 * i]);
                    assert!(moved % 256 == 0 || uv[axis + 2 * i] == i16::MAX);
                }
            }
        }
    }

    #[test]
    fn unit_vectors_have_unit_length() {
        for v in random(1_000_000).collect::<Vec<_>>().as_chunks::<3>().0 {
            let mut n = *v;
            normalize(&mut n);
            let length = n.iter().map(|&c| f64::from(c).powi(2)).sum::<f64>().sqrt();
            // Three roundings by at most a half.
            assert!((length - 16384.0).abs() < 0.87 || *v == [0; 3], "{v:?} {n:?} {length}");
            let exact = v.iter().map(|&c| f64::from(c).powi(2)).sum::<f64>().sqrt();
            for i in 0..3 {
                let off = f64::from(v[i]) / exact * 16384.0 - f64::from(n[i]);
                assert!(*v == [0; 3] || off.abs() <= 0.5 + 1e-6);
            }
        }
        let mut extreme = [i32::MIN; 3];
        normalize(&mut extreme);
        assert_eq!(extreme, [-9459; 3]);
    }

    #[test]
    fn normals_point_to_the_viewer() {
        assert_eq!(def_u_normal(&[0; 3], &[10, 0, 0], &[0, 10, 0]), [0, 0, 100]);
        assert_eq!(def_u_normal(&[0; 3], &[0, 10, 0], &[10, 0, 0]), [0, 0, -100]);
        assert_eq!(def_u_normal(&[1; 3], &[2; 3], &[7; 3]), [0; 3]);
        for v in random(90_000).collect::<Vec<_>>().as_chunks::<9>().0 {
            let point = |i: usize| [v[i], v[i + 1], v[i + 2]];
            let n = def_u_normal(&point(0), &point(3), &point(6));
            let length: i64 = n.iter().map(|&c| i64::from(c).pow(2)).sum();
            assert!(length <= 1 << 30);
        }
        def_u_normal(&[i32::MIN; 3], &[i32::MAX, i32::MIN, 0], &[0, i32::MAX, i32::MAX]);
    }

    #[test]
    fn numbers_in_decimal() {
        let texts = [0, -7, i32::MIN].map(itoa);
        assert_eq!(texts, ["0", "-7", "-2147483648"]);
    }
}
