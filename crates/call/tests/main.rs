//! Call values as a front end declares them.

mod declare;
mod hostile;
mod round_trip;

use fillrate_call::{Data, value_enum, value_struct, value_symbols};

value_symbols! {
    /// How depths are compared.
    pub struct Compare(u32) {
        /// Nothing passes.
        NEVER = 0,
        /// Nearer passes.
        LESS = 1,
        /// Everything passes.
        ALWAYS = 7,
    }
}

value_struct! {
    /// A corner of a triangle.
    #[derive(Copy)]
    pub struct Corner {
        /// Pixels from the left edge.
        pub x: f32,
        /// Pixels from the origin's edge.
        pub y: f32,
        /// Per texture unit: s, t, 1/w.
        pub tmu: [[f32; 3]; 2],
    }
}

value_enum! {
    /// One of everything that can be an argument.
    pub enum Call {
        /// No argument.
        1 => Init {},
        /// Records.
        2 => DrawTriangle { a: Corner, b: Corner, c: Corner },
        /// Integers of different width.
        3 => BufferClear { color: u32, alpha: u8, depth: u16 },
        /// An enumerant, and a truth value.
        4 => DepthFunction { function: Compare, mask: bool },
        /// A list of records, each of which may be absent.
        5 => DrawPolygon { corners: Vec<Option<Corner>> },
        /// Large data, small data, text.
        600 => Download { address: u32, image: Data, table: Vec<u8>, note: String },
        /// Signed, wide and double numbers.
        65535 => Wide { a: i8, b: i16, c: i32, d: i64, e: u64, f: f64 },
        /// Calls within calls.
        7 => Batch { calls: Vec<Call> },
    }
}

/// A corner whose numbers differ from one another.
pub fn corner(x: f32) -> Corner {
    Corner { x, y: x + 0.5, tmu: [[1.0, 2.0, 3.0], [4.0, 5.0, x]] }
}
