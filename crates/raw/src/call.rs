//! The one border of this front end: every client call as a value.
//!
//! Each variant is one call of the client interface (`render_client.h`). [`Call::words`] turns it
//! into device words, [`crate::client::Client`] sends it. Source: RAW, client listing.

use fillrate_call::value_enum;

value_enum! {
    /// Every call of the client interface that reaches the device.
    pub enum Call {
        /// Starts the client afresh; sends nothing.
        1 => Init {},
        /// Enters scene-streaming mode.
        2 => BeginScene {},
        /// Leaves scene-streaming mode.
        3 => EndScene {},
        /// Begins a primitive: counts it.
        4 => BeginPrim {},
        /// Ends a primitive.
        5 => EndPrim {},
        /// A vertex; only in a scene.
        6 => Vertex { x: f32, y: f32, z: f32, u: f32, v: f32 },
        /// The colour of later vertices, rgba.
        7 => Color { rgba: u32 },
        /// Model to world, row by row.
        8 => ModelMatrix { m: [f32; 16] },
        /// World to view, row by row.
        9 => ViewMatrix { m: [f32; 16] },
        /// The normal of later vertices.
        10 => Normal { x: f32, y: f32, z: f32 },
        /// One of the commands with opcodes 8 to 21: a mode field or the texture id.
        11 => Set { opcode: u32, value: u32 },
        /// The weight of the colour in blend mode.
        12 => ColTexBalance { balance: f32 },
        /// The threshold of hard alpha.
        13 => AlphaThresh { threshold: u32 },
        /// Ambient light, rgb and intensity.
        14 => AmbColor { rgbi: u32 },
        /// Directional light, rgb and intensity.
        15 => DirColor { rgbi: u32 },
        /// The direction in which the light travels.
        16 => DirLight { x: f32, y: f32, z: f32 },
        /// Ambient reflectance.
        17 => AmbReflect { amount: u32 },
        /// Directional reflectance.
        18 => DirReflect { amount: u32 },
        /// Fills pages.
        19 => ClearFb { pages: u32, rgbx: u32 },
        /// Clears the depths.
        20 => ClearZ {},
        /// Chooses the pages to draw to.
        21 => SetPage { pages: u32 },
        /// Swaps the pages.
        22 => FlipPage { wait: u32 },
        /// Allocates a texture; the device answers with its id.
        23 => AllocateTexture { width: u32, height: u32 },
        /// Frees a texture.
        24 => DeallocTexture { id: u32 },
        /// Writes texels.
        25 => UploadTexture { id: u32, texels: Vec<u32> },
        /// Asks for the free texture memory.
        26 => TexMemAvail {},
        /// Moves textures together.
        27 => CompactTexMem {},
        /// Writes a pixel.
        28 => WriteFb { x: u32, y: u32, pages: u32, rgbx: u32 },
        /// Writes a run of pixels.
        29 => WriteFbBlock { x: u32, y: u32, pages: u32, pixels: Vec<u32> },
        /// Asks for a pixel.
        30 => ReadFb { x: u32, y: u32, page: u32 },
        /// Asks for a run of pixels.
        31 => ReadFbBlock { x: u32, y: u32, page: u32, count: u32 },
        /// Writes a depth.
        32 => WriteZ { x: u32, y: u32, z: i32 },
        /// Writes a run of depths.
        33 => WriteZBlock { x: u32, y: u32, depths: Vec<i32> },
        /// Asks for a depth.
        34 => ReadZ { x: u32, y: u32 },
        /// Asks for a run of depths.
        35 => ReadZBlock { x: u32, y: u32, count: u32 },
        /// Puts the device back to its defaults, and the client with it.
        36 => Reset {},
        /// Stops the device.
        37 => Halt {},
        /// One word to the device, as it is.
        38 => SendWord { word: u32 },
        /// A record for the host interface, by its name; or text for its log.
        39 => Meta { text: String },
        /// Asks for the next word that came back.
        40 => ReadWord {},
        /// What the vertices of a primitive make up. This and all that follow: beyond the thesis.
        41 => SetPrimitive { kind: u32 },
        /// What is done at the borders of the view.
        42 => SetClip { planes: u32 },
        /// How levels of a texture are used.
        43 => SetMipMap { mode: u32 },
        /// The side of a point in pixels.
        44 => SetPointSize { pixels: u32 },
        /// Keeps a vertex with the current colour and normal.
        45 => StoreVertex { index: u32, x: f32, y: f32, z: f32, u: f32, v: f32 },
        /// Adds a kept vertex to the primitive; only in a scene.
        46 => Index { index: u32 },
        /// A further light.
        47 => Light { number: u32, rgbi: u32, x: f32, y: f32, z: f32 },
        /// Highlights.
        48 => Specular { rgbi: u32, exponent: u32 },
        /// Where the viewer stands.
        49 => Eye { x: f32, y: f32, z: f32 },
        /// Allocates a texture with all its levels; the device answers with its id.
        50 => AllocateMipMapped { width: u32, height: u32 },
        /// Makes the levels of a texture from its finest one.
        51 => MakeMipMaps { id: u32 },
        /// Changes the resolution.
        52 => Resize { width: u32, height: u32 },
        /// Resets the device whatever it is doing, and the client with it.
        53 => AsyncReset {},
    }
}

