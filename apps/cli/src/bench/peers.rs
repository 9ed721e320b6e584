//! Figures of other renderers, beside ours in one table.
//!
//! A file has lines of thirteen fields, one for each renderer and workload:
//! `peer,workload,res,format,ms_frame,Mpix_med,Mpix_min,Mpix_max,Mtri_med,Mtri_min,Mtri_max,frames_s,checksum`.
//! Several lines of the same renderer and workload are several runs.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context as _, Result, bail};

use super::measure::Measured;

/// Fields of a line.
const FIELDS: usize = 13;

/// Median, minimum and maximum of a rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The middle.
    pub median: f64,
    /// The lowest.
    pub min: f64,
    /// The highest.
    pub max: f64,
}

impl Spread {
    /// Several spreads as one: the median of medians, the extremes of all.
    fn of(mut all: Vec<Spread>) -> Option<Spread> {
        all.sort_by(|a, b| a.median.total_cmp(&b.median));
        let middle = all.len() / 2;
        let median = match all.len() {
            0 => return None,
            n if n % 2 == 0 => (all[middle - 1].median + all[middle].median) / 2.0,
            _ => all[middle].median,
        };
        let min = all.iter().map(|s| s.min).fold(f64::INFINITY, f64::min);
        let max = all.iter().map(|s| s.max).fold(0.0, f64::max);
        Some(Spread { median, min, max })
    }
}

/// Rates of a workload that counts triangles, and of one that counts pixels.
type Rates = [Vec<Spread>; 2];

/// Figures of renderers: by size, format, workload and renderer.
#[derive(Debug, Default)]
pub struct Peers(BTreeMap<[String; 4], Rates>);

impl Peers {
    /// Reads files.
    ///
    /// # Errors
    /// Files that cannot be read or hold no figure.
    pub fn load<P: AsRef<Path>>(files: &[P]) -> Result<Peers> {
        let mut peers = Peers::default();
        for file in files {
            let name = file.as_ref().display();
            let text =
                std::fs::read_to_string(file).with_context(|| format!("cannot read {name}"))?;
            if text.lines().filter(|line| peers.add(line)).count() == 0 {
                bail!("{name}: no line has the {FIELDS} fields of a figure");
            }
        }
        Ok(peers)
    }

    /// Adds a line; false for the header and what is no figure.
    fn add(&mut self, line: &str) -> bool {
        let fields: Vec<&str> = line.trim().split(',').collect();
        if fields.len() != FIELDS {
            return false;
        }
        let numbers: Vec<f64> = fields[4..12].iter().filter_map(|f| f.parse().ok()).collect();
        let [_, pixels, pixels_min, pixels_max, triangles, triangles_min, triangles_max, _] =
            numbers[..]
        else {
            return false;
        };
        let [peer, workload, size, format] = [0, 1, 2, 3].map(|i| fields[i].to_string());
        let rates = self.0.entry([size, format, workload, peer]).or_default();
        rates[0].push(Spread { median: pixels, min: pixels_min, max: pixels_max });
        let (min, max) = (triangles_min, triangles_max);
        rates[1].push(Spread { median: triangles, min, max });
        true
    }

    /// Renderers that measured our workload at our size, with their rates.
    fn of(&self, ours: &Measured) -> Vec<(&str, Spread)> {
        let counts_triangles = usize::from(ours.unit == "Mtri/s");
        let key = [&ours.size, &ours.format, &ours.workload];
        let same = self.0.iter().filter(|(k, _)| [&k[0], &k[1], &k[2]] == key);
        same.filter_map(|(k, rates)| {
            Some((k[3].as_str(), Spread::of(rates[counts_triangles].clone())?))
        })
        .collect()
    }

    /// A table: our figures, every renderer's, and how many times the best
    /// renderer's ours is.
    pub fn table(&self, ours: &[Measured]) -> String {
        let ours = merge(ours);
        let rows: Vec<_> = ours.iter().map(|m| (m, self.of(m))).collect();
        let mut names: Vec<&str> =
            rows.iter().flat_map(|(_, peers)| peers.iter().map(|(name, _)| *name)).collect();
        names.sort_unstable();
        names.dedup();
        let mut out = String::from("| workload | unit | fillrate |");
        names.iter().for_each(|name| out += &format!(" {name} |"));
        out += " x best |\n|";
        out += &"---|".repeat(names.len() + 4);
        out.push('\n');
        for (m, peers) in rows {
            let mine = Spread { median: m.median, min: m.min, max: m.max };
            out += &format!("| {} | {} | {} |", m.workload, m.unit, cell(mine));
            for name in &names {
                let rate = peers.iter().find(|(peer, _)| peer == name);
                out += &rate.map_or(" |".into(), |(_, rate)| format!(" {} |", cell(*rate)));
            }
            let best = peers.iter().map(|(_, rate)| rate.median).fold(0.0, f64::max);
            let ratio = if best > 0.0 { format!("{:.2}", m.median / best) } else { String::new() };
            out += &format!(" {ratio} |\n");
        }
        out
    }
}

/// Several measurements of the same as one.
fn merge(ours: &[Measured]) -> Vec<Measured> {
    let key = |m: &Measured| (m.workload.clone(), m.size.clone(), m.threads, m.simd.clone());
    let mut merged: Vec<Measured> = Vec::new();
    for m in ours {
        if merged.iter().any(|other| key(other) == key(m)) {
            continue;
        }
        let same = ours.iter().filter(|other| key(other) == key(m));
        let runs = same.clone().map(|m| m.runs).sum();
        let all = same.map(|m| Spread { median: m.median, min: m.min, max: m.max }).collect();
        let Some(Spread { median, min, max }) = Spread::of(all) else { continue };
        merged.push(Measured { median, min, max, runs, ..m.clone() });
    }
    merged
}

fn cell(rate: Spread) -> String {
    let number = |v: f64| match v {
        v if v < 10.0 => format!("{v:.2}"),
        v if v < 100.0 => format!("{v:.1}"),
        v => format!("{v:.0}"),
    };
    format!("{} ({}-{})", number(rate.median), number(rate.min), number(rate.max))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ours(median: f64) -> Measured {
        Measured {
            workload: "W9_immediate".into(),
            size: "640x480".into(),
            format: "565".into(),
            threads: 2,
            simd: "avx2".into(),
            unit: "Mtri/s".into(),
            median,
            min: median - 1.0,
            max: median + 1.0,
            runs: 7,
            digest: String::new(),
        }
    }

    #[test]
    fn ratios_are_to_the_best_median_of_the_same_size_and_format() {
        let mut peers = Peers::default();
        let line = |peer: &str, format: &str, rate: f64| {
            format!("{peer},W9_immediate,640x480,{format},1,99,98,100,{rate},1,9,5,00aa")
        };
        assert!(!peers.add("peer,workload,res,format,ms_frame,a,b,c,d,e,f,frames_s,checksum"));
        assert!(!peers.add("# something else"));
        for (peer, format, rate) in
            [("a", "565", 2.0), ("a", "565", 4.0), ("b", "565", 1.0), ("c", "8888", 50.0)]
        {
            assert!(peers.add(&line(peer, format, rate)));
        }
        let table = peers.table(&[ours(5.0), ours(7.0)]);
        let row = table.lines().nth(2).unwrap();
        assert_eq!(
            row,
            "| W9_immediate | Mtri/s | 6.00 (4.00-8.00) | 3.00 (1.00-9.00) | 1.00 (1.00-9.00) | 2.00 |"
        );
    }
}
