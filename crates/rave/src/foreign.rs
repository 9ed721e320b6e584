//! Calls on objects of the application's own engines.

use std::collections::BTreeMap;

use fillrate_call::Tagged;

use crate::RaveError;
use crate::call::{Call, Reply};
use crate::context::Context;
use crate::engine::{Engine, Submitted, split};
use crate::handle::EngineId;

/// Which engine a context belongs to, and what its meshes refer to.
#[derive(Debug, Default)]
pub(crate) struct Foreign {
    contexts: BTreeMap<u32, (EngineId, Submitted)>,
}

/// Whom a call is for.
enum Subject {
    Manager,
    Engine(u32),
    Context(u32),
}

impl Context {
    /// Hands a call to the application's engine that it is for; `None` where it
    /// is for this crate's.
    pub(crate) fn execute_foreign(&mut self, call: &Call) -> Option<Reply> {
        let id = match subject(call) {
            Subject::Manager => return None,
            Subject::Engine(engine) => EngineId(engine),
            Subject::Context(context) => self.foreign.contexts.get(&context)?.0,
        };
        let engine = self.manager.foreign(id)?;
        let number = self.objects.numbers + 1;
        let reply = match subject(call) {
            Subject::Context(context) if !engine.offers(call.tag()) => {
                let submitted = &mut self.foreign.contexts.get_mut(&context)?.1;
                fall_back(engine, call, submitted)
            }
            _ => engine.execute(call, number),
        };
        self.note_foreign(call, id, reply, number)
    }

    /// Keeps track of new and deleted objects.
    fn note_foreign(
        &mut self,
        call: &Call,
        id: EngineId,
        reply: Reply,
        number: u32,
    ) -> Option<Reply> {
        if let Call::DrawContextDelete { context } = call {
            self.foreign.contexts.remove(context);
        }
        let Reply::Created(Ok(_)) = reply else { return Some(reply) };
        self.objects.numbers = number;
        if matches!(call, Call::DrawContextNew { .. }) {
            self.foreign.contexts.insert(number, (id, Submitted::default()));
        }
        Some(Reply::Created(Ok(number)))
    }
}

/// What the manager does for an engine without a method for a call.
fn fall_back(engine: &mut dyn Engine, call: &Call, submitted: &mut Submitted) -> Reply {
    match call {
        Call::SubmitVerticesGouraud { vertices, .. } => submitted.gouraud.clone_from(vertices),
        Call::SubmitVerticesTexture { vertices, .. } => submitted.texture.clone_from(vertices),
        _ => match split(call, submitted) {
            Some(calls) => calls.iter().for_each(|call| {
                engine.execute(call, 0);
            }),
            None => return Reply::Status(Err(RaveError::NotSupported)),
        },
    }
    Reply::Nothing
}

fn subject(call: &Call) -> Subject {
    match call {
        Call::EngineEnable { .. } | Call::EngineDisable { .. } => Subject::Manager,
        Call::DrawContextNew { engine, .. }
        | Call::TextureNew { engine, .. }
        | Call::TextureDetach { engine, .. }
        | Call::TextureDelete { engine, .. }
        | Call::TextureBindColorTable { engine, .. }
        | Call::TextureUpdate { engine, .. }
        | Call::AccessTexture { engine, .. }
        | Call::AccessTextureEnd { engine, .. }
        | Call::BitmapNew { engine, .. }
        | Call::BitmapDetach { engine, .. }
        | Call::BitmapDelete { engine, .. }
        | Call::BitmapBindColorTable { engine, .. }
        | Call::BitmapUpdate { engine, .. }
        | Call::AccessBitmap { engine, .. }
        | Call::AccessBitmapEnd { engine, .. }
        | Call::ColorTableNew { engine, .. }
        | Call::ColorTableDelete { engine, .. } => Subject::Engine(*engine),
        Call::DrawContextDelete { context }
        | Call::SetFloat { context, .. }
        | Call::SetInt { context, .. }
        | Call::SetTexture { context, .. }
        | Call::DrawPoint { context, .. }
        | Call::DrawLine { context, .. }
        | Call::DrawTriGouraud { context, .. }
        | Call::DrawTriTexture { context, .. }
        | Call::DrawVGouraud { context, .. }
        | Call::DrawVTexture { context, .. }
        | Call::DrawBitmap { context, .. }
        | Call::SubmitVerticesGouraud { context, .. }
        | Call::SubmitVerticesTexture { context, .. }
        | Call::DrawTriMeshGouraud { context, .. }
        | Call::DrawTriMeshTexture { context, .. }
        | Call::SubmitMultiTextureParams { context, .. }
        | Call::RenderStart { context, .. }
        | Call::RenderEnd { context, .. }
        | Call::RenderAbort { context }
        | Call::Flush { context }
        | Call::Sync { context }
        | Call::Busy { context }
        | Call::SwapBuffers { context, .. }
        | Call::SetNoticeMethod { context, .. }
        | Call::AccessDrawBuffer { context }
        | Call::AccessDrawBufferEnd { context, .. }
        | Call::AccessZBuffer { context }
        | Call::AccessZBufferEnd { context, .. }
        | Call::ClearDrawBuffer { context, .. }
        | Call::ClearZBuffer { context, .. }
        | Call::TextureFromContext { context, .. }
        | Call::BitmapFromContext { context, .. }
        | Call::WindowContents { context, .. } => Subject::Context(*context),
    }
}
