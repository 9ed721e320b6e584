//! What is shown, and what the back buffer holds, after random sequences of
//! frames, against a model that copies pixels at once.

use std::collections::VecDeque;

use fillrate_engine::DeviceConfig;
use fillrate_rave::constants::context::{CACHE, DOUBLE_BUFFER, NO_Z_BUFFER, SCALE};
use fillrate_rave::constants::{compare, notice};
use fillrate_rave::tags::{float, int};
use fillrate_rave::{Call, Context, DrawContextId, PixelType, RaveConfig, RaveRect, Shown};

use crate::pixels::Dice;
use crate::scene::{Scene, area, colored, config, memory};

/// Columns and rows of the contexts. All places are even, so that pixels of a
/// picture of half the size are not mixed.
const SIZE: (i32, i32) = (96, 70);

/// A context as it should be.
struct Model {
    id: u32,
    /// Pixels of the context along one of what is shown.
    zoom: i32,
    flags: u32,
    clip: Option<Vec<RaveRect>>,
    background: u32,
    composite: u32,
    swaps: bool,
    keeps: bool,
    in_frame: bool,
    back: Vec<u32>,
    /// What was shown, one after the other.
    fronts: Vec<Vec<u32>>,
    /// The least of them that may be seen.
    seen: usize,
    /// What ended frames show that nobody told to be complete.
    ended: VecDeque<usize>,
    /// Put together from what changed.
    copy: Vec<u32>,
}

fn all() -> RaveRect {
    area(SIZE.0 as u32, SIZE.1 as u32)
}

fn rect(dice: &mut Dice) -> RaveRect {
    let mut sides = |limit: i32| {
        let [a, b] = [0; 2].map(|_: i32| 2 * dice.below(limit as u32 / 2 + 1) as i32);
        (a.min(b), a.max(b))
    };
    let ((left, right), (top, bottom)) = (sides(SIZE.0), sides(SIZE.1));
    RaveRect::new(left, top, right, bottom)
}

/// None, all, or some of it.
fn part(dice: &mut Dice) -> Option<RaveRect> {
    match dice.below(6) {
        0 => Some(rect(dice)),
        1 => Some(all()),
        _ => None,
    }
}

fn places(rect: RaveRect) -> impl Iterator<Item = (i32, i32)> {
    (rect.top..rect.bottom).flat_map(move |y| (rect.left..rect.right).map(move |x| (x, y)))
}

fn words(shown: &Shown) -> Vec<u32> {
    shown.pixels.as_chunks().0.iter().map(|&word| u32::from_le_bytes(word)).collect()
}

/// The rule of `BufferComposite`.
fn composed(mode: u32, source: u32, below: u32) -> u32 {
    let [s, d] = [source, below].map(|argb| argb.to_be_bytes().map(f64::from));
    let part = |a: f64, b: f64| (a * b / 255.0).round();
    let color = |i: usize| {
        let own = if mode == 2 { part(s[i], s[0]) } else { s[i] };
        (own + part(d[i], 255.0 - s[0])).min(255.0) as u8
    };
    let alpha = 255.0 - part(255.0 - s[0], 255.0 - d[0]);
    u32::from_be_bytes([alpha as u8, color(1), color(2), color(3)])
}

impl Model {
    fn new(scene: &mut Scene, dice: &mut Dice, zoom: i32, flags: u32) -> Model {
        let scaled = (zoom > 1).then(|| area(SIZE.0 as u32 / 2, SIZE.1 as u32 / 2));
        let clip = (dice.below(3) == 0)
            .then(|| vec![RaveRect::new(0, 0, 30, 35), RaveRect::new(24, 20, 90, 31)]);
        let device = memory(SIZE.0 as u32, SIZE.1 as u32, PixelType::Argb32);
        let (rect, clip_list) = (all(), clip.clone());
        let call = Call::DrawContextNew { engine: 1, device, rect, scaled, clip: clip_list, flags };
        let id = scene.call(call).created();
        if flags & NO_Z_BUFFER == 0 {
            let (tag, value) = (int::Z_FUNCTION, compare::TRUE);
            scene.call(Call::SetInt { context: id, tag, value });
        }
        let count = (SIZE.0 * SIZE.1) as usize;
        let front = vec![0; count / (zoom * zoom) as usize];
        Model {
            id,
            zoom,
            flags,
            clip,
            background: 0,
            composite: 0,
            swaps: true,
            keeps: false,
            in_frame: false,
            back: vec![0; count],
            fronts: vec![front.clone()],
            seen: 0,
            ended: VecDeque::new(),
            copy: front,
        }
    }

