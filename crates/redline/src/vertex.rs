//! Vertex types: which words a vertex of a type consists of.
//!
//! Source: RR, vertex types; the numbers from the interface headers.

/// What one word of a vertex holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Attribute {
    /// Column, signed 16.16.
    X,
    /// Row, signed 16.16.
    Y,
    /// Depth, unsigned 16.16.
    Z,
    /// Texture coordinate, signed 16.16.
    U,
    /// Texture coordinate, signed 16.16.
    V,
    /// Common scale of 1/w, 0.24.
    Q,
    /// Red, 16.16.
    R,
    /// Green, 16.16.
    G,
    /// Blue, 16.16.
    B,
    /// Alpha, 16.16.
    A,
    /// Fog, 16.16.
    F,
    /// Grey, 16.16.
    I,
    /// Packed colour 0x..RRGGBB.
    K,
    /// Packed colour with alpha, 0xAARRGGBB.
    Ka,
    /// Packed specular colour 0x..RRGGBB.
    S,
    /// Packed specular colour with fog, 0xFFRRGGBB.
    Sf,
    /// Fog in bits 31..24, nothing else.
    Fp,
}

/// How many kinds of attributes there are.
pub const ATTRIBUTES: usize = 17;

/// The words of a vertex type.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Words of a vertex.
    pub words: u8,
    /// Which word holds an attribute; [`ABSENT`] where none does.
    at: [u8; ATTRIBUTES],
}

/// No word.
pub const ABSENT: u8 = 0xff;

impl Layout {
    /// No words.
    pub(crate) const EMPTY: Layout = Layout { words: 0, at: [ABSENT; ATTRIBUTES] };

    const fn new(attributes: &[Attribute]) -> Layout {
        let mut at = [ABSENT; ATTRIBUTES];
        let mut word = 0;
        while word < attributes.len() {
            at[attributes[word] as usize] = word as u8;
            word += 1;
        }
        Layout { words: attributes.len() as u8, at }
    }

    /// The word that holds an attribute.
    #[inline]
    pub fn word(&self, attribute: Attribute) -> Option<usize> {
        let at = self.at[attribute as usize];
        (at != ABSENT).then_some(usize::from(at))
    }

    /// The attribute's word in a vertex of this layout, which ends with it.
    #[inline(always)]
    pub fn get(&self, vertex: &[u32], attribute: Attribute) -> Option<u32> {
        // No vertex is as long as the number that stands for no word.
        vertex.get(usize::from(self.at[attribute as usize])).copied()
    }
}

/// Declares the vertex types.
macro_rules! vertex_types {
    ($($name:ident = $code:literal $text:literal [$($a:ident)*],)*) => {
        /// A vertex type, by its words in order. The number is the code in
        /// commands.
        #[allow(missing_docs)]
        #[allow(clippy::upper_case_acronyms)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u32)]
        pub enum VertexType { $($name = $code,)* }

        impl VertexType {
            /// All types.
            pub const ALL: &'static [VertexType] = &[$(VertexType::$name),*];

            /// The type with this code.
            pub fn from_code(code: u32) -> Option<VertexType> {
                match code {
                    $($code => Some(VertexType::$name),)*
                    _ => None,
                }
            }

            /// The name in C.
            pub fn name(self) -> &'static str {
                match self { $(VertexType::$name => $text,)* }
            }

            /// The words in order.
            pub fn attributes(self) -> &'static [Attribute] {
                match self { $(VertexType::$name => &[$(Attribute::$a),*],)* }
            }
        }

        /// Layouts by code; those of codes that are no type have no words.
        static LAYOUTS: [Layout; 64] = {
            let mut all = [Layout::new(&[]); 64];
            $(all[$code] = Layout::new(&[$(Attribute::$a),*]);)*
            all
        };
    };
}

