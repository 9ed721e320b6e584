//! The objects of a program, and the calls on them.

use std::collections::BTreeMap;
use std::sync::Arc;

use fillrate_call::Data;
use fillrate_engine::{Counters, DeviceConfig};

use crate::call::{Call, ListValue, Reply, StateValue};
use crate::error::ErrorCode;
use crate::gpu::{Gpu, GpuConfig, Shown};
use crate::list::{IndexFormat, TriangleList, VertexFormat};
use crate::matrix::Matrix;
use crate::state::{DrawMode, RasterState, TriangleMode};
use crate::texture::{Texture, fits_triangles};

/// The most graphics processors at a time.
pub const MAX_GPUS: usize = 64;

/// A Quark library without global state: graphics processors and textures by
/// number.
#[derive(Debug, Default)]
pub struct Context {
    device: DeviceConfig,
    gpus: BTreeMap<u32, Gpu>,
    textures: BTreeMap<u32, Arc<Texture>>,
    /// The processor that showed a frame last.
    current: Option<u32>,
}

fn success(done: bool) -> Reply {
    Reply::Number(i32::from(done))
}

fn status(result: Result<(), ErrorCode>) -> Reply {
    Reply::Number(result.err().unwrap_or_default().code())
}

impl Context {
    /// A library without objects, whose processors draw as `device` says.
    pub fn new(device: DeviceConfig) -> Context {
        Context { device, ..Context::default() }
    }

    /// A processor.
    pub fn gpu(&mut self, gpu: u32) -> Option<&mut Gpu> {
        self.gpus.get_mut(&gpu)
    }

    /// A texture.
    pub fn texture(&self, texture: u32) -> Option<&Arc<Texture>> {
        self.textures.get(&texture)
    }

    /// The state that a value means.
    pub fn state(&self, value: &StateValue) -> RasterState {
        RasterState {
            draw_mode: DrawMode::from_number(value.draw_mode),
            draw_color: value.draw_color,
            draw_intensity: value.draw_intensity,
            test_culling: value.test_culling != 0,
            z_sort: value.z_sort != 0,
            texture: self.textures.get(&value.texture).cloned(),
        }
    }

    /// The frame that was shown last, by whichever processor.
    pub fn shown(&mut self) -> Option<Shown> {
        let gpu = self.gpus.get_mut(&self.current?)?;
        Some(gpu.shown())
    }

    /// Counters of the processor that showed a frame last.
    pub fn counters(&mut self) -> Counters {
        let gpu = self.current.and_then(|gpu| self.gpus.get_mut(&gpu));
        gpu.map_or_else(Counters::default, Gpu::counters)
    }

    /// Carries a call out. Calls on processors that do not exist do nothing.
    pub fn execute(&mut self, call: &Call) -> Reply {
        match call {
            Call::Init { gpu, near, far, fov } => self.init(*gpu, *near, *far, *fov),
            Call::Delete { gpu } => {
                self.gpus.remove(gpu);
                Reply::Nothing
            }
            Call::TextureInit { texture, texels, x, y, key } => {
                self.texture_init(*texture, texels, *x, *y, *key)
            }
            Call::Texture { texture, texels, x, y, keyed } => {
                self.set_texture(*texture, texels, [*x, *y], *keyed);
                Reply::Nothing
            }
            Call::ListInit { vertex_format, vertices, index_format, triangles } => {
                let list = new_list(*vertex_format, *vertices, *index_format, *triangles);
                Reply::List(Box::new(list))
            }
            Call::WeldVertex { list, position, intensity, uv } => {
                change(list, |list| list.weld(*position, *intensity, *uv))
            }
            Call::BuildCmdList { list, states } => change(list, |list| list.build_commands(states)),
            Call::BuildFNormalList { list } => {
                Reply::Normals(list.list(Vec::new()).map(|list| list.face_normals()))
            }
            Call::BuildVNormalList { list } => {
                Reply::Normals(list.list(Vec::new()).map(|list| list.vertex_normals()))
            }
            Call::TextState { gpu, state } => self.set_state(*gpu, state, |gpu, state| {
                gpu.text_state = state;
            }),
            Call::LineState { gpu, state } => self.set_state(*gpu, state, |gpu, state| {
                gpu.line_state = state;
            }),
            Call::SpriteState { gpu, state } => self.set_state(*gpu, state, |gpu, state| {
                gpu.sprite_state = state;
            }),
            Call::TriangleState { gpu, state } => {
                let state = state.as_ref().map(|state| self.state(state));
                self.on(*gpu, |gpu| {
                    gpu.triangle_state = state;
                    Reply::Nothing
                })
            }
            Call::DrawTriangleList { gpu, list } => self.draw_list(*gpu, list),
            Call::FlushFb { gpu, clear_color, .. } => {
                self.current = Some(*gpu);
                self.on(*gpu, |gpu| {
                    gpu.flush_frame(*clear_color as u16);
                    Reply::Nothing
                })
            }
            other => execute_on(self, other),
        }
    }

