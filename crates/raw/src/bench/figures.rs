//! Tables as text, and the four figures as SVG on one HTML page.

use std::fmt::Write;

use super::HERTZ;
use super::bands::{bands, shapes};
use super::run::Outcome;
use super::vectors::{CHARTED, SCALES};

/// A panel of a figure: its title and the value it shows.
type Panel = (&'static str, fn(&Outcome) -> f64);

/// The four figures: title and panels.
const FIGURES: [(&str, &[Panel]); 4] = [
    (
        "Speed-up, utilisation and overhead",
        &[
            ("speed-up", Outcome::speed_up),
            ("expected speed-up", Outcome::expected_speed_up),
            ("overhead, %", |o| 100.0 * o.overhead()),
            ("chip utilisation, %", |o| 100.0 * o.grid.chip_utilisation(o.columns)),
        ],
    ),
    (
        "Utilisation per stage, %",
        &[
            ("stage 1", |o| stage(o, 0)),
            ("stage 2", |o| stage(o, 1)),
            ("stage 3", |o| stage(o, 2)),
            ("stage 4", |o| stage(o, 3)),
        ],
    ),
    (
        "Active cycles per stage, log10",
        &[
            ("stage 1", |o| active(o, 0)),
            ("stage 2", |o| active(o, 1)),
            ("stage 3", |o| active(o, 2)),
            ("stage 4", |o| active(o, 3)),
        ],
    ),
    (
        "Rates at 300 MHz",
        &[
            ("million pixels/s, grid", |o| o.grid.pixel_rate(HERTZ) / 1e6),
            ("million pixels/s, single tile", |o| o.single.pixel_rate(HERTZ) / 1e6),
            ("thousand triangles/s, grid", |o| o.grid.triangle_rate(HERTZ) / 1e3),
            ("thousand triangles/s, single tile", |o| o.single.triangle_rate(HERTZ) / 1e3),
        ],
    ),
];

const COLORS: [&str; 12] = [
    "#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd", "#8c564b", "#e377c2", "#7f7f7f",
    "#bcbd22", "#17becf", "#000000", "#e60049",
];

const PANEL_WIDTH: f64 = 300.0;
/// Where the plots begin and end, from the top of a figure.
const TOP: f64 = 50.0;
const BOTTOM: f64 = 200.0;
const LEGEND: f64 = BOTTOM + 52.0;
const MARGIN: f64 = 40.0;

fn stage(o: &Outcome, stage: usize) -> f64 {
    100.0 * o.grid.utilisation(o.columns)[stage]
}

fn active(o: &Outcome, stage: usize) -> f64 {
    (o.grid.active[stage] as f64 / 100.0).max(1.0).log10()
}

/// The outcomes of a charted line in the order of the sizes.
fn line(outcomes: &[Outcome], index: usize) -> Vec<&Outcome> {
    let mode = CHARTED[index];
    let belongs = |o: &&Outcome| o.test.outer.name == mode.outer && o.test.inner.name == mode.inner;
    outcomes.iter().filter(belongs).collect()
}

/// A table of speed-ups: a row per charted mode, a column per size.
pub fn table(outcomes: &[Outcome]) -> String {
    let mut out = format!("{:<36}", "speed-up at scale");
    SCALES.iter().for_each(|s| out += &format!("{s:>7}"));
    out.push('\n');
    for (index, mode) in CHARTED.iter().enumerate() {
        out += &format!("{:<36}", mode.title);
        line(outcomes, index).iter().for_each(|o| out += &format!("{:>7.2}", o.speed_up()));
        out.push('\n');
    }
    out
}

/// One test as a JSON object on one line.
pub fn json(o: &Outcome) -> String {
    let stages = o.grid.utilisation(o.columns).map(|u| format!("{u:.6}")).join(",");
    format!(
        "{{\"outer\":\"{}\",\"inner\":\"{}\",\"scale\":{},\"columns\":{},\"single_cycles\":{},\
         \"grid_cycles\":{},\"speed_up\":{:.6},\"overhead\":{:.6},\"stages\":[{stages}],\"fragments\":{},\
         \"pixels\":{},\"same_picture\":{}}}",
        o.test.outer.name,
        o.test.inner.name,
        o.test.scale,
        o.columns,
        o.single.stream_cycles,
        o.grid.stream_cycles,
        o.speed_up(),
        o.overhead(),
        o.grid.frags,
        o.grid.pixels,
        o.same_picture
    )
}

/// The verdicts on the published numbers and shapes, a line each.
pub fn verdicts(outcomes: &[Outcome]) -> String {
    let mut out = String::new();
    bands(outcomes).iter().for_each(|b| out += &format!("{b}\n"));
    for (name, shows) in shapes(outcomes) {
        out += &format!("{}  {name}\n", if shows { "holds" } else { "FAILS" });
    }
    let differ = outcomes.iter().filter(|o| !o.same_picture).count();
    out += &format!("{differ} of {} pictures differ between the builds\n", outcomes.len());
    out
}

/// The four figures as SVG documents, with their titles.
pub fn figures(outcomes: &[Outcome]) -> Vec<(&'static str, String)> {
    FIGURES.iter().map(|(title, panels)| (*title, figure(outcomes, title, panels))).collect()
}

/// One HTML page with the table, the verdicts and the figures.
pub fn page(outcomes: &[Outcome]) -> String {
    let mut out = String::from(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Raw: the experiment\
         </title><style>body{font:15px sans-serif;max-width:1300px;margin:auto}</style>\
         <h1>The Raw pipeline: sixteen tiles against one</h1>",
    );
    for text in [table(outcomes), verdicts(outcomes)] {
        out += &format!("<pre>{}</pre>", escape(&text));
    }
    for (_, svg) in figures(outcomes) {
        out += &svg;
    }
    out += "</html>\n";
    out
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn figure(outcomes: &[Outcome], title: &str, panels: &[Panel]) -> String {
    let (width, height) = (PANEL_WIDTH * panels.len() as f64, LEGEND + 60.0);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"11\"><text x=\"4\" y=\"14\" font-size=\"14\">\
         {}</text>",
        escape(title)
    );
    for (index, panel) in panels.iter().enumerate() {
        draw_panel(&mut out, outcomes, panel, index as f64 * PANEL_WIDTH);
    }
    legend(&mut out);
    out += "</svg>";
    out
}

fn draw_panel(out: &mut String, outcomes: &[Outcome], (name, value): &Panel, left: f64) {
    let axis = Axis::over(outcomes.iter().map(value));
    let x = |i: usize| left + MARGIN + i as f64 * (PANEL_WIDTH - MARGIN - 18.0) / 6.0;
    let y = |v: f64| BOTTOM - (BOTTOM - TOP) * axis.share(v);
    let _ = write!(
        out,
        "<text x=\"{:.1}\" y=\"{}\" font-weight=\"bold\">{name}</text>",
        x(0),
        TOP - 12.0
    );
    for v in axis.ticks() {
        let _ = write!(
            out,
            "<path d=\"M{:.1} {y:.1}H{:.1}\" stroke=\"#ddd\"/><text x=\"{:.1}\" y=\"{:.1}\" \
             text-anchor=\"end\">{}</text>",
            x(0),
            x(6),
            x(0) - 4.0,
            y(v) + 4.0,
            axis.label(v),
            y = y(v)
        );
    }
    for (i, scale) in SCALES.iter().enumerate() {
        let _ = write!(
            out,
            "<text x=\"{:.1}\" y=\"{}\" text-anchor=\"middle\">{scale}</text>",
            x(i),
            BOTTOM + 16.0
        );
    }
    let _ = write!(
        out,
        "<text x=\"{:.1}\" y=\"{}\" text-anchor=\"middle\" fill=\"#666\">scale of the triangles\
         </text>",
        x(3),
        BOTTOM + 32.0
    );
    for (index, color) in COLORS.iter().enumerate() {
        let points: Vec<String> = line(outcomes, index)
            .iter()
            .enumerate()
            .map(|(i, o)| format!("{:.1},{:.1}", x(i), y(value(o))))
            .collect();
        let _ = write!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"1.5\"/>",
            points.join(" ")
        );
    }
}