vertex_types! {
    XY = 1 "V_FIFO_XY" [X Y],
    XYUV = 2 "V_FIFO_XYUV" [X Y U V],
    XYUVQ = 3 "V_FIFO_XYUVQ" [X Y U V Q],
    IXYUVQ = 4 "V_FIFO_IXYUVQ" [I X Y U V Q],
    FXYUVQ = 5 "V_FIFO_FXYUVQ" [F X Y U V Q],
    XYZUVQ = 6 "V_FIFO_XYZUVQ" [X Y Z U V Q],
    RGBFXY = 7 "V_FIFO_RGBFXY" [R G B F X Y],
    RGBXYZ = 8 "V_FIFO_RGBXYZ" [R G B X Y Z],
    IFXYUVQ = 9 "V_FIFO_IFXYUVQ" [I F X Y U V Q],
    IXYZUVQ = 10 "V_FIFO_IXYZUVQ" [I X Y Z U V Q],
    RGBAFXYUVQ = 11 "V_FIFO_RGBAFXYUVQ" [R G B A F X Y U V Q],
    RGBAXYZUVQ = 12 "V_FIFO_RGBAXYZUVQ" [R G B A X Y Z U V Q],
    KFXY = 17 "V_FIFO_KFXY" [K F X Y],
    KXYZ = 18 "V_FIFO_KXYZ" [K X Y Z],
    KAFXYUVQ = 19 "V_FIFO_KAFXYUVQ" [K A F X Y U V Q],
    KAXYZUVQ = 20 "V_FIFO_KAXYZUVQ" [K A X Y Z U V Q],
    IXYZUV = 21 "V_FIFO_IXYZUV" [I X Y Z U V],
    RGBAFXYZUVQ = 22 "V_FIFO_RGBAFXYZUVQ" [R G B A F X Y Z U V Q],
    KAFXYZUVQ = 24 "V_FIFO_KAFXYZUVQ" [K A F X Y Z U V Q],
    KXYUVQ = 25 "V_FIFO_KXYUVQ" [K X Y U V Q],
    IFXYZUVQ = 26 "V_FIFO_IFXYZUVQ" [I F X Y Z U V Q],
    AXY = 27 "V_FIFO_AXY" [A X Y],
    KXY = 28 "V_FIFO_KXY" [K X Y],
    KFXYZ = 29 "V_FIFO_KFXYZ" [K F X Y Z],
    FXYZ = 30 "V_FIFO_FXYZ" [F X Y Z],
    XYZ = 31 "V_FIFO_XYZ" [X Y Z],
    KaSFXYZUVQ = 32 "V_FIFO_KaSFXYZUVQ" [Ka Sf X Y Z U V Q],
    KSXYUVQ = 33 "V_FIFO_KSXYUVQ" [K S X Y U V Q],
    KSXYZUVQ = 34 "V_FIFO_KSXYZUVQ" [K S X Y Z U V Q],
}

/// Layout of the fast triangles of k, x, y, z, u, v, q.
pub(crate) static KXYZUVQ: Layout = {
    use Attribute::{K, Q, U, V, X, Y, Z};
    Layout::new(&[K, X, Y, Z, U, V, Q])
};
/// Layout of the fast triangles with fog (bits 31..24 of its word).
pub(crate) static KFXYZUVQ: Layout = {
    use Attribute::{Fp, K, Q, U, V, X, Y, Z};
    Layout::new(&[K, Fp, X, Y, Z, U, V, Q])
};
/// Layout of the fast triangles of k, s, x, y, z.
pub(crate) static KSXYZ: Layout = {
    use Attribute::{K, S, X, Y, Z};
    Layout::new(&[K, S, X, Y, Z])
};

impl VertexType {
    /// The code in commands.
    pub fn code(self) -> u32 {
        self as u32
    }

    /// The words of a vertex.
    #[inline]
    pub fn layout(self) -> &'static Layout {
        &LAYOUTS[self as usize]
    }

    /// Words of a vertex.
    #[inline]
    pub fn words(self) -> usize {
        usize::from(self.layout().words)
    }

    /// Whether only boards with the extension Specular know it.
    pub fn is_specular(self) -> bool {
        matches!(self, VertexType::KaSFXYZUVQ | VertexType::KSXYUVQ | VertexType::KSXYZUVQ)
    }
}

/// Bytes of a vertex of the type with this code, 0 for codes that are none
/// (`VL_VertexSize`).
pub fn vertex_size(code: u32) -> u32 {
    VertexType::from_code(code).map_or(0, |vertex| vertex.words() as u32 * 4)
}

/// The word that holds Q, -1 where none does (`VL_QOffset`).
pub fn q_offset(code: u32) -> i32 {
    let word = VertexType::from_code(code).and_then(|v| v.layout().word(Attribute::Q));
    word.map_or(-1, |word| word as i32)
}

/// Scales three Q values by one power of two so that the largest is in
/// [0.5, 1) (`VL_QNormalize`). Zeros are left alone; of values with more than
/// 24 bits the low bits are lost.
pub fn q_normalize(q: &mut [u32; 3]) {
    let bits = 32 - (q[0] | q[1] | q[2]).leading_zeros();
    if bits == 0 {
        return;
    }
    for q in q {
        *q = if bits <= 24 { *q << (24 - bits) } else { *q >> (bits - 24) };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_offsets() {
        assert_eq!(vertex_size(VertexType::XY.code()), 8);
        assert_eq!(vertex_size(VertexType::RGBAFXYZUVQ.code()), 44);
        assert_eq!(vertex_size(13), 0);
        assert_eq!(q_offset(VertexType::KXYZ.code()), -1);
        assert_eq!(q_offset(VertexType::XYUVQ.code()), 4);
        for vertex in VertexType::ALL {
            assert_eq!(vertex.words(), vertex.attributes().len());
            let name: String =
                vertex.attributes().iter().map(|a| format!("{a:?}").to_uppercase()).collect();
            assert_eq!(format!("V_FIFO_{name}"), vertex.name().to_uppercase());
        }
    }

    #[test]
    fn normal_q_fills_its_top_bit() {
        let mut q = [1, 2, 3];
        q_normalize(&mut q);
        assert_eq!(q, [0x40_0000, 0x80_0000, 0xc0_0000]);
        let mut big = [0x8000_0000, 0, 0x80];
        q_normalize(&mut big);
        assert_eq!(big, [0x80_0000, 0, 0]);
        let mut zero = [0; 3];
        q_normalize(&mut zero);
        assert_eq!(zero, [0; 3]);
    }
}
