//! The test matrix: 24 outer vectors, 15 inner vectors, 7 sizes.
//!
//! Source: RAW, section 5.2 and the performance-test listing.

use crate::call::Call;
use crate::client::Client;
use crate::errata::Errata;
use crate::opcode::Opcode;
use crate::protocol::Record;
use crate::scenes;
use crate::state::texmode;

/// How a triangle is coloured, textured and lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outer {
    /// The name in the thesis.
    pub name: &'static str,
    texmode: u32,
    col_interp: u32,
    tex_interp: u32,
    lit: u32,
    lit_interp: u32,
}

/// How fragments meet the buffers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inner {
    /// The name in the thesis.
    pub name: &'static str,
    /// Vertex alpha, 0..=255.
    pub alpha: u32,
    no_use_z: u32,
    no_write_z: u32,
    out_of_order: u32,
}

/// Sizes of the pattern, largest first.
pub const SCALES: [f32; 7] = [1.0, 0.5, 0.3, 0.2, 0.1, 0.05, 0.01];

const fn outer(name: &'static str, m: u32, ci: u32, ti: u32, lit: u32, li: u32) -> Outer {
    Outer { name, texmode: m, col_interp: ci, tex_interp: ti, lit, lit_interp: li }
}

const fn inner(name: &'static str, alpha: u32, nu: u32, nw: u32, o: u32) -> Inner {
    Inner { name, alpha, no_use_z: nu, no_write_z: nw, out_of_order: o }
}

/// The outer vectors in their order.
pub const OUTER: [Outer; 24] = [
    outer("col0x0x", texmode::COLOR, 0, 0, 0, 0),
    outer("col1x0x", texmode::COLOR, 1, 0, 0, 0),
    outer("col0x10", texmode::COLOR, 0, 0, 1, 0),
    outer("col1x10", texmode::COLOR, 1, 0, 1, 0),
    outer("col0x11", texmode::COLOR, 0, 0, 1, 1),
    outer("col1x11", texmode::COLOR, 1, 0, 1, 1),
    outer("texx00x", texmode::TEXTURE, 0, 0, 0, 0),
    outer("texx10x", texmode::TEXTURE, 0, 1, 0, 0),
    outer("texx010", texmode::TEXTURE, 0, 0, 1, 0),
    outer("texx110", texmode::TEXTURE, 0, 1, 1, 0),
    outer("texx011", texmode::TEXTURE, 0, 0, 1, 1),
    outer("texx111", texmode::TEXTURE, 0, 1, 1, 1),
    outer("bln000x", texmode::BLEND, 0, 0, 0, 0),
    outer("bln100x", texmode::BLEND, 1, 0, 0, 0),
    outer("bln0010", texmode::BLEND, 0, 0, 1, 0),
    outer("bln1010", texmode::BLEND, 1, 0, 1, 0),
    outer("bln0011", texmode::BLEND, 0, 0, 1, 1),
    outer("bln1011", texmode::BLEND, 1, 0, 1, 1),
    outer("bln010x", texmode::BLEND, 0, 1, 0, 0),
    outer("bln110x", texmode::BLEND, 1, 1, 0, 0),
    outer("bln0110", texmode::BLEND, 0, 1, 1, 0),
    outer("bln1110", texmode::BLEND, 1, 1, 1, 0),
    outer("bln0111", texmode::BLEND, 0, 1, 1, 1),
    outer("bln1111", texmode::BLEND, 1, 1, 1, 1),
];

/// The inner vectors in their order.
pub const INNER: [Inner; 15] = [
    inner("itv000x", 0xff, 0, 0, 1),
    inner("itv0010", 0xff, 0, 1, 0),
    inner("itv0100", 0xff, 1, 0, 0),
    inner("itv0110", 0xff, 1, 1, 0),
    inner("itv1000", 0x88, 0, 0, 0),
    inner("itv1010", 0x88, 0, 1, 0),
    inner("itv1100", 0x88, 1, 0, 0),
    inner("itv1110", 0x88, 1, 1, 0),
    inner("itv0011", 0xff, 0, 1, 1),
    inner("itv0101", 0xff, 1, 0, 1),
    inner("itv0111", 0xff, 1, 1, 1),
    inner("itv1001", 0x88, 0, 0, 1),
    inner("itv1011", 0x88, 0, 1, 1),
    inner("itv1101", 0x88, 1, 0, 1),
    inner("itv1111", 0x88, 1, 1, 1),
];

