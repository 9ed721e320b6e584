//! The fast path: the same fragments from the same formulas, row by row on several threads.
//!
//! It is exact: every value is made by the additions of the reference, in its order, so pictures are
//! equal bit for bit. What makes it fast: primitives of a scene are collected and set up once; each
//! thread then draws all of them, in order, on rows of its own, so nothing is locked and order is
//! kept; fragments that fail the depth test are dropped before they are coloured.
//!
//! The engine's pipelines cannot stand in for it: their vertices snap to sixteenths of a pixel,
//! their depths have sixteen bits and their colours are linear on the screen.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::color::low;
use crate::device::{Config, Core};
use crate::errata::Errata;
use crate::framebuffer::Pages;
use crate::stage::composite::{self, Canvas};
use crate::stage::raster::{Rasterizer, Screen, Setup};
use crate::stage::{Shape, TransPrim, UntexFragment, combine};
use crate::state::PrimInfo;
use crate::texture::TextureManager;

/// Primitives collected before they are drawn, at most.
pub const MAX_QUEUED: usize = 4096;
/// Neighbouring rows that belong to one thread.
const STRIP: usize = 8;

/// A primitive ready to be drawn.
enum Prepared {
    Triangle(Box<Setup>, PrimInfo),
    Thin(TransPrim),
}

/// What all threads read.
struct Scene<'a> {
    config: Config,
    textures: &'a TextureManager,
    pages: Pages,
    prims: Vec<Prepared>,
    fragments: AtomicU64,
}

/// One row of the buffers; an address is a column.
struct Row<'a> {
    pages: Pages,
    back: &'a mut [u32],
    front: &'a mut [u32],
    depth: &'a mut [i32],
}

impl Canvas for Row<'_> {
    fn pages(&self) -> Pages {
        self.pages
    }

    #[inline(always)]
    fn depth(&self, address: u64) -> i32 {
        self.depth[address as usize]
    }

    #[inline(always)]
    fn set_depth(&mut self, address: u64, z: i32) {
        self.depth[address as usize] = z;
    }

    #[inline(always)]
    fn read(&self, address: u64, front: bool) -> u32 {
        let page = if front { &self.front } else { &self.back };
        page[address as usize]
    }

    #[inline(always)]
    fn write(&mut self, address: u64, pages: Pages, word: u32) {
        if pages.back() {
            self.back[address as usize] = word;
        }
        if pages.front() {
            self.front[address as usize] = word;
        }
    }
}

/// Draws primitives in order on `threads` threads, the caller's included. Returns how many
/// fragments were made.
pub fn draw(core: &mut Core, prims: &[TransPrim], threads: usize) -> u64 {
    let Config { width, height, errata, .. } = core.config;
    let screen = Screen { width, height };
    let prepare = |prim: &TransPrim| match prim.shape {
        Shape::Triangle => {
            Prepared::Triangle(Box::new(Setup::new(prim, screen, &errata)), prim.info)
        }
        Shape::Line | Shape::Point => Prepared::Thin(*prim),
    };
    let target = &mut core.target;
    let scene = Scene {
        config: core.config,
        textures: &core.textures,
        pages: target.pages,
        prims: prims.iter().map(prepare).collect(),
        fragments: AtomicU64::new(0),
    };
    let threads = threads.clamp(1, height as usize);
    let columns = width as usize;
    let (back, front) = target.frame.both_pages();
    let rows = back.chunks_mut(columns).zip(front.chunks_mut(columns));
    let rows = rows.zip(target.depth.depths_mut().chunks_mut(columns));
    let mut shares: Vec<Vec<Option<Row>>> =
        (0..threads).map(|_| (0..height).map(|_| None).collect()).collect();
    for (y, ((back, front), depth)) in rows.enumerate() {
        let row = Row { pages: scene.pages, back, front, depth };
        shares[y / STRIP % threads][y] = Some(row);
    }
    let mut shares = shares.into_iter();
    let own = shares.next();
    std::thread::scope(|scope| {
        let scene = &scene;
        for mut rows in shares {
            scope.spawn(move || scene.draw(&mut rows));
        }
        own.into_iter().for_each(|mut rows| scene.draw(&mut rows));
    });
    scene.fragments.into_inner()
}

