//! What drawing needs of a context's state, once for all primitives.

use std::sync::Arc;

use fillrate_engine::state::MAX_TMUS;
use fillrate_engine::{DrawState, Texture};

use crate::RaveError;
use crate::constants::{fog, texture_op};
use crate::draw_context::DrawContext;
use crate::fog::FogCurve;
use crate::handle::TextureId;
use crate::memory::ResourceId;
use crate::objects::Objects;
use crate::state::unit_byte;
use crate::tags::{float, int};
use crate::texture::Decoding;
use crate::translate::{
    FogSource, Paint, PatternUse, Plane, Sampled, Surroundings, Variant, always_replaces, clamps,
    layer_count, opaque_alpha_replaces,
};

/// A texture as vertices see it.
#[derive(Clone, Debug)]
pub(crate) struct Bound {
    pub texels: Arc<Texture>,
    /// Columns and rows.
    pub size: [f32; 2],
    /// Rows are stored bottom first.
    pub flipped: bool,
    pub opaque: bool,
    pub levels: usize,
    pub resource: Option<ResourceId>,
}

/// What drawing needs of the state.
#[derive(Debug)]
pub(crate) struct Prepared {
    pub around: Surroundings,
    /// The texture and the layers, without gaps.
    pub bound: [Option<Bound>; MAX_TMUS],
    /// The bitmap that is drawn now.
    pub bitmap: Option<Bound>,
    pub layers: usize,
    /// Of all that is bound.
    pub resources: Vec<ResourceId>,
    pub op: u32,
    /// Vertex alpha is fog.
    pub alpha_fog: bool,
    /// Fog by distance.
    pub curve: Option<FogCurve>,
    pub fog_max_depth: f32,
    /// Factor of 1/w where it is fog's distance or the depth.
    pub w_scale: f32,
    /// Alpha of 1 leaves nothing of the destination.
    pub opaque_alpha: bool,
    /// Nothing is left of the destination.
    pub always_opaque: bool,
    /// Corners of usual values need no more than [`Prepared::usual`].
    pub is_plain: bool,
    /// Tells it from all others.
    pub serial: u64,
    /// Draw states made so far.
    pub variants: Vec<(Variant, DrawState)>,
}

/// Factor of 1/w where it is the depth: most of the register's 48 bits are used
/// for 1/w up to 1, and 1/w up to 2 fits.
const DEPTH_SCALE: f32 = (1 << 14) as f32;

/// What drawing needs of a context's state.
pub(super) fn prepare(context: &mut DrawContext, objects: &mut Objects, serial: u64) -> Prepared {
    let key = key(context);
    let mut bound = [const { None }; MAX_TMUS];
    let decoding =
        Decoding { clamp: clamps(&context.state)[0], key, border: context.state.border() };
    let base = bind(context, objects, context.state.texture, decoding);
    if base.is_some() {
        bound[0] = base;
        let layers = context.state.int(int::MULTI_TEXTURE_ENABLE) as usize;
        for layer in 0..layers.min(MAX_TMUS - 1) {
            let layer_state = context.state.layers[layer];
            let clamp = layer_state.wrap[0] != 0;
            let decoding = Decoding { clamp, key: None, border: layer_state.border() };
            match bind(context, objects, layer_state.texture, decoding) {
                Some(texture) => bound[layer + 1] = Some(texture),
                None => break,
            }
        }
    }
    let curve = FogCurve::of(&context.state);
    if context.fog_table.0 != curve {
        let table = curve.as_ref().map(FogCurve::table).unwrap_or_default();
        context.fog_table = (curve, table);
    }
    let state = &context.state;
    let sampled = |bound: &Option<Bound>, keyed: bool| {
        bound.as_ref().map(|bound| Sampled { levels: bound.levels, keyed })
    };
    let plane = context.plane();
    let around = Surroundings {
        size: context.size,
        format: context.format,
        dithers: context.dither() != fillrate_engine::state::Dither::Off,
        plane,
        sampled: core::array::from_fn(|i| sampled(&bound[i], i == 0 && key.is_some())),
    };
    let mut prepared = Prepared {
        layers: layer_count(&around),
        resources: bound.iter().flatten().filter_map(|bound| bound.resource).collect(),
        around,
        bound,
        bitmap: None,
        op: state.int(int::TEXTURE_OP),
        alpha_fog: state.int(int::FOG_MODE) == fog::ALPHA,
        w_scale: match (plane, &curve) {
            (Plane::InverseW, _) => DEPTH_SCALE,
            (_, Some(curve)) => curve.scale(),
            _ => 1.0,
        },
        curve,
        fog_max_depth: state.float(float::FOG_MAX_DEPTH),
        opaque_alpha: opaque_alpha_replaces(state),
        always_opaque: always_replaces(state),
        is_plain: false,
        serial,
        variants: Vec::new(),
    };
    prepared.is_plain = prepared.bound[0].is_some()
        && prepared.layers == 0
        && prepared.op & !(texture_op::MODULATE | texture_op::SHRINK) == 0
        && !prepared.alpha_fog
        && !prepared.extends(prepared.fog_source(true));
    prepared
}