/// Where a call may be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    Anywhere,
    Scene,
    Command,
}

impl Call {
    /// The device words of the call, without framing; empty for calls that send none.
    ///
    /// Calls made in the wrong mode are silently left out, as the client does.
    pub fn words(&self, in_scene: bool) -> Vec<u32> {
        let mut out = Vec::new();
        match self.place() {
            Place::Scene if !in_scene => return out,
            Place::Command if in_scene => return out,
            _ => {}
        }
        self.fixed(&mut out);
        match self {
            Call::UploadTexture { texels, .. } => out.extend(texels),
            Call::WriteFbBlock { pixels, .. } => out.extend(pixels),
            Call::WriteZBlock { depths, .. } => out.extend(depths.iter().map(|z| *z as u32)),
            _ => {}
        }
        out
    }

    fn place(&self) -> Place {
        match self {
            Call::Vertex { .. } | Call::EndScene {} | Call::EndPrim {} | Call::BeginPrim {} => {
                Place::Scene
            }
            Call::SendWord { .. } | Call::Meta { .. } | Call::ReadWord {} => Place::Anywhere,
            Call::Index { .. } => Place::Scene,
            Call::SetPrimitive { .. } | Call::SetClip { .. } | Call::SetMipMap { .. } => {
                Place::Anywhere
            }
            Call::SetPointSize { .. } | Call::StoreVertex { .. } => Place::Anywhere,
            Call::Light { .. } | Call::Specular { .. } | Call::Eye { .. } => Place::Anywhere,
            Call::AsyncReset {} => Place::Anywhere,
            Call::Init {} | Call::Color { .. } | Call::ModelMatrix { .. } => Place::Anywhere,
            Call::ViewMatrix { .. } | Call::Normal { .. } | Call::Set { .. } => Place::Anywhere,
            Call::ColTexBalance { .. } | Call::AlphaThresh { .. } => Place::Anywhere,
            Call::AmbColor { .. } | Call::DirColor { .. } | Call::DirLight { .. } => {
                Place::Anywhere
            }
            Call::AmbReflect { .. } | Call::DirReflect { .. } => Place::Anywhere,
            _ => Place::Command,
        }
    }

    fn fixed(&self, out: &mut Vec<u32>) {
        let f = |v: &f32| v.to_bits();
        match self {
            Call::Init {} | Call::BeginPrim {} | Call::EndPrim {} => {}
            Call::SendWord { .. } | Call::Meta { .. } | Call::ReadWord {} => {}
            Call::BeginScene {} => out.push(1),
            Call::EndScene {} => out.push(2),
            Call::Vertex { x, y, z, u, v } => out.extend([3, f(x), f(y), f(z), f(u), f(v)]),
            Call::Color { rgba } => out.extend([4, *rgba]),
            Call::ModelMatrix { m } => out.extend([5].into_iter().chain(m.iter().map(f))),
            Call::ViewMatrix { m } => out.extend([6].into_iter().chain(m.iter().map(f))),
            Call::Normal { x, y, z } => out.extend([7, f(x), f(y), f(z)]),
            // A value outside the mode commands would not be this call.
            Call::Set { opcode, value } => out.extend([(*opcode).clamp(8, 21), *value]),
            Call::ColTexBalance { balance } => out.extend([22, f(balance)]),
            Call::AlphaThresh { threshold } => out.extend([23, *threshold]),
            Call::AmbColor { rgbi } => out.extend([24, *rgbi]),
            Call::DirColor { rgbi } => out.extend([25, *rgbi]),
            Call::DirLight { x, y, z } => out.extend([26, f(x), f(y), f(z)]),
            Call::AmbReflect { amount } => out.extend([27, *amount]),
            Call::DirReflect { amount } => out.extend([28, *amount]),
            _ => self.fixed_command(out),
        }
    }