/// A vertical axis from zero or below, in round steps.
struct Axis {
    low: f64,
    high: f64,
    step: f64,
}

impl Axis {
    fn over(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((0.0f64, 1e-9f64), |(l, h), v| (l.min(v), h.max(v)));
        let rough = (high - low) / 4.0;
        let power = 10f64.powi(rough.log10().floor() as i32);
        let step = [1.0, 2.0, 5.0].into_iter().find(|m| m * power >= rough).unwrap_or(10.0) * power;
        Self { low: (low / step).floor() * step, high: (high / step).ceil() * step, step }
    }

    fn ticks(&self) -> impl Iterator<Item = f64> {
        let count = ((self.high - self.low) / self.step).round() as u32;
        (0..=count).map(|i| self.low + f64::from(i) * self.step)
    }

    /// How far up the axis a value lies, 0..=1.
    fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    fn label(&self, value: f64) -> String {
        let digits = (-self.step.log10().floor()).max(0.0) as usize;
        format!("{value:.digits$}")
    }
}

fn legend(out: &mut String) {
    for (index, (mode, color)) in CHARTED.iter().zip(COLORS).enumerate() {
        let (x, y) = (8.0 + 300.0 * (index % 4) as f64, LEGEND + 20.0 * (index / 4) as f64);
        let _ = write!(
            out,
            "<path d=\"M{x} {y}h20\" stroke=\"{color}\" stroke-width=\"3\"/><text x=\"{}\" \
             y=\"{}\">{}</text>",
            x + 26.0,
            y + 4.0,
            mode.title
        );
    }
}
