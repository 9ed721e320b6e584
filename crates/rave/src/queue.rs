//! The way to the renderer: batches in order, on this thread or another.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};
use std::thread::JoinHandle;

use fillrate_engine::{DeviceConfig, EngineError};

use crate::batch::{Batch, Command};
use crate::painter::Painter;
use crate::translate::Plane;

/// Batches that may wait for the renderer; the program waits beyond.
const MAX_WAITING: usize = 16;

type Task = Box<dyn FnOnce(&mut Painter) + Send>;

enum Message {
    Batch(Box<Batch>),
    Task(Task),
}

/// The renderer.
enum Renderer {
    /// Draws when a batch is handed over.
    Here(Box<Painter>),
    /// Draws while the program goes on.
    Thread {
        sender: Option<SyncSender<Message>>,
        used: Receiver<Box<Batch>>,
        handle: Option<JoinHandle<()>>,
    },
}

/// The batch that is being filled, and the renderer.
pub(crate) struct Queue {
    pub batch: Box<Batch>,
    renderer: Renderer,
    /// Messages handed over.
    sent: u64,
    /// Messages carried out.
    done: Arc<AtomicU64>,
    /// Counts batches, so that indices into one are not taken for another's.
    pub serial: u64,
    /// The context and plane that the batch draws into, once it says so.
    target: Option<(u32, Plane)>,
    /// The index of the state that it draws by.
    state: Option<u32>,
}

impl core::fmt::Debug for Queue {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Queue").field("sent", &self.sent).finish_non_exhaustive()
    }
}

impl Queue {
    /// A renderer; on a thread of its own where that is asked for and can be
    /// had.
    ///
    /// # Errors
    /// Those of [`Painter::new`].
    pub fn new(config: DeviceConfig, asynchronous: bool) -> Result<Queue, EngineError> {
        let painter = Painter::new(config.clone())?;
        let done = Arc::new(AtomicU64::new(0));
        let renderer = if asynchronous {
            match thread(painter, done.clone()) {
                Some(renderer) => renderer,
                None => Renderer::Here(Box::new(Painter::new(config)?)),
            }
        } else {
            Renderer::Here(Box::new(painter))
        };
        Ok(Queue {
            batch: Box::default(),
            renderer,
            sent: 0,
            done,
            serial: 0,
            target: None,
            state: None,
        })
    }

    /// Hands the batch over.
    pub fn flush(&mut self) {
        if self.batch.commands.is_empty() {
            return;
        }
        self.serial += 1;
        self.forget_target();
        match &mut self.renderer {
            Renderer::Here(painter) => {
                painter.run(&self.batch);
                self.batch.clear();
            }
            Renderer::Thread { used, .. } => {
                let next = used.try_recv().unwrap_or_default();
                let batch = std::mem::replace(&mut self.batch, next);
                self.send(Message::Batch(batch));
            }
        }
    }

    /// Says the target and the state again before the next primitive.
    fn forget_target(&mut self) {
        (self.target, self.state) = (None, None);
    }

    /// Adds a step that changes no target.
    pub fn push(&mut self, command: Command) {
        self.batch.commands.push(command);
    }

    /// Draws into a context from here on.
    pub fn target(&mut self, context: u32, plane: Plane) {
        if self.target != Some((context, plane)) {
            self.batch.commands.push(Command::Target { context, plane });
            self.target = Some((context, plane));
        }
    }

    /// Clears a context, or copies into it.
    pub fn fill(&mut self, context: u32, plane: Plane, command: Command) {
        self.target(context, plane);
        self.batch.commands.push(command);
        // Planes were changed for it.
        self.target = None;
    }

    /// Draws by a state of the batch from here on.
    #[inline]
    pub fn state(&mut self, index: u32) {
        if self.state != Some(index) {
            self.batch.commands.push(Command::State(index));
            self.state = Some(index);
        }
    }

    fn send(&mut self, message: Message) {
        if let Renderer::Thread { sender: Some(sender), .. } = &self.renderer
            && sender.send(message).is_ok()
        {
            self.sent += 1;
        }
    }

    /// Whether handed over work is not done yet.
    pub fn is_busy(&self) -> bool {
        self.done_count() < self.sent
    }

    /// How much was handed over, to be compared with [`Queue::done_count`].
    pub fn sent_count(&self) -> u64 {
        self.sent
    }

    /// How much of it is done.
    pub fn done_count(&self) -> u64 {
        self.done.load(Ordering::Acquire)
    }

    /// Hands the batch over, does something with the renderer once all is done,
    /// and waits for it. `None`: the renderer is gone.
    pub fn with<R: Send + 'static>(
        &mut self,
        task: impl FnOnce(&mut Painter) -> R + Send + 'static,
    ) -> Option<R> {
        self.flush();
        if let Renderer::Here(painter) = &mut self.renderer {
            return Some(task(painter));
        }
        let (reply, answer) = channel();
        let done = self.done.clone();
        self.send(Message::Task(Box::new(move |painter| {
            let result = task(painter);
            // Counted before anybody hears of it.
            done.fetch_add(1, Ordering::Release);
            // Where nobody waits, nobody needs it.
            let _ = reply.send(result);
        })));
        answer.recv().ok()
    }

    /// Waits until all is done.
    pub fn sync(&mut self) {
        self.flush();
        if self.is_busy() {
            self.with(|_| ());
        }
    }
}

impl Drop for Queue {
    fn drop(&mut self) {
        if let Renderer::Thread { sender, handle, .. } = &mut self.renderer {
            drop(sender.take());
            if let Some(handle) = handle.take() {
                // A renderer that panicked has nothing left to end.
                let _ = handle.join();
            }
        }
    }
}

/// Starts the renderer's thread.
fn thread(mut painter: Painter, done: Arc<AtomicU64>) -> Option<Renderer> {
    let (sender, receiver) = sync_channel::<Message>(MAX_WAITING);
    let (back, used) = sync_channel::<Box<Batch>>(MAX_WAITING);
    let work = move || {
        while let Ok(message) = receiver.recv() {
            match message {
                Message::Batch(mut batch) => {
                    painter.run(&batch);
                    batch.clear();
                    done.fetch_add(1, Ordering::Release);
                    // Where enough are waiting to be used again, it is dropped.
                    let _ = back.try_send(batch);
                }
                Message::Task(task) => task(&mut painter),
            }
        }
    };
    let handle = std::thread::Builder::new().name("rave".into()).spawn(work).ok()?;
    Some(Renderer::Thread { sender: Some(sender), used, handle: Some(handle) })
}