    /// Does something with a processor, if there is one.
    fn on(&mut self, gpu: u32, action: impl FnOnce(&mut Gpu) -> Reply) -> Reply {
        self.gpus.get_mut(&gpu).map_or(Reply::Nothing, action)
    }

    fn init(&mut self, gpu: u32, near: i32, far: i32, field_of_view: i32) -> Reply {
        self.gpus.remove(&gpu);
        if self.gpus.len() >= MAX_GPUS {
            return success(false);
        }
        let device = self.device.clone();
        let config = GpuConfig { near, far, field_of_view, device, ..GpuConfig::default() };
        let made = Gpu::new(config).map(|made| self.gpus.insert(gpu, made));
        success(made.is_ok())
    }

    fn texture_init(&mut self, number: u32, texels: &Data, x: i32, y: i32, key: i32) -> Reply {
        match Texture::new(texels, x, y, key) {
            Ok(texture) => {
                self.textures.insert(number, Arc::new(texture));
                success(fits_triangles(x, y))
            }
            Err(_) => {
                self.textures.remove(&number);
                success(false)
            }
        }
    }

    fn set_texture(&mut self, number: u32, texels: &Data, [x, y]: [i32; 2], keyed: bool) {
        let key = if keyed { 0 } else { -1 };
        match Texture::new(texels, x, y, key) {
            Ok(texture) => self.textures.insert(number, Arc::new(texture)),
            Err(_) => self.textures.remove(&number),
        };
    }

    fn set_state(
        &mut self,
        gpu: u32,
        state: &StateValue,
        set: impl FnOnce(&mut Gpu, RasterState),
    ) -> Reply {
        let state = self.state(state);
        self.on(gpu, |gpu| {
            set(gpu, state);
            Reply::Nothing
        })
    }

    fn draw_list(&mut self, gpu: u32, list: &ListValue) -> Reply {
        let states = list.states.iter().map(|state| self.state(state)).collect();
        match list.list(states) {
            Ok(list) => self.on(gpu, |gpu| status(gpu.draw_list(&list.view()))),
            Err(error) => status(Err(error)),
        }
    }
}

fn new_list(
    vertex_format: i32,
    vertices: i32,
    index_format: i32,
    triangles: i32,
) -> Result<TriangleList, ErrorCode> {
    let count = |n: i32| usize::try_from(n).map_err(|_| ErrorCode::Memory);
    let vertex_format = VertexFormat::from_bits(vertex_format)?;
    let index_format = IndexFormat::from_bits(index_format)?;
    TriangleList::new(vertex_format, count(vertices)?, index_format, count(triangles)?, Vec::new())
}

fn change(list: &ListValue, change: impl FnOnce(&mut TriangleList)) -> Reply {
    let changed = list.list(Vec::new()).map(|mut list| {
        change(&mut list);
        list
    });
    Reply::List(Box::new(changed))
}

