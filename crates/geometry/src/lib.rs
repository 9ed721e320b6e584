//! The application's half of a 3D program: everything between a model and the
//! vertices that a rasterizer of the 1990s takes, which neither clipped nor
//! projected. Front ends, programs and engines share it; it names no API.
//!
//! View space is left-handed: x to the right, y up, z into the screen, the eye
//! at the origin (TN, screen coordinates). Distances are in the units of the
//! world, screen positions in pixels from the top left, depths from 0 (near)
//! to 1 (far).
//!
//! All arithmetic is plain `f32`: sums from left to right as written, no fused
//! operations, square roots as IEEE 754 has them; sines and tangents are our
//! own series. The same input gives the same bits on every machine.
//!
//! Bad input (not-a-number, values beyond [`MAX_MAGNITUDE`], planes without a
//! normal, empty lists) gives an empty result or an [`Error`]; nothing panics.
//!
//! ```
//! use fillrate_geometry::*;
//!
//! let view = View::with_field_of_view(640.0, 480.0, TECHNOTE_FIELD_OF_VIEW, 1.0, 500.0)?;
//! let frustum = Frustum::new(&view);
//! let projection =
//!     Projection { view, map: DepthMap::Projective, scale: DepthScale::BITS_16 };
//! let mut clipper = Clipper::new();
//!
//! // A triangle in view space with u and v, which reaches past the right side.
//! let triangle = [(0.0, 0.0), (0.0, 10.0), (90.0, 0.0)]
//!     .map(|(x, y)| Vertex::new(Vec3::new(x, y, 40.0), [x / 90.0, y / 10.0]));
//! let around = Sphere { centre: Vec3::new(30.0, 3.0, 40.0), radius: 65.0 };
//! let Containment::Within(crossed) = frustum.test_sphere(&around, PlaneMask::ALL) else {
//!     return Ok(());
//! };
//! let clipped = frustum.clip(&mut clipper, &triangle, crossed);
//! assert_eq!(clipped.len(), 4);
//! for vertex in clipped.iter().filter_map(|vertex| projection.project(vertex)) {
//!     assert!(vertex.x < 640.0 && vertex.z < 1.0);
//!     let (_u_over_w, _v_over_w) = (vertex.over_w(0), vertex.over_w(1));
//! }
//! # Ok::<(), Error>(())
//! ```
//!
//! TN in these documents is the technote on building a 3D application with
//! RAVE; see `docs/sources.md`.

#![forbid(unsafe_code)]

mod bsp;
mod clip;
mod error;
mod frustum;
mod loader;
mod lod;
mod mip;
mod normalized;
mod plane;
mod portal;
mod preflight;
mod project;
mod pvs;
mod transform;
mod trig;
mod vector;
mod view;

pub use bsp::{BspTree, Child, Node, Order};
pub use clip::{Clipper, HalfSpace, MAX_VERTICES, Vertex, clip_line, clip_point};
pub use error::Error;
pub use frustum::{Containment, Frustum, PlaneMask, Sphere};
pub use loader::{FrameHost, render_frame};
pub use lod::{choose_level, keep_or_choose_level, projected_radius};
pub use mip::{WantedTexture, fit_levels, mip_level};
pub use normalized::{NormalizedFrustum, NormalizedSide};
pub use plane::Plane;
pub use portal::{Portal, Rooms};
pub use preflight::{Batch, Draw, Plan, TextureId, plan_frame};
pub use project::{DepthMap, DepthScale, Projection, ScreenVertex};
pub use pvs::{LeafSet, VisibleSets};
pub use transform::Transform;
pub use trig::{sin_cos, tan};
pub use vector::{MAX_MAGNITUDE, Vec3};
pub use view::{TECHNOTE_FIELD_OF_VIEW, View};