    fn fill(&mut self, rect: RaveRect, argb: u32) {
        places(rect).for_each(|(x, y)| self.back[(y * SIZE.0 + x) as usize] = argb);
    }

    fn take(&mut self, rect: RaveRect, from: &[u32]) {
        for at in places(rect).map(|(x, y)| (y * SIZE.0 + x) as usize) {
            self.back[at] = from[at];
        }
    }

    fn show(&mut self, part: RaveRect) {
        let zoom = self.zoom;
        let mut front = self.fronts[self.fronts.len() - 1].clone();
        let [left, top, right, bottom] =
            [part.left, part.top, part.right, part.bottom].map(|side| side / zoom);
        for (x, y) in places(RaveRect::new(left, top, right, bottom)) {
            if self.clip.as_ref().is_some_and(|clip| !clip.iter().any(|r| r.contains(x, y))) {
                continue;
            }
            let source = self.back[(y * zoom * SIZE.0 + x * zoom) as usize];
            let place = &mut front[(y * (SIZE.0 / zoom) + x) as usize];
            *place = match self.composite {
                0 => source,
                mode => composed(mode, source, *place),
            };
        }
        self.fronts.push(front);
    }

    fn draws_to_front(&self) -> bool {
        self.flags & (DOUBLE_BUFFER | CACHE) == 0
    }

    /// What the library tells without waiting. A frame that is complete is seen.
    fn look(&mut self, library: &mut Context) {
        let id = DrawContextId(self.id);
        let changed = library.take_changed(id);
        let shown = words(&library.shown_so_far(id).expect("the context is there"));
        let found = self.fronts[self.seen..].iter().position(|front| *front == shown);
        self.seen += found.expect("a frame that was shown, and none before the last one seen");
        self.copy_changed(changed, &shown);
    }

    fn copy_changed(&mut self, changed: Option<RaveRect>, shown: &[u32]) {
        for at in changed.into_iter().flat_map(places).map(|(x, y)| y * (SIZE.0 / self.zoom) + x) {
            self.copy[at as usize] = shown[at as usize];
        }
    }

    /// What it tells once all is drawn.
    fn look_at_last(&mut self, library: &mut Context) {
        let id = DrawContextId(self.id);
        let shown = words(&library.shown_by(id).expect("the context is there"));
        self.seen = self.fronts.len() - 1;
        assert!(shown == self.fronts[self.seen], "the last frame");
        let changed = library.take_changed(id);
        self.copy_changed(changed, &shown);
        assert!(self.copy == shown, "what changed is told of");
    }
}

/// A library, and its contexts as they should be: two to show, and a cache.
struct Story {
    scene: Scene,
    dice: Dice,
    models: Vec<Model>,
}

impl Story {
    fn new(config: RaveConfig, seed: u64) -> Story {
        let mut scene = Scene::with(config, 8, 8, PixelType::Argb32, DOUBLE_BUFFER);
        let mut dice = Dice(seed);
        let zoom = 1 + dice.below(4) as i32 / 3;
        let flags = [DOUBLE_BUFFER, DOUBLE_BUFFER, NO_Z_BUFFER][dice.below(3) as usize]
            | if zoom > 1 { SCALE } else { 0 };
        let flags = [flags, flags ^ DOUBLE_BUFFER, flags | CACHE];
        let models = flags.map(|flags| Model::new(&mut scene, &mut dice, zoom, flags)).into();
        Story { scene, dice, models }
    }

    fn step(&mut self) {
        let which = [0, 0, 0, 0, 1, 2][self.dice.below(6) as usize];
        if self.models[which].in_frame {
            self.step_in_frame(which);
        } else {
            self.step_between_frames(which);
        }
        let library = &mut self.scene.library;
        for id in library.take_completed() {
            let mut models = self.models.iter_mut();
            let model = models.find(|model| model.id == id.0).expect("a context");
            let shown = model.ended.pop_front().expect("a frame that ended");
            model.seen = model.seen.max(shown);
        }
    }

    fn step_between_frames(&mut self, which: usize) {
        let context = self.models[which].id;
        match self.dice.below(12) {
            0 => {
                let value = self.dice.below(3);
                self.scene.call(Call::SetInt { context, tag: int::BUFFER_COMPOSITE, value });
                self.models[which].composite = value;
            }
            1 => {
                let value = self.dice.below(2);
                self.scene.call(Call::SetInt { context, tag: int::DONT_SWAP, value });
                self.models[which].swaps = value == 0;
            }
            2 => {
                let value = self.dice.below(4);
                self.scene.call(Call::SetInt { context, tag: int::ANTIALIAS, value });
            }
            3 => {
                let (selector, installed) =
                    (notice::IMAGE_BUFFER_INITIALIZE, self.dice.below(3) == 0);
                self.scene.call(Call::SetNoticeMethod { context, selector, installed });
                self.models[which].keeps = installed;
            }
            4 => self.swap(which),
            5 => self.window(which),
            6 => self.look(which),
            _ => self.start(which),
        }
    }