    fn fixed_command(&self, out: &mut Vec<u32>) {
        match self {
            Call::ClearFb { pages, rgbx } => out.extend([29, *pages, *rgbx]),
            Call::ClearZ {} => out.push(30),
            Call::SetPage { pages } => out.extend([31, *pages]),
            Call::FlipPage { wait } => out.extend([32, *wait]),
            Call::AllocateTexture { width, height } => out.extend([33, *width, *height]),
            Call::DeallocTexture { id } => out.extend([34, *id]),
            Call::UploadTexture { id, texels } => out.extend([35, *id, texels.len() as u32]),
            Call::TexMemAvail {} => out.push(36),
            Call::CompactTexMem {} => out.push(37),
            Call::WriteFb { x, y, pages, rgbx } => out.extend([38, *x, *y, *pages, *rgbx]),
            Call::WriteFbBlock { x, y, pages, pixels } => {
                out.extend([39, *x, *y, *pages, pixels.len() as u32]);
            }
            Call::ReadFb { x, y, page } => out.extend([40, *x, *y, *page]),
            Call::ReadFbBlock { x, y, page, count } => out.extend([41, *x, *y, *page, *count]),
            Call::WriteZ { x, y, z } => out.extend([42, *x, *y, *z as u32]),
            Call::WriteZBlock { x, y, depths } => {
                out.extend([43, *x, *y, depths.len() as u32]);
            }
            Call::ReadZ { x, y } => out.extend([44, *x, *y]),
            Call::ReadZBlock { x, y, count } => out.extend([45, *x, *y, *count]),
            Call::Reset {} => out.push(46),
            Call::Halt {} => out.push(47),
            _ => self.fixed_beyond(out),
        }
    }

    fn fixed_beyond(&self, out: &mut Vec<u32>) {
        let f = |v: &f32| v.to_bits();
        match self {
            Call::SetPrimitive { kind } => out.extend([64, *kind]),
            Call::SetClip { planes } => out.extend([65, *planes]),
            Call::SetMipMap { mode } => out.extend([66, *mode]),
            Call::SetPointSize { pixels } => out.extend([67, *pixels]),
            Call::StoreVertex { index, x, y, z, u, v } => {
                out.extend([68, *index, f(x), f(y), f(z), f(u), f(v)]);
            }
            Call::Index { index } => out.extend([69, *index]),
            Call::Light { number, rgbi, x, y, z } => {
                out.extend([70, *number, *rgbi, f(x), f(y), f(z)]);
            }
            Call::Specular { rgbi, exponent } => out.extend([71, *rgbi, *exponent]),
            Call::Eye { x, y, z } => out.extend([72, f(x), f(y), f(z)]),
            Call::AllocateMipMapped { width, height } => out.extend([73, *width, *height]),
            Call::MakeMipMaps { id } => out.extend([74, *id]),
            Call::Resize { width, height } => out.extend([75, *width, *height]),
            _ => {}
        }
    }

    /// Number of words the device answers with.
    pub fn answers(&self, in_scene: bool) -> u32 {
        match self {
            Call::ReadWord {} => 1,
            _ if in_scene => 0,
            Call::AllocateTexture { .. } | Call::AllocateMipMapped { .. } => 1,
            Call::TexMemAvail {} => 1,
            Call::ReadFb { .. } | Call::ReadZ { .. } => 1,
            Call::ReadFbBlock { count, .. } | Call::ReadZBlock { count, .. } => *count,
            _ => 0,
        }
    }
}