/// A charted mode: its title and its vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Charted {
    /// What the chart line shows.
    pub title: &'static str,
    /// Name of the outer vector.
    pub outer: &'static str,
    /// Name of the inner vector.
    pub inner: &'static str,
}

const fn charted(title: &'static str, outer: &'static str, inner: &'static str) -> Charted {
    Charted { title, outer, inner }
}

/// The twelve lines of the figures. Which vectors they stand for is our reading.
pub const CHARTED: [Charted; 12] = [
    charted("flat colour", "col0x0x", "itv000x"),
    charted("interpolated colour", "col1x0x", "itv000x"),
    charted("nearest texture", "texx00x", "itv000x"),
    charted("bilinear texture", "texx10x", "itv000x"),
    charted("flat lit", "col0x10", "itv000x"),
    charted("interpolated lit", "col0x11", "itv000x"),
    charted("transparent", "col0x0x", "itv1000"),
    charted("transparent, unordered", "col0x0x", "itv1001"),
    charted("everything on", "bln1111", "itv000x"),
    charted("everything, transparent", "bln1111", "itv1000"),
    charted("everything, transparent, unordered", "bln1111", "itv1001"),
    charted("flat colour, no z, unordered", "col0x0x", "itv0111"),
];

impl Charted {
    /// The vectors of this line.
    pub fn vectors(&self) -> (Outer, Inner) {
        let outer = OUTER.iter().find(|o| o.name == self.outer).expect("charted modes exist");
        let inner = INNER.iter().find(|i| i.name == self.inner).expect("charted modes exist");
        (*outer, *inner)
    }
}

/// The records of one run: set-up, then `frames` patterns in one scene, measured.
pub fn records(outer: Outer, inner: Inner, scale: f32, frames: u32) -> Vec<Record> {
    let mut client = Client::new(Errata::CORRECT);
    client.meta(Record::PerfReset);
    set_up(&mut client, outer, inner);
    client.model(&scenes::pattern_model(scale, 0.0));
    client.meta(Record::PerfStart);
    client.call(&Call::BeginScene {});
    for _ in 0..frames {
        client.meta(Record::Frame);
        scenes::triangle_pattern(&mut client, inner.alpha);
    }
    client.call(&Call::EndScene {});
    client.meta(Record::PerfStop);
    client.take_records()
}

/// Textures, lights and modes of a test, outside a scene.
pub fn set_up(client: &mut Client, outer: Outer, inner: Inner) {
    client.call(&Call::ClearFb { pages: 3, rgbx: 0 });
    client.call(&Call::ClearZ {});
    client.call(&Call::AllocateTexture { width: 8, height: 8 });
    client.call(&Call::UploadTexture { id: 0, texels: scenes::face_texture() });
    scenes::test_lights(client);
    let modes = [
        (Opcode::SetTextureId, 0),
        (Opcode::SetTexMode, outer.texmode),
        (Opcode::SetColInterp, outer.col_interp),
        (Opcode::SetTexInterp, outer.tex_interp),
        (Opcode::SetLit, outer.lit),
        (Opcode::SetLitInterp, outer.lit_interp),
        (Opcode::SetUseAmb, 1),
        (Opcode::SetUseDir, 1),
        (Opcode::SetColAlpha, 1),
        (Opcode::SetTexAlpha, 0),
        (Opcode::SetTexTile, 1),
        (Opcode::SetNoUseZ, inner.no_use_z),
        (Opcode::SetNoWriteZ, inner.no_write_z),
        (Opcode::SetOutOfOrder, inner.out_of_order),
    ];
    modes.into_iter().for_each(|(op, value)| client.set(op, value));
}