/// Calls that need nothing but their processor.
fn execute_on(context: &mut Context, call: &Call) -> Reply {
    macro_rules! on {
        ($gpu:expr, |$name:ident| $body:expr) => {
            context.on(*$gpu, |$name| {
                $body;
                Reply::Nothing
            })
        };
    }
    match call {
        Call::SetWorkMemory { gpu, max_vertex, max_sort } => context.on(*gpu, |gpu| {
            let sizes = usize::try_from(*max_vertex).ok().zip(usize::try_from(*max_sort).ok());
            success(sizes.is_some_and(|(v, f)| gpu.set_work_memory(v, f).is_ok()))
        }),
        Call::PrintXy { gpu, text, x, y } => on!(gpu, |gpu| gpu.print_xy(text, *x, *y)),
        Call::PrintFps { gpu, ticks } => on!(gpu, |gpu| gpu.print_fps(*ticks)),
        Call::PutPixel { gpu, x, y, color } => {
            on!(gpu, |gpu| gpu.put_pixel(*x, *y, *color as u16))
        }
        Call::DrawLine { gpu, a, b } => on!(gpu, |gpu| gpu.draw_line(a, b)),
        Call::DrawSprite { gpu, x, y } => on!(gpu, |gpu| gpu.draw_sprite(*x, *y)),
        Call::DrawSpriteScale { gpu, x, y, scale } => {
            on!(gpu, |gpu| gpu.draw_sprite_scale(*x, *y, *scale))
        }
        Call::DrawSpriteScaleZb { gpu, top_left, bottom_right, z } => {
            on!(gpu, |gpu| gpu.draw_sprite_scale_zb(*top_left, *bottom_right, *z))
        }
        Call::DrawTriangle { gpu, a, b, c } => on!(gpu, |gpu| gpu.draw_triangle(a, b, c)),
        Call::SortReset { gpu } => on!(gpu, |gpu| gpu.sort_reset()),
        Call::SortDraw { gpu } => on!(gpu, |gpu| gpu.sort_draw()),
        Call::SetFov { gpu, fov } => {
            context.on(*gpu, |gpu| Reply::Number(gpu.camera.set_field_of_view(*fov).unwrap_or(0)))
        }
        Call::ScrProjection { gpu, position } => context.on(*gpu, |gpu| {
            let (mask, at) = gpu.camera.project(position);
            Reply::Projected(mask, at)
        }),
        Call::SetNfClip { gpu, near, far } => {
            context.on(*gpu, |gpu| success(gpu.camera.set_planes(*near, *far).is_ok()))
        }
        Call::ClipMsk { gpu, position } => {
            context.on(*gpu, |gpu| Reply::Number(gpu.camera.clip_mask(position)))
        }
        Call::CrossFrustrum { gpu, corners } => {
            context.on(*gpu, |gpu| success(gpu.camera.crosses_frustum(corners)))
        }
        Call::TriangleMode { gpu, mode } => {
            on!(gpu, |gpu| gpu.triangle_mode = TriangleMode::from_number(*mode))
        }
        Call::ViewMatrix { gpu, matrix } => {
            on!(gpu, |gpu| gpu.view_matrix = matrix.map(|m| Matrix { m }))
        }
        Call::ZcErrorMax { gpu, error } => on!(gpu, |gpu| gpu.zc_error_max = *error),
        Call::Camera { gpu, zoom, near, far, frustum } => on!(gpu, |gpu| {
            let camera = &mut gpu.camera;
            (camera.zoom, camera.near, camera.far) = (*zoom, *near, *far);
            camera.frustum = *frustum;
        }),
        Call::FrameCounter { gpu, count } => on!(gpu, |gpu| gpu.frame_counter = *count),
        Call::FrameBuffer { gpu, words } => on!(gpu, |gpu| {
            let word = |pair: &[u8; 8]| {
                let half = |at: usize| u32::from_le_bytes([0, 1, 2, 3].map(|i| pair[at + i]));
                (half(0) as usize, half(4))
            };
            gpu.write_frame_buffer(words.as_chunks().0.iter().map(word));
        }),
        _ => Reply::Nothing,
    }
}