impl Scene<'_> {
    /// Draws everything on the rows of one thread.
    fn draw(&self, rows: &mut [Option<Row<'_>>]) {
        let mut fragments = 0;
        for prim in &self.prims {
            fragments += match (prim, self.config.errata == Errata::CORRECT) {
                // With the errata known, the compiler leaves out what is never taken.
                (Prepared::Triangle(setup, info), true) => self.triangle::<true>(setup, info, rows),
                (Prepared::Triangle(setup, info), false) => {
                    self.triangle::<false>(setup, info, rows)
                }
                (Prepared::Thin(prim), _) => self.thin(prim, rows),
            };
        }
        self.fragments.fetch_add(fragments, Ordering::Relaxed);
    }

    #[inline(always)]
    fn errata<const CORRECT: bool>(&self) -> &Errata {
        if CORRECT { &Errata::CORRECT } else { &self.config.errata }
    }

    /// Walks a triangle as the reference does; rows of other threads are only stepped over.
    fn triangle<const CORRECT: bool>(
        &self,
        setup: &Setup,
        info: &PrimInfo,
        rows: &mut [Option<Row<'_>>],
    ) -> u64 {
        let bounds = setup.bounds;
        if bounds.is_empty() {
            return 0;
        }
        let (mut edges, mut lanes) = (setup.edges, setup.lanes);
        let mut fragments = 0;
        for y in bounds.top..=bounds.bottom {
            if let Some(row) = &mut rows[y as usize] {
                fragments += self.row::<CORRECT>(setup, info, (edges.row, lanes.row), y, row);
            }
            edges.step_down();
            lanes.step_down();
        }
        fragments
    }

    fn row<const CORRECT: bool>(
        &self,
        setup: &Setup,
        info: &PrimInfo,
        (mut edges, mut lanes): ([f32; 3], [f32; crate::stage::emit::LANES]),
        y: i32,
        row: &mut Row<'_>,
    ) -> u64 {
        let tests = info.mode.no_use_z() == 0;
        let mut fragments = 0;
        for x in setup.bounds.left..=setup.bounds.right {
            if setup.covers(&edges) {
                fragments += 1;
                // What would fail the depth test leaves no trace whatever its colour.
                let z = setup.depth_word(x, y);
                let errata = self.errata::<CORRECT>();
                if !tests || composite::passes(row.depth[x as usize], z, errata) {
                    self.fragment::<CORRECT>(info, &setup.fragment(x, y, &lanes), row);
                }
            } else if fragments > 0 {
                break;
            }
            setup.step_right(&mut edges, &mut lanes);
        }
        fragments
    }

    fn thin(&self, prim: &TransPrim, rows: &mut [Option<Row<'_>>]) -> u64 {
        let Config { width, height, errata, .. } = self.config;
        let mut fragments = 0;
        for fragment in Rasterizer::new(prim, width, height, &errata) {
            if let Some(row) = &mut rows[fragment.y as usize] {
                fragments += 1;
                self.fragment::<false>(&prim.info, &fragment, row);
            }
        }
        fragments
    }

    #[inline(always)]
    fn fragment<const CORRECT: bool>(
        &self,
        info: &PrimInfo,
        fragment: &UntexFragment,
        row: &mut Row<'_>,
    ) {
        let errata = self.errata::<CORRECT>();
        let done = combine::process(self.textures, info, fragment, errata).fragment;
        if low(done.rgba) != 0 {
            composite::process(row, info.mode, &done, u64::from(done.x), errata);
        }
    }
}
