//! Vertices, rectangles and images as calls carry them.

use fillrate_call::{Data, value_struct};

value_struct! {
    /// A vertex with a colour, `TQAVGouraud`.
    #[derive(Copy, Default)]
    pub struct VGouraud {
        /// Pixels from the context's left edge.
        pub x: f32,
        /// Pixels from the context's top edge.
        pub y: f32,
        /// Depth, 0 near to 1 far.
        pub z: f32,
        /// Reciprocal of w.
        pub inv_w: f32,
        /// Red, 0..=1.
        pub r: f32,
        /// Green.
        pub g: f32,
        /// Blue.
        pub b: f32,
        /// Alpha, 1 opaque.
        pub a: f32,
    }
}

value_struct! {
    /// A vertex with a texture coordinate, `TQAVTexture`.
    #[derive(Copy, Default)]
    pub struct VTexture {
        /// Pixels from the context's left edge.
        pub x: f32,
        /// Pixels from the context's top edge.
        pub y: f32,
        /// Depth, 0 near to 1 far.
        pub z: f32,
        /// Reciprocal of w.
        pub inv_w: f32,
        /// Red, 0..=1; used by decals.
        pub r: f32,
        /// Green.
        pub g: f32,
        /// Blue.
        pub b: f32,
        /// Alpha, 1 opaque.
        pub a: f32,
        /// u / w; u counts whole textures to the right.
        pub u_over_w: f32,
        /// v / w; v counts whole textures upwards.
        pub v_over_w: f32,
        /// Diffuse red, at least 0, may exceed 1; used by modulation.
        pub kd_r: f32,
        /// Diffuse green.
        pub kd_g: f32,
        /// Diffuse blue.
        pub kd_b: f32,
        /// Specular red, 0..=1; used by highlights.
        pub ks_r: f32,
        /// Specular green.
        pub ks_g: f32,
        /// Specular blue.
        pub ks_b: f32,
    }
}

value_struct! {
    /// A vertex's coordinate in a further texture, `TQAVMultiTexture`.
    #[derive(Copy, Default)]
    pub struct VMultiTexture {
        /// Reciprocal of w.
        pub inv_w: f32,
        /// u / w.
        pub u_over_w: f32,
        /// v / w.
        pub v_over_w: f32,
    }
}

value_struct! {
    /// A triangle of a mesh, `TQAIndexedTriangle`.
    #[derive(Copy, Default, Eq)]
    pub struct IndexedTriangle {
        /// `kQATriFlags`; no bit changes what is drawn.
        pub flags: u32,
        /// Places of the corners among the submitted vertices.
        pub vertices: [u32; 3],
    }
}

value_struct! {
    /// A rectangle of pixels, `TQARect`: minima inclusive, maxima exclusive.
    /// The order of the members is the interface's.
    #[derive(Copy, Default, Eq)]
    pub struct RaveRect {
        /// First column.
        pub left: i32,
        /// One past the last column.
        pub right: i32,
        /// First row.
        pub top: i32,
        /// One past the last row.
        pub bottom: i32,
    }
}

value_struct! {
    /// A picture that the program gives, `TQAImage` with its pixels. Rows have
    /// no padding: [`crate::PixelType::row_bytes`] each.
    #[derive(Default, Eq)]
    pub struct ImageValue {
        /// Columns.
        pub width: i32,
        /// Rows.
        pub height: i32,
        /// All rows, the first in memory first.
        pub pixels: Data,
    }
}

value_struct! {
    /// Where a draw context's pixels go, `TQADevice` without addresses.
    #[derive(Copy, Default, Eq)]
    pub struct DeviceValue {
        /// `TQADeviceType`: 0 memory, 4 off-screen.
        pub device_type: u32,
        /// `TQAImagePixelType`.
        pub pixel_type: u32,
        /// Columns.
        pub width: i32,
        /// Rows.
        pub height: i32,
        /// Bytes from one row to the next, in the program's memory.
        pub row_bytes: i32,
    }
}

impl RaveRect {
    /// A rectangle from its corners.
    pub const fn new(left: i32, top: i32, right: i32, bottom: i32) -> RaveRect {
        RaveRect { left, right, top, bottom }
    }

    /// Columns; 0 where there is none.
    pub fn width(&self) -> u32 {
        self.right.saturating_sub(self.left).max(0) as u32
    }

    /// Rows; 0 where there is none.
    pub fn height(&self) -> u32 {
        self.bottom.saturating_sub(self.top).max(0) as u32
    }

    /// Whether no pixel lies inside.
    pub fn is_empty(&self) -> bool {
        self.width() == 0 || self.height() == 0
    }

    /// The part that both share; possibly empty.
    pub fn intersect(&self, other: &RaveRect) -> RaveRect {
        RaveRect {
            left: self.left.max(other.left),
            right: self.right.min(other.right),
            top: self.top.max(other.top),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// Whether a pixel lies inside.
    pub fn contains(&self, x: i32, y: i32) -> bool {
        (self.left..self.right).contains(&x) && (self.top..self.bottom).contains(&y)
    }
}
