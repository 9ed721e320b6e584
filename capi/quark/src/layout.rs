//! The objects of the header, as they lie in the program's memory.

use fillrate_quark::Vertex;

/// `CTexture`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct RawTexture {
    pub(crate) size_x: i32,
    pub(crate) size_y: i32,
    pub(crate) texels: *mut u8,
    pub(crate) mask_x: u32,
    pub(crate) mask_y: u32,
}

/// `TRasterState`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct RawState {
    pub(crate) draw_mode: u8,
    pub(crate) draw_color: u8,
    pub(crate) draw_intensity: u8,
    pub(crate) test_culling: u8,
    pub(crate) z_sort: u8,
    pub(crate) padding: [u8; 3],
    pub(crate) texture: *const RawTexture,
}

/// `CTriangleList`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct RawList {
    pub(crate) vertex_list: *mut i16,
    pub(crate) vertex_list_size: i32,
    pub(crate) vertex_stride: i32,
    pub(crate) index_list: *mut u16,
    pub(crate) index_list_size: i32,
    pub(crate) index_stride: i32,
    pub(crate) vertex_uv: i32,
    pub(crate) vertex_intensity: i32,
    pub(crate) index_uv: i32,
    pub(crate) index_intensity: i32,
    pub(crate) index_color: i32,
    pub(crate) state: *const RawState,
    pub(crate) command_minimal: [u16; 2],
    pub(crate) command_list: *mut u16,
    pub(crate) command_list_size: i32,
    pub(crate) error_code: i32,
}

/// `CMatrix`.
pub type RawMatrix = [i32; 12];

/// `TVertex`.
pub type RawVertex = Vertex;

/// `CVGpu`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct RawGpu {
    pub(crate) text_state: RawState,
    pub(crate) line_state: RawState,
    pub(crate) sprite_state: RawState,
    pub(crate) triangle_state: *const RawState,
    pub(crate) triangle_mode: i32,
    pub(crate) zoom: i32,
    pub(crate) clip_near: i32,
    pub(crate) clip_far: i32,
    pub(crate) frustum: [[i32; 3]; 4],
    pub(crate) view_matrix: *const RawMatrix,
    pub(crate) frame_counter: i32,
    pub(crate) frame_buffer: *mut u32,
    pub(crate) zc_error_max: i32,
}

#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(size_of::<RawTexture>() == 24);
    assert!(size_of::<RawState>() == 16);
    assert!(size_of::<RawList>() == 88);
    assert!(size_of::<RawGpu>() == 152);
};
#[cfg(target_pointer_width = "32")]
const _: () = {
    assert!(size_of::<RawTexture>() == 20);
    assert!(size_of::<RawState>() == 12);
    assert!(size_of::<RawList>() == 64);
    assert!(size_of::<RawGpu>() == 120);
};
const _: () = assert!(size_of::<RawVertex>() == 28 && size_of::<RawMatrix>() == 48);
