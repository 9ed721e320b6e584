//! Every call as a value: the border that all of them cross.
//!
//! A program's objects are named by numbers: graphics processors, and
//! textures from 1 on, 0 being none. Members that the program may set by itself
//! cross the border as calls too, when the library first sees the change. Lists
//! cross whole, wherever they are read: the program writes into them through
//! pointers.
//!
//! Functions of mathematics and matrices read and change nothing but their
//! arguments, and do not cross.

use fillrate_call::{Data, value_enum, value_struct};

use crate::list::{Command, IndexFormat, TriangleList, VertexFormat};
use crate::state::Vertex;
use crate::{ErrorCode, RasterState};

value_struct! {
    /// A rasterization state, as the program holds it.
    #[derive(Copy, Default, Eq)]
    pub struct StateValue {
        /// `eDrawMode`; unknown numbers are opaque.
        pub draw_mode: u8,
        /// Base colour.
        pub draw_color: u8,
        /// 0..=255.
        pub draw_intensity: u8,
        /// Not 0 drops faces turned away.
        pub test_culling: u8,
        /// Not 0 keeps faces for the sorted pass.
        pub z_sort: u8,
        /// Number of the texture, 0 for none.
        pub texture: u32,
    }
}

value_struct! {
    /// A triangle list, as the program holds it. Numbers have 16 bits, the low
    /// byte first.
    pub struct ListValue {
        /// `VF_` bits.
        pub vertex_format: i32,
        /// `IF_` bits.
        pub index_format: i32,
        /// All numbers of the vertices.
        pub vertices: Data,
        /// All numbers of the triangles.
        pub indices: Data,
        /// Number of triangles and of their state, pair by pair.
        pub commands: Vec<u16>,
        /// The states that the commands refer to.
        pub states: Vec<StateValue>,
    }
}

value_enum! {
    /// One documented function each, with its arguments as the program gave
    /// them, or a member that it set. `gpu` says which object.
    ///
    /// Numbers and fields never change; see `fillrate_call`.
    pub enum Call {
        /// `CVGpu::Init`.
        1 => Init { gpu: u32, near: i32, far: i32, fov: i32 },
        /// `CVGpu::Delete`.
        2 => Delete { gpu: u32 },
        /// `CVGpu::SetWorkMemory`.
        3 => SetWorkMemory { gpu: u32, max_vertex: i32, max_sort: i32 },
        /// `CVGpu::PrintXY`.
        4 => PrintXy { gpu: u32, text: Vec<u8>, x: i32, y: i32 },
        /// `CVGpu::PrintFps`.
        5 => PrintFps { gpu: u32, ticks: u32 },
        /// `CVGpu::PutPixel`.
        6 => PutPixel { gpu: u32, x: i32, y: i32, color: i32 },
        /// `CVGpu::DrawLine`.
        7 => DrawLine { gpu: u32, a: [i32; 3], b: [i32; 3] },
        /// `CVGpu::DrawSprite`.
        8 => DrawSprite { gpu: u32, x: i32, y: i32 },
        /// `CVGpu::DrawSpriteScale`.
        9 => DrawSpriteScale { gpu: u32, x: i32, y: i32, scale: i32 },
        /// `CVGpu::DrawSpriteScaleZb`.
        10 => DrawSpriteScaleZb { gpu: u32, top_left: [i32; 2], bottom_right: [i32; 2], z: i32 },
        /// `CVGpu::DrawTriangle`.
        11 => DrawTriangle { gpu: u32, a: Vertex, b: Vertex, c: Vertex },
        /// `CVGpu::DrawTriangleList`.
        12 => DrawTriangleList { gpu: u32, list: ListValue },
        /// `CVGpu::SortReset`.
        13 => SortReset { gpu: u32 },
        /// `CVGpu::SortDraw`.
        14 => SortDraw { gpu: u32 },
        /// `CVGpu::FlushFB`.
        15 => FlushFb { gpu: u32, address: u32, clear_color: i32 },
        /// `CVGpu::SetFov`.
        16 => SetFov { gpu: u32, fov: i32 },
        /// `CVGpu::ScrProjection`.
        17 => ScrProjection { gpu: u32, position: [i32; 3] },
        /// `CVGpu::SetNFClip`.
        18 => SetNfClip { gpu: u32, near: i32, far: i32 },
        /// `CVGpu::ClipMsk`.
        19 => ClipMsk { gpu: u32, position: [i32; 3] },
        /// `CVGpu::CrossFrustrum`.
        20 => CrossFrustrum { gpu: u32, corners: [[i32; 3]; 8] },
        /// The program set `CVGpu::TextState`.
        30 => TextState { gpu: u32, state: StateValue },
        /// The program set `CVGpu::LineState`.
        31 => LineState { gpu: u32, state: StateValue },
        /// The program set `CVGpu::SpriteState`.
        32 => SpriteState { gpu: u32, state: StateValue },
        /// The program set `CVGpu::TriangleState`, or what it points to.
        33 => TriangleState { gpu: u32, state: Option<StateValue> },
        /// The program set `CVGpu::TriangleMode`.
        34 => TriangleMode { gpu: u32, mode: i32 },
        /// The program set `CVGpu::ViewMatrix`, or what it points to.
        35 => ViewMatrix { gpu: u32, matrix: Option<[i32; 12]> },
        /// The program set `CVGpu::ZcErrorMax`.
        36 => ZcErrorMax { gpu: u32, error: i32 },
        /// The program set `Zoom`, `ClipNear`, `ClipFar` or `NFrustrum`.
        37 => Camera { gpu: u32, zoom: i32, near: i32, far: i32, frustum: [[i32; 3]; 4] },
        /// The program set `CVGpu::FrameCounter`.
        38 => FrameCounter { gpu: u32, count: i32 },
        /// The program wrote into `CVGpu::FrameBuffer`: an index and a word,
        /// pair by pair, the low byte first.
        39 => FrameBuffer { gpu: u32, words: Data },
        /// `CTexture::Init`.
        40 => TextureInit { texture: u32, texels: Data, x: i32, y: i32, key: i32 },
        /// The program set members of a texture, or its texels.
        41 => Texture { texture: u32, texels: Data, x: i32, y: i32, keyed: bool },
        /// `CTriangleList::Init`.
        50 => ListInit { vertex_format: i32, vertices: i32, index_format: i32, triangles: i32 },
        /// `CTriangleList::WeldVertex`.
        51 => WeldVertex { list: ListValue, position: i32, intensity: i32, uv: i32 },
        /// `CTriangleList::BuildCmdList`.
        52 => BuildCmdList { list: ListValue, states: Vec<u16> },
        /// `CTriangleList::BuildFNormalList`.
        53 => BuildFNormalList { list: ListValue },
        /// `CTriangleList::BuildVNormalList`.
        54 => BuildVNormalList { list: ListValue },
    }
}