    fn step_in_frame(&mut self, which: usize) {
        match self.dice.below(14) {
            0 => self.clear(which),
            1 => self.flush(which),
            2 => self.look(which),
            3 => self.access(which),
            4 => self.swap(which),
            5 => self.abort(which),
            6..=9 => self.draw(which),
            _ => self.end(which),
        }
    }

    /// A colour of full or empty channels, which nothing rounds.
    fn argb(&mut self) -> u32 {
        u32::from_be_bytes([0; 4].map(|_: u8| self.dice.below(2) as u8 * 255))
    }

    /// The cache, unless it is being drawn or this is it.
    fn cache(&mut self, which: usize) -> Option<usize> {
        (which == 0 && !self.models[2].in_frame && self.dice.below(3) == 0).then_some(2)
    }

    fn start(&mut self, which: usize) {
        let (context, argb) = (self.models[which].id, self.argb());
        for (tag, channel) in (float::COLOR_BG_A..).zip(argb.to_be_bytes()) {
            let value = f32::from(channel) / 255.0;
            self.scene.call(Call::SetFloat { context, tag, value });
        }
        let (dirty, cache) = (part(&mut self.dice), self.cache(which));
        let initial = cache.map_or(0, |cache| self.models[cache].id);
        self.scene.call(Call::RenderStart { context, dirty, initial });
        let source = cache.map(|cache| self.models[cache].back.clone());
        let model = &mut self.models[which];
        (model.in_frame, model.background) = (true, argb);
        let dirty = dirty.unwrap_or(all());
        match source {
            Some(source) => model.take(dirty, &source),
            None if model.keeps => {}
            None => model.fill(dirty, argb),
        }
    }

    fn draw(&mut self, which: usize) {
        let (place, argb) = (rect(&mut self.dice), self.argb() | 0xff00_0000);
        let color = [16, 8, 0].map(|shift| (argb >> shift & 255) as f32 / 255.0);
        let sides = [place.left, place.top, place.right, place.bottom].map(|side| side as f32);
        self.scene.context = self.models[which].id;
        // Often enough that drawing takes its time.
        let times = [1, 1, 60, 500][self.dice.below(4) as usize];
        if times > 100 {
            let all = [0.0, 0.0, SIZE.0 as f32, SIZE.1 as f32];
            (0..times).for_each(|_| self.scene.rect(all, colored(color, 0.5)));
            self.models[which].fill(self::all(), argb);
        }
        (0..times).for_each(|_| self.scene.rect(sides, colored(color, 0.5)));
        self.models[which].fill(place, argb);
    }

    fn clear(&mut self, which: usize) {
        let context = self.models[which].id;
        let (place, cache) = (part(&mut self.dice), self.cache(which));
        let initial = cache.map_or(0, |cache| self.models[cache].id);
        if self.dice.below(3) == 0 {
            self.scene.call(Call::ClearZBuffer { context, rect: place, initial });
            return;
        }
        self.scene.call(Call::ClearDrawBuffer { context, rect: place, initial });
        let source = cache.map(|cache| self.models[cache].back.clone());
        let model = &mut self.models[which];
        let (place, argb) = (place.unwrap_or(all()), model.background);
        match source {
            Some(source) => model.take(place, &source),
            None => model.fill(place, argb),
        }
    }

    fn flush(&mut self, which: usize) {
        let context = self.models[which].id;
        self.scene.call(Call::Flush { context });
        if self.models[which].draws_to_front() {
            self.models[which].show(all());
        }
    }

    fn swap(&mut self, which: usize) {
        let (context, dirty) = (self.models[which].id, part(&mut self.dice));
        self.scene.call(Call::SwapBuffers { context, dirty });
        let model = &mut self.models[which];
        if model.flags & CACHE == 0 {
            model.show(dirty.unwrap_or(all()));
            model.ended.push_back(model.fronts.len() - 1);
        }
    }

