//! Vertices as programs hand them over.

use fillrate_call::value_struct;
use fillrate_engine::{TmuVertex, Vertex};

use crate::enums::{
    STW_ST_DIFF_TMU1, STW_ST_DIFF_TMU2, STW_W_DIFF_TMU0, STW_W_DIFF_TMU1, STW_W_DIFF_TMU2,
};

value_struct! {
    /// Texture coordinates of a vertex for one unit.
    ///
    /// Source: G246, `GrTmuVertex`.
    #[derive(Copy, Default)]
    #[repr(C)]
    pub struct GrTmuVertex {
        /// s/w; s runs to 256 along the texture's longer side.
        pub sow: f32,
        /// t/w.
        pub tow: f32,
        /// 1/w of this unit; read only where a hint says so.
        pub oow: f32,
    }
}

value_struct! {
    /// A vertex, 60 bytes.
    ///
    /// Source: G246, `GrVertex` for two texture units.
    #[derive(Copy, Default)]
    #[repr(C)]
    pub struct GrVertex {
        /// Column in pixels.
        pub x: f32,
        /// Row in pixels.
        pub y: f32,
        /// Not read.
        pub z: f32,
        /// Red, 0..255.
        pub r: f32,
        /// Green, 0..255.
        pub g: f32,
        /// Blue, 0..255.
        pub b: f32,
        /// 65535/z, the z-buffer's value.
        pub ooz: f32,
        /// Alpha, 0..255.
        pub a: f32,
        /// 1/w.
        pub oow: f32,
        /// Texture coordinates.
        pub tmuvtx: [GrTmuVertex; 2],
    }
}

/// How vertices become the engine's: which coordinates reach which unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct VertexRules {
    /// Bits of the STW hint.
    pub hints: u32,
    /// Whether the first unit uses its own texel.
    pub unit0_active: bool,
    /// Red, green, blue and alpha bits of the constant colour that replaces
    /// the vertices' own, in the delta-0 mode.
    pub constant: Option<[u32; 3]>,
}

impl VertexRules {
    /// No hints, and the vertices' own colours.
    pub const PLAIN: VertexRules = VertexRules { hints: 0, unit0_active: true, constant: None };

    /// The engine's vertex.
    ///
    /// Source: G246, triangle set-up: w goes to every unit, a hint gives a
    /// unit its own; s and t of the first unit go to the second, unless hinted
    /// or the first one is not active.
    #[inline(always)]
    pub fn convert(&self, v: &GrVertex) -> Vertex {
        let hint = |bit: u32| self.hints & bit != 0;
        let [first, second] = v.tmuvtx;
        let w0 = if hint(STW_W_DIFF_TMU0) { first.oow } else { v.oow };
        let w1 = if hint(STW_W_DIFF_TMU1) { second.oow } else { w0 };
        let own = hint(STW_ST_DIFF_TMU1) || !self.unit0_active;
        let st1 = if own { second } else { first };
        // Vertices have no third pair of coordinates: the third unit shares
        // those of the second where it is hinted.
        let st2 = if hint(STW_ST_DIFF_TMU2) { second } else { st1 };
        let w2 = if hint(STW_W_DIFF_TMU2) { second.oow } else { w1 };
        let tmu = |st: GrTmuVertex, w: f32| TmuVertex { s: st.sow, t: st.tow, w };
        let [r, g, b] = self.constant.map_or([v.r, v.g, v.b], |bits| bits.map(f32::from_bits));
        Vertex {
            x: v.x,
            y: v.y,
            r,
            g,
            b,
            a: v.a,
            z: v.ooz,
            w: v.oow,
            tmu: [tmu(first, w0), tmu(st1, w1), tmu(st2, w2)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_the_headers() {
        assert_eq!(size_of::<GrVertex>(), 60);
        assert_eq!(core::mem::offset_of!(GrVertex, ooz), 24);
        assert_eq!(core::mem::offset_of!(GrVertex, oow), 32);
        assert_eq!(core::mem::offset_of!(GrVertex, tmuvtx), 36);
    }

    #[test]
    fn hints_choose_coordinates() {
        let tmu = |n: f32| GrTmuVertex { sow: n, tow: n, oow: n };
        let v = GrVertex { oow: 9.0, tmuvtx: [tmu(1.0), tmu(2.0)], ..GrVertex::default() };
        let convert = |hints, unit0_active| {
            let rules = VertexRules { hints, unit0_active, constant: None };
            rules.convert(&v).tmu.map(|t| (t.s, t.w))
        };
        assert_eq!(convert(0, true)[..2], [(1.0, 9.0), (1.0, 9.0)]);
        assert_eq!(convert(0, false)[..2], [(1.0, 9.0), (2.0, 9.0)]);
        assert_eq!(convert(STW_W_DIFF_TMU0, true)[..2], [(1.0, 1.0), (1.0, 1.0)]);
        let both = STW_W_DIFF_TMU1 | STW_ST_DIFF_TMU1;
        assert_eq!(convert(both, true)[..2], [(1.0, 9.0), (2.0, 2.0)]);
    }
}