/// What a call returns.
#[derive(Clone, Debug, Default)]
pub enum Reply {
    /// Nothing.
    #[default]
    Nothing,
    /// A number: success or failure, a clip mask, an angle.
    Number(i32),
    /// A clip mask, and the screen position where there is one.
    Projected(i32, Option<[i32; 3]>),
    /// A list, made or changed.
    List(Box<Result<TriangleList, ErrorCode>>),
    /// Normals.
    Normals(Result<Vec<[i16; 3]>, ErrorCode>),
}

impl Reply {
    /// The number that a C function returns.
    pub fn number(&self) -> i32 {
        match self {
            Reply::Nothing => 0,
            Reply::Number(number) | Reply::Projected(number, _) => *number,
            Reply::List(list) => i32::from(list.is_ok()),
            Reply::Normals(normals) => i32::from(normals.is_ok()),
        }
    }
}

impl ListValue {
    /// The value of a list, its states aside.
    pub fn of(list: &TriangleList) -> ListValue {
        let vertices: Vec<u8> = list.vertices.iter().flat_map(|n| n.to_le_bytes()).collect();
        let indices: Vec<u8> = list.indices.iter().flat_map(|n| n.to_le_bytes()).collect();
        ListValue {
            vertex_format: list.vertex_format.bits(),
            index_format: list.index_format.bits(),
            vertices: vertices.into(),
            indices: indices.into(),
            commands: list.commands.iter().flat_map(|c| [c.count, c.state]).collect(),
            states: Vec::new(),
        }
    }

    /// The list, with `states` for its states.
    ///
    /// # Errors
    /// Those of [`TriangleList::from_parts`].
    pub fn list(&self, states: Vec<RasterState>) -> Result<TriangleList, ErrorCode> {
        let vertices = self.vertices.as_chunks().0.iter().map(|&n| i16::from_le_bytes(n));
        let indices = self.indices.as_chunks().0.iter().map(|&n| u16::from_le_bytes(n));
        let mut list = TriangleList::from_parts(
            VertexFormat::from_bits(self.vertex_format)?,
            vertices.collect(),
            IndexFormat::from_bits(self.index_format)?,
            indices.collect(),
            states,
        )?;
        let command = |&[count, state]: &[u16; 2]| Command { count, state };
        list.set_commands(self.commands.as_chunks().0.iter().map(command).collect())?;
        Ok(list)
    }
}
