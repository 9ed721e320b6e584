//! `fillrate model`: how long a recorded RRedline program would have taken on
//! the real chip, and whether the chip or the processor would have been the
//! limit.

use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io::BufReader;
use std::path::PathBuf;

use anyhow::{Context as _, Result, bail};
use clap::Args;
use fillrate_call::{BlobId, Data, Decoder};
use fillrate_redline::cost::{Estimate, Estimator, Rates, Work, host_seconds};
use fillrate_redline::{Call, Chip, Commands, RedlineConfig, command::stream_words};
use fillrate_trace::meta::CONFIG_PREFIX;
use fillrate_trace::{CallBatch, Event, Meta, TraceReader};
use serde::Serialize;

use crate::Outcome;

/// Options of `fillrate model`.
#[derive(Args, Debug)]
pub struct ModelArgs {
    /// The chip: v1000 or v2000; the recording's own unless said
    #[arg(long, value_name = "CHIP", value_parser = chip)]
    chip: Option<Chip>,
    /// The chip's clock in MHz; 50 for a V1000, 60 for a V2000
    #[arg(long, value_name = "MHZ", value_parser = positive)]
    clock: Option<f64>,
    /// Milliseconds that the program itself needs for a frame, as `fillrate run --speed-of-light`
    /// measures them; unless said, what recording took a 200 MHz Pentium
    #[arg(long, value_name = "MS", value_parser = positive)]
    cpu_ms: Option<f64>,
    /// Print every primitive
    #[arg(long)]
    primitives: bool,
    /// Print one JSON object a frame
    #[arg(long)]
    json: bool,
    /// The recording
    file: PathBuf,
}

fn chip(text: &str) -> Result<Chip, String> {
    Chip::by_name(text).ok_or_else(|| "it is v1000 or v2000".to_string())
}

fn positive(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "it is not a number".to_string())?;
    if number.is_finite() && number > 0.0 { Ok(number) } else { Err("it is above 0".to_string()) }
}

/// Work of one kind of command.
#[derive(Clone, Debug, Serialize)]
struct Kind {
    command: &'static str,
    vertex: Option<&'static str>,
    primitives: u64,
    lines: u64,
    pixels: u64,
    setup_cycles: u64,
    line_cycles: u64,
    pixel_cycles: u64,
    bytes: u64,
}

impl Kind {
    fn new(command: &'static str, vertex: Option<&'static str>, work: &Work) -> Kind {
        Kind {
            command,
            vertex,
            primitives: work.primitives,
            lines: work.lines,
            pixels: work.pixels,
            setup_cycles: work.setup_cycles,
            line_cycles: work.line_cycles,
            pixel_cycles: work.pixel_cycles,
            bytes: work.bytes,
        }
    }
}

/// One frame's estimate.
#[derive(Clone, Debug, Serialize)]
struct FrameModel {
    frame: u64,
    chip: &'static str,
    /// What the recorded words hold.
    commands: u64,
    words: u64,
    kinds: Vec<Kind>,
    /// Cycles by the guide's rates.
    cycles: u64,
    /// Cycles that video memory needs at least.
    memory_cycles: u64,
    chip_ms: f64,
    cpu_ms: f64,
    /// `chip` or `cpu`.
    limit: &'static str,
    frames_per_second: f64,
}

/// Follows a recording.
struct Model {
    args: Options,
    chip: Chip,
    estimator: Estimator,
    blobs: HashMap<BlobId, Data>,
    by_kind: BTreeMap<(&'static str, Option<&'static str>), Work>,
    primitives: Vec<Estimate>,
    commands: u64,
    words: u64,
    frame: u64,
    started: bool,
}

/// What the options say.
struct Options {
    chip: Option<Chip>,
    clock: Option<f64>,
    cpu_ms: Option<f64>,
    keep_primitives: bool,
}

/// The command.
pub fn model(args: &ModelArgs) -> Result<Outcome> {
    let name = args.file.display();
    let file = File::open(&args.file).with_context(|| format!("cannot open {name}"))?;
    let events = TraceReader::new(BufReader::new(file))
        .with_context(|| format!("{name} is no recording"))?;
    let mut model = Model::new(args);
    for event in events {
        match event.with_context(|| format!("{name} is damaged"))? {
            Event::Meta(meta) => model.start(&meta)?,
            Event::Blob { id, data } => drop(model.blobs.insert(id, data)),
            Event::Calls(batch) => model.calls(&batch)?,
            Event::FrameEnd(_) => report(args, &model.end_frame())?,
            _ => {}
        }
    }
    if model.frame == 0 {
        bail!("{name} holds no frame");
    }
    Ok(Outcome::Same)
}

impl Model {
    fn new(args: &ModelArgs) -> Model {
        let options = Options {
            chip: args.chip,
            clock: args.clock,
            cpu_ms: args.cpu_ms,
            keep_primitives: args.primitives,
        };
        let chip = Chip::default();
        Model {
            args: options,
            chip,
            estimator: Estimator::new(chip, Rates::of(chip)),
            blobs: HashMap::new(),
            by_kind: BTreeMap::new(),
            primitives: Vec::new(),
            commands: 0,
            words: 0,
            frame: 0,
            started: false,
        }
    }

