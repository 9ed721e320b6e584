//! The published numbers, and whether a run meets them.
//!
//! The thesis gives its results as sentences and charts; each becomes an accepted range here. Which
//! sizes a sentence speaks of is our reading and part of each band.
//! Source: RAW, section 5.3.

use std::fmt;

use super::HERTZ;
use super::run::Outcome;
use super::vectors::CHARTED;

/// A published quantity with its accepted range, and what was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// What is compared.
    pub name: &'static str,
    /// As published.
    pub published: &'static str,
    /// Lower end of the accepted range.
    pub low: f64,
    /// Upper end of the accepted range.
    pub high: f64,
    /// Smallest measured value.
    pub min: f64,
    /// Largest measured value.
    pub max: f64,
}

impl Band {
    /// Whether everything measured lies in the range.
    pub fn holds(&self) -> bool {
        self.low <= self.min && self.max <= self.high
    }
}

impl fmt::Display for Band {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verdict = if self.holds() { "holds" } else { "FAILS" };
        write!(
            f,
            "{verdict}  {:<44} {:>8.2} to {:>8.2}  accepted {:>8.2} to {:>8.2}  published: {}",
            self.name, self.min, self.max, self.low, self.high, self.published
        )
    }
}

/// A test over all measured values, or over their peak.
struct Query<'a> {
    outcomes: &'a [Outcome],
}

impl Query<'_> {
    fn select(&self, titles: &[&str], sizes: impl Fn(f32) -> bool) -> Vec<Outcome> {
        let named = |o: &Outcome| {
            CHARTED.iter().any(|c| {
                titles.contains(&c.title)
                    && c.outer == o.test.outer.name
                    && c.inner == o.test.inner.name
            })
        };
        self.outcomes.iter().copied().filter(|o| named(o) && sizes(o.test.scale)).collect()
    }
}

fn range(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    values.into_iter().fold(start, |(low, high), v| (low.min(v), high.max(v)))
}

fn band(
    name: &'static str,
    published: &'static str,
    accepted: (f64, f64),
    (min, max): (f64, f64),
) -> Band {
    Band { name, published, low: accepted.0, high: accepted.1, min, max }
}

/// Titles of the opaque, depth-tested charted modes.
const OPAQUE: [&str; 7] = [
    "flat colour",
    "interpolated colour",
    "nearest texture",
    "bilinear texture",
    "flat lit",
    "interpolated lit",
    "everything on",
];
const ORDERED: [&str; 2] = ["transparent", "everything, transparent"];
const UNORDERED: [&str; 2] = ["transparent, unordered", "everything, transparent, unordered"];
const BEST: [&str; 1] = ["flat colour, no z, unordered"];

/// Compares the outcomes of the charted modes at all sizes with the published numbers.
pub fn bands(outcomes: &[Outcome]) -> Vec<Band> {
    let mut bands = speed_ups(outcomes);
    bands.extend(utilisations(outcomes));
    bands.extend(rates(outcomes));
    bands
}

fn speed_ups(outcomes: &[Outcome]) -> Vec<Band> {
    let q = Query { outcomes };
    let speeds = |list: Vec<Outcome>| range(list.iter().map(Outcome::speed_up));
    let (_, best) = speeds(q.select(&BEST, |_| true));
    let moderate = |s: f32| (0.1..=0.5).contains(&s);
    // Transparency is compared where filling decides: on smaller triangles geometry, which four
    // tiles share whatever the order, lifts the speed-up.
    let filling = |s: f32| s >= 0.3;
    vec![
        band("largest speed-up (flat, no z)", "a little less than 5", (4.3, 5.2), (best, best)),
        band(
            "speed-up, opaque, moderate sizes",
            "3 to 4.5",
            (2.7, 4.8),
            speeds(q.select(&OPAQUE, moderate)),
        ),
        band(
            "speed-up, transparent, unordered, large",
            "less than 3",
            (1.8, 3.0),
            speeds(q.select(&UNORDERED, filling)),
        ),
        band(
            "speed-up, transparent, ordered, large",
            "less than 2",
            (1.2, 2.0),
            speeds(q.select(&ORDERED, filling)),
        ),
        band(
            "speed-up, smallest triangles",
            "less than 2",
            (1.2, 2.2),
            range(outcomes.iter().filter(|o| o.test.scale < 0.02).map(Outcome::speed_up)),
        ),
        band(
            "efficiency in percent",
            "9.4 to 28",
            (8.0, 31.0),
            range(outcomes.iter().map(|o| 100.0 * o.efficiency())),
        ),
    ]
}

