//! The test scenes of the thesis, as client calls.
//!
//! Source: RAW, test programs (triangletest, texturetest, ordertest, cubetest).

use crate::call::Call;
use crate::client::Client;
use crate::color::pack;
use crate::matrix::{self, IDENTITY};
use crate::opcode::Opcode;

/// A vertex of the triangle pattern: x, y, u, v, rgb (high 24 bits) and whether alpha follows the
/// test's parameter.
type PatternVertex = ([f32; 4], u32, bool);

const PATTERN: [[PatternVertex; 3]; 6] = [
    [
        ([0.0, 0.0, 0.0, 0.0], 0xff0000, true),
        ([0.5, 0.0, 1.0, 0.0], 0x00ff00, false),
        ([0.0, 0.5, 0.0, 1.0], 0x0000ff, false),
    ],
    [
        ([0.9, 0.5, 1.0, 0.0], 0xffff00, true),
        ([0.9, 0.75, 1.0, 1.0], 0xff00ff, true),
        ([0.75, 0.75, 0.0, 1.0], 0x00ffff, true),
    ],
    [
        ([-0.5, -0.5, 0.0, 1.0], 0xffffff, true),
        ([-0.4, -0.7, 0.5, 0.0], 0xffffff, true),
        ([-0.3, -0.5, 1.0, 1.0], 0xffffff, true),
    ],
    [
        ([-0.5, 0.0, 0.0, 0.0], 0xffffff, true),
        ([-0.4, 0.0, 1.0, 0.0], 0xffffff, true),
        ([-0.4, 0.1, 1.0, 1.0], 0xff0000, true),
    ],
    [
        ([-0.7, 0.9, 0.0, 1.0], 0x5000c0, true),
        ([-0.7, 0.01, 0.0, 0.0], 0x5000c0, true),
        ([-0.4, 0.45, 1.0, 0.5], 0x00ffcc, false),
    ],
    [
        ([0.0, 0.0, 0.0, 1.0], 0xffc040, false),
        ([0.0, -1.0, 0.0, 0.0], 0x00ff88, true),
        ([1.0, 0.0, 1.0, 1.0], 0xffffff, true),
    ],
];

/// Sends the six triangles of the pattern with `alpha` 0..=255, inside an open scene. A colour is
/// sent only where it differs from the one before.
pub fn triangle_pattern(client: &mut Client, alpha: u32) {
    let mut last = None;
    for triangle in &PATTERN {
        client.call(&Call::BeginPrim {});
        for (p, rgb, follows) in triangle {
            let rgba = rgb << 8 | if *follows { alpha & 0xff } else { 0xff };
            if last.replace(rgba) != Some(rgba) {
                client.call(&Call::Color { rgba });
            }
            client.vertex([p[0], p[1], 0.0], [p[2], p[3]]);
        }
        client.call(&Call::EndPrim {});
    }
}

/// The model matrix of the pattern: scaled by `scale` and turned by `angle` radians.
pub fn pattern_model(scale: f32, angle: f32) -> matrix::Matrix {
    let (sin, cos) = matrix::sin_cos(f64::from(angle));
    let (s, c) = (scale * sin as f32, scale * cos as f32);
    let mut model = IDENTITY;
    model[0][0] = c;
    model[0][1] = -s;
    model[1][0] = s;
    model[1][1] = c;
    model
}

/// The 8x8 texture of the pattern: a face on yellow.
pub fn face_texture() -> Vec<u32> {
    const FACE: [&[u8; 8]; 8] = [
        b"........",
        b"........",
        b"..c..c..",
        b".k....k.",
        b".k....k.",
        b"..k..k..",
        b"...kk...",
        b"........",
    ];
    let texel = |c: &u8| match c {
        b'c' => 0x00ff_ffff,
        b'k' => 0x0000_00ff,
        _ => 0xffff_00ff,
    };
    FACE.iter().flat_map(|row| row.iter().map(texel)).collect()
}

/// The thirteen overlapping triangles of the order test, inside an open scene.
pub fn order_test(client: &mut Client) {
    const COLORS: [u32; 13] = [
        0xff00_00ff,
        0x00ff_00ff,
        0x0000_ff88,
        0xff00_ffff,
        0xffff_00ff,
        0x00ff_ff88,
        0xffff_ff88,
        0xff00_00ff,
        0x00ff_00ff,
        0x0000_ffff,
        0xff00_ff88,
        0xffff_0088,
        0x00ff_ff88,
    ];
    for (k, rgba) in COLORS.into_iter().enumerate() {
        let x = -0.8 + 0.1 * k as f32;
        client.call(&Call::BeginPrim {});
        client.call(&Call::Color { rgba });
        for p in [[x, -0.2, 0.0], [x + 0.2, 0.0, 0.5], [x, 0.2, 0.0]] {
            client.vertex(p, [0.0; 2]);
        }
        client.call(&Call::EndPrim {});
    }
}

