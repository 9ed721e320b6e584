//! Engines that an application brings along.
//!
//! Source: RAVE, engine side.

use crate::call::{Call, Reply};
use crate::gestalt::Answer;
use crate::vertex::{DeviceValue, VGouraud, VTexture};
use crate::{RaveError, constants::vertex_mode};

/// A drawing engine of an application: what `QARegisterEngine` takes.
///
/// The manager asks it for contexts and other objects and hands it the calls on
/// them. It does not have to draw arrays and meshes: the manager splits those.
pub trait Engine: Send + core::fmt::Debug {
    /// `QAEngineGestalt`.
    ///
    /// # Errors
    /// [`RaveError::GestaltUnknown`] for selectors that it does not know. All
    /// engines know vendor, engine and revision.
    fn gestalt(&mut self, selector: u32) -> Result<Answer, RaveError>;

    /// Whether it draws on a device; `None` is any.
    ///
    /// # Errors
    /// Why not.
    fn check_device(&mut self, device: Option<&DeviceValue>) -> Result<(), RaveError>;

    /// Whether it has a method for a call, by its number
    /// ([`fillrate_call::Tagged::tag`]).
    fn offers(&self, call: u16) -> bool;

    /// Carries a call out. A new object is named `number` in the calls that
    /// follow.
    fn execute(&mut self, call: &Call, number: u32) -> Reply;
}

/// The calls that an array or mesh is split into, where an engine has no method
/// for it; `None` where the call cannot be split.
pub(crate) fn split(call: &Call, submitted: &Submitted) -> Option<Vec<Call>> {
    Some(match call {
        Call::DrawVGouraud { context, mode, vertices, flags } => {
            split_array(*mode, vertices, flags, *context, &gouraud_calls())
        }
        Call::DrawVTexture { context, mode, vertices, flags } => {
            split_array(*mode, vertices, flags, *context, &texture_calls())
        }
        Call::DrawTriMeshGouraud { context, triangles } => triangles
            .iter()
            .filter_map(|triangle| {
                let [a, b, c] = triangle.vertices.map(|i| submitted.gouraud.get(i as usize));
                let (a, b, c, flags) = (*a?, *b?, *c?, triangle.flags);
                Some(Call::DrawTriGouraud { context: *context, a, b, c, flags })
            })
            .collect(),
        Call::DrawTriMeshTexture { context, triangles } => triangles
            .iter()
            .filter_map(|triangle| {
                let [a, b, c] = triangle.vertices.map(|i| submitted.texture.get(i as usize));
                let (a, b, c, flags) = (*a?, *b?, *c?, triangle.flags);
                Some(Call::DrawTriTexture { context: *context, a, b, c, flags })
            })
            .collect(),
        _ => return None,
    })
}

/// The vertices that meshes of a context refer to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Submitted {
    pub gouraud: Vec<VGouraud>,
    pub texture: Vec<VTexture>,
}

/// How the primitives of a kind of vertex are called.
struct Calls<V> {
    point: fn(u32, V) -> Option<Call>,
    line: fn(u32, [V; 2]) -> Option<Call>,
    triangle: fn(u32, [V; 3], u32) -> Call,
}

fn gouraud_calls() -> Calls<VGouraud> {
    Calls {
        point: |context, v| Some(Call::DrawPoint { context, v }),
        line: |context, [a, b]| Some(Call::DrawLine { context, a, b }),
        triangle: |context, [a, b, c], flags| Call::DrawTriGouraud { context, a, b, c, flags },
    }
}

/// Engines without a method of their own ignore textured points and lines.
fn texture_calls() -> Calls<VTexture> {
    Calls {
        point: |_, _| None,
        line: |_, _| None,
        triangle: |context, [a, b, c], flags| Call::DrawTriTexture { context, a, b, c, flags },
    }
}

fn split_array<V: Copy>(
    mode: u32,
    v: &[V],
    flags: &Option<Vec<u32>>,
    context: u32,
    calls: &Calls<V>,
) -> Vec<Call> {
    let flag = |i: usize| flags.as_ref().and_then(|flags| flags.get(i)).copied().unwrap_or(0);
    let triangle = |(i, corners): (usize, [V; 3])| (calls.triangle)(context, corners, flag(i));
    let windows = || v.windows(3).map(|w| [w[0], w[1], w[2]]);
    match mode {
        vertex_mode::POINT => v.iter().filter_map(|&v| (calls.point)(context, v)).collect(),
        vertex_mode::LINE => {
            v.as_chunks().0.iter().filter_map(|&ends| (calls.line)(context, ends)).collect()
        }
        vertex_mode::POLYLINE => {
            v.windows(2).filter_map(|w| (calls.line)(context, [w[0], w[1]])).collect()
        }
        vertex_mode::TRI => v.as_chunks().0.iter().copied().enumerate().map(triangle).collect(),
        vertex_mode::STRIP => windows().enumerate().map(triangle).collect(),
        vertex_mode::FAN => {
            windows().map(|[_, b, c]| [v[0], b, c]).enumerate().map(triangle).collect()
        }
        _ => Vec::new(),
    }
}
