//! The order of notices around the calls that cause them.
//!
//! A notice is a function of the program. It cannot cross the border as a
//! value; what it wrote into a buffer can. The functions here are the order in
//! which calls and notices follow one another, for whoever holds the functions.
//!
//! Source: RAVE, rendering control and notice methods.

use crate::call::{Call, Reply};
use crate::constants::notice;
use crate::context::Context;
use crate::front::Shown;
use crate::handle::DrawContextId;
use crate::vertex::RaveRect;

/// Who holds the program's notice functions.
pub trait Host {
    /// The library.
    fn library(&mut self) -> &mut Context;

    /// Records a call where that is asked for, and carries it out.
    fn call(&mut self, call: &Call) -> Reply;

    /// Calls a notice without a buffer.
    fn standard(&mut self, context: DrawContextId, selector: u32);

    /// Calls a notice with the back buffer of a context. The program may write
    /// into it, inside `dirty` and elsewhere.
    fn buffer(
        &mut self,
        context: DrawContextId,
        selector: u32,
        buffer: &mut Shown,
        dirty: RaveRect,
    );
}

/// `QARenderStart`, with the notice in place of the clear.
pub fn render_start(
    host: &mut dyn Host,
    context: DrawContextId,
    dirty: Option<RaveRect>,
    initial: u32,
) {
    deliver(host);
    host.call(&Call::RenderStart { context: context.0, dirty, initial });
    let selector = notice::IMAGE_BUFFER_INITIALIZE;
    if initial == 0 && host.library().has_notice(context, selector) {
        offer_buffer(host, context, selector, dirty);
    }
}

/// `QARenderEnd`: the composite notice, the swap, and the completion notice of
/// whatever is complete.
pub fn render_end(
    host: &mut dyn Host,
    context: DrawContextId,
    modified: Option<RaveRect>,
) -> Reply {
    let selector = notice::IMAGE_BUFFER_2D_COMPOSITE;
    if host.library().has_notice(context, selector) {
        offer_buffer(host, context, selector, modified);
    }
    let reply = host.call(&Call::RenderEnd { context: context.0, modified });
    deliver(host);
    reply
}

/// Calls the completion notices of frames that are complete by now. It does not
/// wait; the pixels of these frames are shown already.
pub fn deliver(host: &mut dyn Host) {
    for context in host.library().take_completed() {
        if host.library().has_notice(context, notice::RENDER_COMPLETION) {
            host.standard(context, notice::RENDER_COMPLETION);
        }
    }
}

/// Hands the back buffer to the program and takes back what it wrote.
fn offer_buffer(
    host: &mut dyn Host,
    context: DrawContextId,
    selector: u32,
    dirty: Option<RaveRect>,
) {
    host.call(&Call::AccessDrawBuffer { context: context.0 });
    let Some(mut buffer) = host.library().draw_buffer(context) else { return };
    let all = RaveRect::new(0, 0, buffer.width as i32, buffer.height as i32);
    let before = buffer.pixels.clone();
    host.buffer(context, selector, &mut buffer, dirty.unwrap_or(all));
    let changed = buffer.pixels.len() == before.len() && buffer.pixels != before;
    let pixels = if changed { buffer.pixels } else { Vec::new() };
    host.call(&Call::AccessDrawBufferEnd { context: context.0, rect: all, pixels: pixels.into() });
}