    fn end(&mut self, which: usize) {
        let (context, modified) = (self.models[which].id, part(&mut self.dice));
        self.scene.call(Call::RenderEnd { context, modified });
        let model = &mut self.models[which];
        model.in_frame = false;
        if model.flags & CACHE == 0 && (model.swaps || model.draws_to_front()) {
            model.show(modified.unwrap_or(all()));
        }
        model.ended.push_back(model.fronts.len() - 1);
    }

    fn abort(&mut self, which: usize) {
        let context = self.models[which].id;
        self.scene.call(Call::RenderAbort { context });
        self.models[which].in_frame = false;
    }

    fn access(&mut self, which: usize) {
        let context = self.models[which].id;
        self.scene.call(Call::AccessDrawBuffer { context });
        let buffer = self.scene.library.draw_buffer(DrawContextId(context)).expect("a buffer");
        assert!(words(&buffer) == self.models[which].back, "the back buffer");
        let (place, argb) = (rect(&mut self.dice), self.dice.below(u32::MAX));
        let count = (place.width() * place.height()) as usize;
        let pixels: Vec<u8> = std::iter::repeat_n(argb.to_le_bytes(), count).flatten().collect();
        let writes = self.dice.below(2) == 0;
        let pixels = if writes { pixels } else { Vec::new() };
        self.scene.call(Call::AccessDrawBufferEnd { context, rect: place, pixels: pixels.into() });
        if writes {
            self.models[which].fill(place, argb);
        }
    }

    fn window(&mut self, which: usize) {
        let (context, argb) = (self.models[which].id, self.dice.below(u32::MAX));
        let model = &mut self.models[which];
        let front = vec![argb; model.copy.len()];
        let pixels: Vec<u8> = front.iter().flat_map(|word| word.to_le_bytes()).collect();
        self.scene.call(Call::WindowContents { context, pixels: pixels.into() });
        // The program knows of what it wrote.
        model.copy.clone_from(&front);
        model.fronts.push(front);
        model.seen = model.fronts.len() - 1;
    }

    fn look(&mut self, which: usize) {
        let (model, library) = (&mut self.models[which], &mut self.scene.library);
        match self.dice.below(4) {
            0 => model.look_at_last(library),
            1 => {
                let buffer = library.draw_buffer(DrawContextId(model.id)).expect("a buffer");
                assert!(words(&buffer) == model.back, "the back buffer");
            }
            _ => model.look(library),
        }
    }

    fn finish(&mut self) {
        self.scene.library.finish();
        self.models.iter_mut().for_each(|model| model.look_at_last(&mut self.scene.library));
        let completed = self.scene.library.take_completed().len();
        let ended: usize = self.models.iter().map(|model| model.ended.len()).sum();
        assert_eq!(completed, ended, "every frame is told of once");
    }
}

#[test]
fn random_frames_are_shown_as_if_they_were_copied() {
    let cases = std::env::var("FILLRATE_CASES").ok().and_then(|cases| cases.parse().ok());
    for seed in 0..cases.unwrap_or(60u64) {
        let (threads, asynchronous) =
            [(1, false), (1, true), (2, true), (3, true), (2, false)][seed as usize % 5];
        let device = DeviceConfig { threads, ..config().device };
        let mut story = Story::new(RaveConfig { device, asynchronous, ..config() }, seed);
        (0..80).for_each(|_| story.step());
        story.finish();
    }
}

/// While a frame is drawn and the next one is collected, the frame before is seen,
/// and then the one that was drawn.
#[test]
fn a_frame_is_seen_until_the_next_is_drawn() {
    let device = DeviceConfig { threads: 2, ..config().device };
    let config = RaveConfig { device, asynchronous: true, ..config() };
    let mut scene = Scene::with(config, 512, 512, PixelType::Argb32, DOUBLE_BUFFER | NO_Z_BUFFER);
    let (red, green) = (0xffff_0000, 0xff00_ff00);
    for _ in 0..5 {
        scene.start();
        scene.rect([0.0, 0.0, 512.0, 512.0], colored([1.0, 0.0, 0.0], 0.5));
        scene.end().expect("a frame");
        scene.library.finish();
        scene.start();
        (0..400).for_each(|_| {
            scene.rect([0.0, 0.0, 512.0, 512.0], colored([0.0, 1.0, 0.0], 0.5));
        });
        scene.end().expect("a frame");
        scene.start();
        let shown = scene.library.shown_so_far(scene.id()).expect("the context is there");
        let seen = shown.argb(100, 100);
        assert!(words(&shown).iter().all(|&pixel| pixel == seen), "one frame");
        assert!([red, green].contains(&seen), "{seen:08x}");
        assert_eq!(scene.pixel(100, 100), green);
        scene.end().expect("a frame");
    }
}