/// The 16x16 texture of the texture test.
pub fn decal_texture() -> Vec<u32> {
    let mut texels = vec![0xffff_ffff; 256];
    let mut put = |x: usize, y: usize, rgba: u32| texels[y * 16 + x] = rgba;
    for y in 0..15 {
        put(0, y, [0xff00_00ff, 0x00ff_00ff, 0x0000_ffff][y % 3]);
    }
    for (x, y) in (1..4).flat_map(|x| (0..3).map(move |y| (x, y))) {
        put(x, y, 0xff00_00ff);
    }
    for (x, alpha) in (2..6).zip([0xcc, 0x88, 0x44, 0x00]) {
        put(x, 6, 0xffff_ff00 | alpha);
        put(x, 7, 0xffff_ff00 | alpha);
    }
    for (x, y) in (2..7).flat_map(|x| (9..14).map(move |y| (x, y))) {
        let (ex, ey) = (x == 2 || x == 6, y == 9 || y == 13);
        put(
            x,
            y,
            if ex && ey {
                0x00ff_00ff
            } else if ex || ey {
                0x0000_ffff
            } else {
                0xffff_00ff
            },
        );
    }
    for (x, y) in (9..11).flat_map(|x| (9..13).map(move |y| (x, y))) {
        put(x, y, 0xffff_ff00);
    }
    texels
}

/// Sets the modes of the texture test; the 16x16 texture is bound.
pub fn texture_test_modes(client: &mut Client) {
    let modes = [
        (Opcode::SetNoUseZ, 1),
        (Opcode::SetNoWriteZ, 1),
        (Opcode::SetOutOfOrder, 1),
        (Opcode::SetTexMode, 5),
        (Opcode::SetTexAlpha, 0),
        (Opcode::SetColAlpha, 2),
    ];
    modes.into_iter().for_each(|(op, value)| client.set(op, value));
    client.call(&Call::AlphaThresh { threshold: 0xdd });
}

/// The two triangles of the texture test, bilinear on the right, nearest on the left, inside an
/// open scene.
pub fn texture_test(client: &mut Client) {
    for (interp, shift) in [(1, 0.0), (0, -0.5)] {
        client.call(&Call::BeginPrim {});
        client.set(Opcode::SetTexInterp, interp);
        let corners = [
            ([0.0, 0.0], [0.0, 1.0], 0xff00_00ff),
            ([0.0, -0.5], [0.0, 0.0], 0x00ff_00cc),
            ([0.5, 0.0], [1.0, 1.0], 0x0000_ffcc),
        ];
        for ([x, y], uv, rgba) in corners {
            client.call(&Call::Color { rgba });
            client.vertex([x + shift, y, 0.0], uv);
        }
        client.call(&Call::EndPrim {});
    }
}

/// Corner signs of a cube face: bottom left, top left, top right, bottom right.
type Face = (u32, [[f32; 3]; 4]);

const CUBE: [Face; 6] = [
    (0xff0000, [[-1., 1., -1.], [-1., 1., 1.], [1., 1., 1.], [1., 1., -1.]]),
    (0x00ff00, [[-1., -1., -1.], [-1., 1., -1.], [1., 1., -1.], [1., -1., -1.]]),
    (0x0000ff, [[1., -1., -1.], [1., 1., -1.], [1., 1., 1.], [1., -1., 1.]]),
    (0xff00ff, [[-1., -1., 1.], [-1., -1., -1.], [1., -1., -1.], [1., -1., 1.]]),
    (0xffff00, [[1., -1., 1.], [1., 1., 1.], [-1., 1., 1.], [-1., -1., 1.]]),
    (0x00ffff, [[-1., -1., 1.], [-1., 1., 1.], [-1., 1., -1.], [-1., -1., -1.]]),
];

/// One unit cube at the origin of the model, inside an open scene.
pub fn cube(client: &mut Client) {
    const CORNER: f32 = 0.577_350_26;
    const UV: [[f32; 2]; 4] = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    for (rgb, corners) in &CUBE {
        client.color(rgb >> 16, rgb >> 8, *rgb, 0xff);
        for triangle in [[0, 1, 2], [0, 2, 3]] {
            client.call(&Call::BeginPrim {});
            for i in triangle {
                let [x, y, z] = corners[i];
                client.call(&Call::Normal { x: x * CORNER, y: y * CORNER, z: z * CORNER });
                client.vertex([x * 0.5, y * 0.5, z * 0.5], UV[i]);
            }
            client.call(&Call::EndPrim {});
        }
    }
}

/// The camera and projection of the cube test.
pub fn cube_view(client: &mut Client) {
    let eighth = std::f32::consts::FRAC_PI_4;
    client.set_projection(matrix::perspective_angles(eighth, eighth, 0.1, 100.0));
    client.set_camera([2.0, 2.0, -3.0], [0.0; 3], [0.0, 10.0, 0.0]);
}

/// Nine cubes around the origin, 108 triangles, inside an open scene.
pub fn nine_cubes(client: &mut Client) {
    for x in [0.0, -1.5, 1.5] {
        for z in [0.0, -1.5, 1.5] {
            let mut model = IDENTITY;
            model[0][3] = x;
            model[2][3] = z;
            client.model(&model);
            cube(client);
        }
    }
}

/// A light from the front with white colours at half intensity.
pub fn test_lights(client: &mut Client) {
    let white = pack(0xff, 0xff, 0xff, 0x80);
    client.call(&Call::AmbColor { rgbi: white });
    client.call(&Call::DirColor { rgbi: white });
    client.call(&Call::DirLight { x: 0.0, y: 0.0, z: 1.0 });
}
