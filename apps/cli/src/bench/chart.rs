//! Curves as SVG.

use std::fmt::Write as _;

/// One curve.
pub struct Line {
    /// Shown in the legend.
    pub name: String,
    /// x and y, rising x, both positive.
    pub points: Vec<(f64, f64)>,
}

/// What is drawn. Both axes are logarithmic.
pub struct Chart<'a> {
    /// Above it.
    pub title: &'a str,
    /// What x is.
    pub x: &'a str,
    /// What y is.
    pub y: &'a str,
    /// The curves.
    pub lines: &'a [Line],
}

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 400.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 190.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 50.0;
const COLORS: [&str; 8] =
    ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#17becf", "#7f7f7f"];

/// A logarithmic axis from a value to a place on the page.
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Axis {
        let (low, high) = values.fold((f64::INFINITY, 0.0f64), |(l, h), v| (l.min(v), h.max(v)));
        let (low, high) = if low < high { (low, high) } else { (high / 2.0, high * 2.0) };
        Axis { low, high, from, to }
    }

    fn place(&self, value: f64) -> f64 {
        let part = (value / self.low).ln() / (self.high / self.low).ln();
        self.from + part * (self.to - self.from)
    }

    /// 1, 2 and 5 times powers of ten inside, and more where those are few.
    fn ticks(&self) -> Vec<f64> {
        let of = |steps: &[f64]| -> Vec<f64> {
            let decades = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
            // Tenths are divided, so that they print short.
            let ten = |step: f64, n: i32| match n {
                0.. => step * 10f64.powi(n),
                _ => step / 10f64.powi(-n),
            };
            let all = decades.flat_map(|n| steps.iter().map(move |&step| ten(step, n)));
            all.filter(|tick| (self.low..=self.high).contains(tick)).collect()
        };
        let few = of(&[1.0, 2.0, 5.0]);
        if few.len() >= 4 { few } else { of(&[1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0]) }
    }
}

impl Chart<'_> {
    /// The document.
    pub fn svg(&self) -> String {
        let points = || self.lines.iter().flat_map(|line| &line.points);
        let x = Axis::new(points().map(|p| p.0), LEFT, WIDTH - RIGHT);
        // Half a step of air, and never a flat line at the frame.
        let air = [0.8, 1.25];
        let y = Axis::new(points().flat_map(|p| air.map(|f| p.1 * f)), HEIGHT - BOTTOM, TOP);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
             font-family=\"sans-serif\" font-size=\"12\">\
             <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#fff\"/>\
             <text x=\"{LEFT}\" y=\"22\" font-size=\"15\">{}</text>\n",
            escape(self.title)
        );
        self.grid(&mut out, &x, &y);
        for (line, color) in self.lines.iter().zip(COLORS.iter().cycle()) {
            curve(&mut out, line, color, &x, &y);
        }
        self.legend(&mut out);
        out += "</svg>\n";
        out
    }

    fn grid(&self, out: &mut String, x: &Axis, y: &Axis) {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        for tick in y.ticks() {
            let at = y.place(tick);
            let _ = writeln!(
                out,
                "<path d=\"M{LEFT} {at:.1}H{right}\" stroke=\"#ddd\"/>\
                 <text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{tick}</text>",
                LEFT - 6.0,
                at + 4.0
            );
        }
        let mut values: Vec<f64> = self.lines.iter().flat_map(|l| &l.points).map(|p| p.0).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let mut last = f64::NEG_INFINITY;
        for value in values {
            let at = x.place(value);
            let _ = writeln!(out, "<path d=\"M{at:.1} {TOP}V{bottom}\" stroke=\"#eee\"/>");
            // Labels that would overlap are left out.
            if at - last > 34.0 {
                last = at;
                let _ = writeln!(
                    out,
                    "<text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                    bottom + 16.0,
                    short(value)
                );
            }
        }
        let _ = writeln!(
            out,
            "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\
             <text x=\"16\" y=\"{}\" text-anchor=\"middle\" transform=\"rotate(-90 16 {})\">{}</text>",
            (LEFT + right) / 2.0,
            bottom + 38.0,
            escape(self.x),
            (TOP + bottom) / 2.0,
            (TOP + bottom) / 2.0,
            escape(self.y)
        );
    }

    fn legend(&self, out: &mut String) {
        for (i, (line, color)) in self.lines.iter().zip(COLORS.iter().cycle()).enumerate() {
            let (x, y) = (WIDTH - RIGHT + 14.0, TOP + 12.0 + 20.0 * i as f64);
            let _ = writeln!(
                out,
                "<path d=\"M{x} {y}h18\" stroke=\"{color}\" stroke-width=\"3\"/>\
                 <text x=\"{}\" y=\"{}\">{}</text>",
                x + 24.0,
                y + 4.0,
                escape(&line.name)
            );
        }
    }
}

fn curve(out: &mut String, line: &Line, color: &str, x: &Axis, y: &Axis) {
    let places: Vec<(f64, f64)> =
        line.points.iter().map(|p| (x.place(p.0), y.place(p.1))).collect();
    let path: Vec<String> = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    let _ = writeln!(
        out,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>",
        path.join(" ")
    );
    for (x, y) in places {
        let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{color}\"/>");
    }
}

/// A number of at most three digits after a whole one.
fn short(value: f64) -> String {
    match value {
        v if v >= 10_000.0 => format!("{:.0}k", v / 1000.0),
        v if v >= 10.0 || v.fract() == 0.0 => format!("{v:.0}"),
        v => format!("{v:.1}"),
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn larger_values_are_higher_and_farther_right() {
        let points = vec![(1.0, 10.0), (2.0, 10.0), (16.0, 1000.0)];
        let lines = [Line { name: "a < b".into(), points }];
        let svg = Chart { title: "t", x: "x", y: "y", lines: &lines }.svg();
        assert!(svg.contains("a &lt; b"));
        let circles: Vec<(f64, f64)> = svg
            .lines()
            .filter(|line| line.starts_with("<circle"))
            .map(|line| {
                let field = |name: &str| {
                    let rest = line.split_once(&format!("{name}=\"")).unwrap().1;
                    rest.split_once('"').unwrap().0.parse().unwrap()
                };
                (field("cx"), field("cy"))
            })
            .collect();
        let [a, b, c] = circles[..] else { panic!("{svg}") };
        assert!(a.0 < b.0 && b.0 < c.0 && a.1 == b.1 && b.1 > c.1);
        assert!((b.0 - a.0) * 3.0 - (c.0 - b.0) < 1.0, "x is logarithmic");
    }

    #[test]
    fn a_single_point_is_inside() {
        let lines = [Line { name: "a".into(), points: vec![(4.0, 4.0)] }];
        let svg = Chart { title: "t", x: "x", y: "y", lines: &lines }.svg();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