fn utilisations(outcomes: &[Outcome]) -> Vec<Band> {
    let percent = |f: &dyn Fn(&Outcome) -> f64| range(outcomes.iter().map(|o| 100.0 * f(o)));
    let stages = outcomes.iter().flat_map(|o| o.grid.utilisation(o.columns));
    let saturated = Query { outcomes }.select(&BEST, |s| s >= 0.2);
    vec![
        band(
            "chip utilisation in percent",
            "never above 25 or so",
            (0.0, 28.0),
            percent(&|o| o.grid.chip_utilisation(o.columns)),
        ),
        band(
            "any stage's utilisation in percent",
            "never above about 50",
            (0.0, 55.0),
            range(stages.map(|u| 100.0 * u)),
        ),
        band(
            "stage 4 when saturated, in percent",
            "capped around 25",
            (15.0, 30.0),
            range(saturated.iter().map(|o| 100.0 * o.grid.utilisation(o.columns)[3])),
        ),
        band(
            "single tile's utilisation in percent",
            "60 to 80",
            (55.0, 85.0),
            percent(&|o| o.single.single_utilisation()),
        ),
    ]
}

fn rates(outcomes: &[Outcome]) -> Vec<Band> {
    let peak = |f: &dyn Fn(&Outcome) -> f64| {
        let (_, high) = range(outcomes.iter().map(f));
        (high, high)
    };
    vec![
        band(
            "peak pixel rate, grid, million/s",
            "just under 4",
            (3.4, 4.2),
            peak(&|o| o.grid.pixel_rate(HERTZ) / 1e6),
        ),
        band(
            "peak pixel rate, single tile, million/s",
            "0.8",
            (0.68, 0.92),
            peak(&|o| o.single.pixel_rate(HERTZ) / 1e6),
        ),
        band(
            "peak triangle rate, grid, thousand/s",
            "about 200",
            (170.0, 230.0),
            peak(&|o| o.grid.triangle_rate(HERTZ) / 1e3),
        ),
        band(
            "peak triangle rate, single tile, thousand/s",
            "about 100",
            (85.0, 115.0),
            peak(&|o| o.single.triangle_rate(HERTZ) / 1e3),
        ),
    ]
}

/// The shapes the thesis describes in words, each with whether it shows.
pub fn shapes(outcomes: &[Outcome]) -> Vec<(&'static str, bool)> {
    let q = Query { outcomes };
    let mean = |titles: &[&str], sizes: &dyn Fn(f32) -> bool| {
        let list = q.select(titles, sizes);
        list.iter().map(Outcome::speed_up).sum::<f64>() / list.len().max(1) as f64
    };
    let large = |s: f32| s >= 0.3;
    let (ordered, unordered) = (mean(&ORDERED, &large), mean(&UNORDERED, &large));
    let (opaque, best) = (mean(&OPAQUE, &large), mean(&BEST, &large));
    let line = |title: &'static str| q.select(&[title], |_| true);
    let falls = CHARTED.iter().all(|c| {
        let shares = line(c.title);
        shares.windows(2).all(|w| stage1(&w[0]) <= stage1(&w[1]) + 0.01)
    });
    let interior = OPAQUE.iter().all(|title| {
        let speeds: Vec<f64> = line(title).iter().map(Outcome::speed_up).collect();
        let (_, top) = range(speeds.iter().copied());
        speeds.first() < Some(&top) && speeds.last() < Some(&top)
    });
    vec![
        ("stage 1 does less the larger the triangles", falls),
        ("the speed-up of opaque modes peaks at a moderate size", interior),
        ("ordered < unordered transparent < opaque < no z", {
            ordered < unordered && unordered < opaque && opaque < best
        }),
        ("stage 2 is busiest with plain pixels, then with texture, then with transparency", {
            let stage2 = |t| mean_stage(&line(t), 1);
            stage2(BEST[0]) > stage2("flat colour")
                && stage2("flat colour") > stage2("bilinear texture")
                && stage2("bilinear texture") > stage2("transparent")
        }),
        ("stage 4 is busiest with plain pixels", {
            let stage4 = |t| mean_stage(&line(t), 3);
            CHARTED.iter().all(|c| c.title == BEST[0] || stage4(c.title) < stage4(BEST[0]))
        }),
        ("the overhead is greatest for small triangles and smallest for large ones", {
            let overhead = |sizes: &dyn Fn(f32) -> bool| {
                let (low, high) =
                    range(outcomes.iter().filter(|o| sizes(o.test.scale)).map(Outcome::overhead));
                (low + high) / 2.0
            };
            let (small, medium, large) =
                (overhead(&|s| s < 0.02), overhead(&|s| s == 0.1), overhead(&|s| s == 1.0));
            small > medium && medium > large
        }),
        ("stage 3 is busiest when everything is on", {
            let stage3 = |t| mean_stage(&line(t), 2);
            stage3("everything on") > stage3("flat colour")
                && stage3("flat colour") > stage3("transparent")
        }),
    ]
}

fn stage1(o: &Outcome) -> f64 {
    o.grid.utilisation(o.columns)[0]
}

fn mean_stage(outcomes: &[Outcome], stage: usize) -> f64 {
    let sum: f64 = outcomes.iter().map(|o| o.grid.utilisation(o.columns)[stage]).sum();
    sum / outcomes.len().max(1) as f64
}