/// The chroma key, 0x00RRGGBB, where it is on.
fn key(context: &DrawContext) -> Option<u32> {
    let channel = |tag: u32| unit_byte(context.state.float(tag));
    (context.state.int(int::CHROMAKEY_ENABLE) != 0).then(|| {
        channel(float::CHROMAKEY_R) << 16
            | channel(float::CHROMAKEY_G) << 8
            | channel(float::CHROMAKEY_B)
    })
}

/// A texture of the program, ready to be sampled. Deleted ones, and those that
/// the program has access to, are errors, and not drawn with.
fn bind(
    context: &mut DrawContext,
    objects: &mut Objects,
    texture: Option<TextureId>,
    decoding: Decoding,
) -> Option<Bound> {
    let id = texture?;
    let Some(picture) = objects.textures.get_mut(&id.0) else {
        context.fail(RaveError::Parameter);
        return None;
    };
    if picture.accessed.is_some() {
        context.fail(RaveError::Failure);
        return None;
    }
    let (width, height) = picture.size();
    let (flipped, levels, resource) =
        (picture.is_flipped(), picture.levels.len(), picture.resource);
    let decoded = picture.decoded(decoding);
    Some(Bound {
        texels: decoded.texels.clone(),
        size: [width as f32, height as f32],
        flipped,
        opaque: decoded.opaque && decoding.key.is_none(),
        levels,
        resource,
    })
}

/// A bitmap, ready to be drawn.
pub(super) fn bind_bitmap(
    context: &mut DrawContext,
    objects: &mut Objects,
    bitmap: u32,
) -> Option<Bound> {
    let key = key(context);
    let Some(picture) = objects.bitmaps.get_mut(&bitmap) else {
        context.fail(RaveError::Parameter);
        return None;
    };
    if picture.accessed.is_some() {
        context.fail(RaveError::Failure);
        return None;
    }
    let (width, height) = picture.size();
    let (flipped, resource) = (picture.is_flipped(), picture.resource);
    let decoded = picture.decoded(Decoding { clamp: true, key, border: None });
    Some(Bound {
        texels: decoded.texels.clone(),
        size: [width as f32, height as f32],
        flipped,
        opaque: decoded.opaque && key.is_none(),
        levels: 1,
        resource,
    })
}

impl Prepared {
    /// The textures of the engine's units.
    pub fn textures_of(&self, paint: Paint) -> [Option<Arc<Texture>>; MAX_TMUS] {
        let texels = |bound: &Option<Bound>| bound.as_ref().map(|bound| bound.texels.clone());
        let mut textures = [const { None }; MAX_TMUS];
        match paint {
            Paint::Gouraud => {}
            Paint::Bitmap => textures[0] = texels(&self.bitmap),
            Paint::Texture => {
                for (i, bound) in self.bound.iter().enumerate().take(self.layers + 1) {
                    textures[self.layers - i] = texels(bound);
                }
            }
        }
        textures
    }

    /// Draws bitmaps with this one in the place of the texture, and gives back what
    /// was there.
    pub fn exchange_bitmap(
        &mut self,
        serial: u64,
        bitmap: Option<Bound>,
        sampled: Option<Sampled>,
    ) -> Option<Sampled> {
        self.serial = serial;
        self.variants.retain(|(variant, _)| variant.paint != Paint::Bitmap);
        self.bitmap = bitmap;
        std::mem::replace(&mut self.around.sampled[0], sampled)
    }

    /// Whether a texture operation is on.
    #[inline]
    pub fn has(&self, op: u32) -> bool {
        self.op & op != 0
    }

    /// Whether textured vertices carry more than the engine's own values.
    #[inline]
    pub fn extends_texture(&self, fog: FogSource) -> bool {
        let decal = texture_op::DECAL | texture_op::MODULATE;
        self.has(texture_op::HIGHLIGHT) || self.op & decal == decal || self.extends(fog)
    }

    /// Whether any vertices do.
    #[inline]
    pub fn extends(&self, fog: FogSource) -> bool {
        fog == FogSource::Vertices || self.around.plane == Plane::Deep
    }

    /// Where fog comes from for vertices; `has_w`: all have a positive 1/w.
    #[inline]
    pub fn fog_source(&self, has_w: bool) -> FogSource {
        match (&self.curve, self.alpha_fog) {
            (None, false) => FogSource::None,
            // 1/w is scaled for the depth plane, out of the table's range.
            (Some(_), _) if has_w && self.around.plane != Plane::InverseW => FogSource::Fragment,
            _ => FogSource::Vertices,
        }
    }

    /// How textured triangles are drawn; `has_w`: all corners have a positive 1/w.
    #[inline(always)]
    pub fn variant(&self, has_w: bool, alpha_is_one: bool, bright: bool) -> Variant {
        let texel_is_opaque = self.bound[0].as_ref().is_some_and(|bound| bound.opaque);
        let texel_is_opaque = texel_is_opaque || self.has(texture_op::DECAL);
        Variant {
            paint: Paint::Texture,
            opaque: self.is_opaque(alpha_is_one && texel_is_opaque),
            bright,
            fog: self.fog_source(has_w),
            pattern: PatternUse::Area,
        }
    }

    /// Whether nothing of the destination is left under alphas like these.
    #[inline]
    pub fn is_opaque(&self, alpha_is_one: bool) -> bool {
        self.always_opaque || self.opaque_alpha && alpha_is_one
    }
}