    fn start(&mut self, meta: &Meta) -> Result<()> {
        if self.started {
            return Ok(());
        }
        match meta.get("api") {
            Some("redline") => {}
            other => bail!("the recording is of {}, not of RRedline", other.unwrap_or("glide2x")),
        }
        self.started = true;
        let pairs = meta.iter().filter_map(|(key, value)| {
            Some((key.strip_prefix(CONFIG_PREFIX)?.to_string(), value.to_string()))
        });
        let recorded = RedlineConfig::from_description(pairs).chip;
        // Words are understood as the chip did that they were made for.
        self.chip = self.args.chip.unwrap_or(recorded);
        let mut rates = Rates::of(self.chip);
        rates.clock = self.args.clock.unwrap_or(rates.clock);
        self.estimator = Estimator::new(recorded, rates);
        Ok(())
    }

    fn calls(&mut self, batch: &CallBatch) -> Result<()> {
        for call in batch.iter() {
            let mut decoder = Decoder::with_blobs(call, &self.blobs);
            let call: Call = decoder.value()?;
            if let Call::IssueCmdBuffer { segments, .. } = call {
                self.stream(&stream_words(&segments));
            }
        }
        Ok(())
    }

    fn stream(&mut self, words: &[u32]) {
        self.words += words.len() as u64;
        // Specular types are in the words of a V2000 only.
        self.commands += Commands::new(words, Chip::V2000).filter(Result::is_ok).count() as u64;
        let Model { estimator, by_kind, primitives, args, .. } = self;
        estimator.stream(words, |estimate| {
            *by_kind.entry((estimate.command, estimate.vertex)).or_default() += estimate.work;
            if args.keep_primitives {
                primitives.push(estimate);
            }
        });
    }

    /// The frame's figures; counts anew.
    fn end_frame(&mut self) -> (FrameModel, Vec<Estimate>) {
        let mut all = Work::default();
        self.by_kind.values().for_each(|work| all += *work);
        let clock = self.estimator.rates().clock * 1e3;
        let (cycles, memory_cycles) = (all.cycles(), all.memory_cycles());
        let chip_ms = cycles.max(memory_cycles) as f64 / clock;
        let recorded_ms = host_seconds(self.commands, self.words) * 1e3;
        let cpu_ms = self.args.cpu_ms.unwrap_or(recorded_ms);
        let by_kind = std::mem::take(&mut self.by_kind);
        let kinds =
            by_kind.iter().map(|((command, vertex), work)| Kind::new(command, *vertex, work));
        let model = FrameModel {
            frame: self.frame,
            chip: self.chip.name(),
            commands: std::mem::take(&mut self.commands),
            words: std::mem::take(&mut self.words),
            kinds: kinds.collect(),
            cycles,
            memory_cycles,
            chip_ms,
            cpu_ms,
            limit: if chip_ms >= cpu_ms { "chip" } else { "cpu" },
            frames_per_second: 1e3 / chip_ms.max(cpu_ms).max(1e-6),
        };
        self.frame += 1;
        (model, std::mem::take(&mut self.primitives))
    }
}

#[derive(Serialize)]
struct WithPrimitives<'a> {
    #[serde(flatten)]
    frame: &'a FrameModel,
    primitives: Vec<Kind>,
}

fn report(args: &ModelArgs, (frame, primitives): &(FrameModel, Vec<Estimate>)) -> Result<()> {
    let kind = |e: &Estimate| Kind::new(e.command, e.vertex, &e.work);
    let listed: Vec<Kind> = primitives.iter().map(kind).collect();
    if args.json {
        if args.primitives {
            let whole = WithPrimitives { frame, primitives: listed };
            println!("{}", serde_json::to_string(&whole)?);
        } else {
            println!("{}", serde_json::to_string(frame)?);
        }
        return Ok(());
    }
    println!("frame {} on a {}", frame.frame, frame.chip);
    let header = ["setup", "lines", "pixels", "bytes"];
    println!(
        "  {:28} {:20} {:>9} {:>9} {:>10} {:>10} {:>10} {:>11} {:>11}",
        "command", "vertex", "count", "lines", "pixels", header[0], header[1], header[2], header[3]
    );
    for kind in frame.kinds.iter().chain(&listed) {
        println!(
            "  {:28} {:20} {:>9} {:>9} {:>10} {:>10} {:>10} {:>11} {:>11}",
            kind.command,
            kind.vertex.unwrap_or("-"),
            kind.primitives,
            kind.lines,
            kind.pixels,
            kind.setup_cycles,
            kind.line_cycles,
            kind.pixel_cycles,
            kind.bytes
        );
    }
    println!(
        "  {} cycles, at least {} for memory: {:.3} ms; processor {:.3} ms for {} commands, {} \
         words; limit: the {}, {:.1} frames a second",
        frame.cycles,
        frame.memory_cycles,
        frame.chip_ms,
        frame.cpu_ms,
        frame.commands,
        frame.words,
        frame.limit,
        frame.frames_per_second
    );
    Ok(())
}
