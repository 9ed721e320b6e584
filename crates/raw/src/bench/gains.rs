//! What each improvement gains, and how far the array goes.
//!
//! Beyond the thesis: its chapter 6 names the improvements but measures none. Each is switched on
//! alone, then all together; then the improved machine grows from one column to sixteen. The single
//! tile that everything is compared with is the one of the thesis.

use super::run::{Outcome, Setting, Test, compare};
use super::vectors::{CHARTED, set_up};
use crate::call::Call;
use crate::client::Client;
use crate::errata::Errata;
use crate::protocol::Record;
use crate::sim::{Deadlock, Options};

/// Lines of the charts that the gains of single switches are shown for: titles as in [`CHARTED`].
pub const MODES: [&str; 5] = [
    "flat colour",
    "bilinear texture",
    "everything on",
    "transparent",
    "flat colour, no z, unordered",
];

/// Columns of the machines that the scaling is shown for; each has four tiles.
pub const SIZES: [usize; 5] = [1, 2, 4, 8, 16];

/// Triangles of the scene, and the pixels of each: moderate sizes, as many as 64 tiles can share.
const GRID: [u32; 2] = [20, 16];
/// A triangle's legs in pixels of the 320x240 screen.
const LEG: f32 = 24.0;
/// Steps from triangle to triangle; shares no factor with their number.
const STRIDE: u32 = 83;

/// Numbers of a table, and whether all pictures behind them are those of the single tile.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What is switched on, or a line of the charts.
    pub name: String,
    /// A number for each column of the table.
    pub values: Vec<f64>,
    /// Every picture is the single tile's.
    pub same_pictures: bool,
}

/// All tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Gains {
    /// Speed-ups of sixteen tiles over the thesis's single tile, by [`MODES`]: as in the thesis,
    /// with each improvement alone, with the useful combinations.
    pub switches: Vec<Row>,
    /// Speed-ups with all improvements, by [`SIZES`]; a row for each line of the charts.
    pub scaling: Vec<Row>,
    /// Active share of each stage of sixteen tiles with all improvements, in percent; a row for each
    /// line of the charts.
    pub utilisation: Vec<Row>,
}

/// The machines of the first table.
fn machines() -> Vec<(String, Options)> {
    let thesis = Options::default();
    let with = |names: &[&str]| {
        let mut options = thesis;
        for name in names {
            options.set(name, true);
        }
        (names.join(" + "), options)
    };
    let mut machines = vec![("as in the thesis".to_owned(), thesis)];
    let improves = |name: &&&str| !Options::of_the_thesis().any(|on| on == **name);
    machines.extend(Options::NAMES.iter().filter(improves).map(|name| with(&[name])));
    machines.push(with(&["pixel_pipeline", "overlap_test"]));
    machines.push(with(&["banked", "overlap_test"]));
    machines.push(with(&["banked", "shared_texturing", "walk_in_stage1"]));
    machines.push(("all but pixel_pipeline".to_owned(), Options::improved(4)));
    machines
}

/// Measures all tables.
///
/// # Errors
/// A machine got stuck.
pub fn measure() -> Result<Gains, Deadlock> {
    let mut gains = Gains { switches: Vec::new(), scaling: Vec::new(), utilisation: Vec::new() };
    for (name, options) in machines() {
        let outcomes = MODES.map(|title| outcome(title, options)).into_iter();
        let outcomes = outcomes.collect::<Result<Vec<_>, _>>()?;
        gains.switches.push(row(name, &outcomes));
    }
    for line in &CHARTED {
        let machines = SIZES.map(|columns| outcome(line.title, Options::improved(columns)));
        let outcomes = machines.into_iter().collect::<Result<Vec<_>, _>>()?;
        gains.scaling.push(row(line.title.to_owned(), &outcomes));
        let sixteen = outcomes.iter().filter(|outcome| outcome.columns == 4);
        gains.utilisation.extend(sixteen.map(|outcome| Row {
            name: line.title.to_owned(),
            values: outcome.grid.utilisation(4).map(|share| 100.0 * share).to_vec(),
            same_pictures: outcome.same_picture,
        }));
    }
    Ok(gains)
}

/// A row of speed-ups.
fn row(name: String, outcomes: &[Outcome]) -> Row {
    Row {
        name,
        values: outcomes.iter().map(Outcome::speed_up).collect(),
        same_pictures: outcomes.iter().all(|outcome| outcome.same_picture),
    }
}

/// The scene in a line of the charts, on one tile and on a machine.
fn outcome(title: &str, options: Options) -> Result<Outcome, Deadlock> {
    let line = CHARTED.iter().find(|line| line.title == title).expect("modes are charted");
    let (outer, inner) = line.vectors();
    let setting = Setting { options, ..Setting::default() };
    let test = Test { outer, inner, scale: 1.0 };
    compare(test, &setting, &records(&test))
}

/// The scene: a field of equal triangles, each overlapping its right neighbour.
fn records(test: &Test) -> Vec<Record> {
    let mut client = Client::new(Errata::CORRECT);
    client.meta(Record::PerfReset);
    set_up(&mut client, test.outer, test.inner);
    client.meta(Record::PerfStart);
    client.call(&Call::BeginScene {});
    let count = GRID[0] * GRID[1];
    for index in 0..count {
        // Far apart in time what is close on the screen, as between the objects of a scene.
        let place = index * STRIDE % count;
        triangle(&mut client, [place % GRID[0], place / GRID[0]], index, test.inner.alpha);
    }
    client.call(&Call::EndScene {});
    client.meta(Record::PerfStop);
    client.take_records()
}

fn triangle(client: &mut Client, [column, row]: [u32; 2], index: u32, alpha: u32) {
    let (left, top) = (column as f32 * 15.0 + 3.0, row as f32 * 13.5 + 2.0);
    // No two depths are equal, so that the picture does not depend on the order.
    let z = index as f32 / 1000.0;
    let at = |x: f32, y: f32| [x / 160.0 - 1.0, y / 120.0 - 1.0, z];
    client.call(&Call::BeginPrim {});
    // Every fourth triangle changes the state, as a mesh of few colours does.
    if index.is_multiple_of(4) {
        client.color(12 * column, 15 * row, 200 - 4 * column, alpha);
    }
    client.vertex(at(left, top), [0.0, 0.0]);
    client.vertex(at(left + LEG, top), [1.0, 0.0]);
    client.vertex(at(left, top + LEG), [0.0, 1.0]);
    client.call(&Call::EndPrim {});
}

/// Titles, headings and rows of the tables.
fn tables(gains: &Gains) -> [(&'static str, Vec<String>, &[Row]); 3] {
    let modes = MODES.map(str::to_owned).to_vec();
    let sizes = SIZES.map(|columns| format!("{} tiles", 4 * columns)).to_vec();
    let stages = [1, 2, 3, 4].map(|stage| format!("stage {stage}")).to_vec();
    [
        ("sixteen tiles, speed-up over one", modes, &gains.switches),
        ("all but pixel_pipeline, speed-up over one tile", sizes, &gains.scaling),
        ("sixteen tiles, all but pixel_pipeline, percent active", stages, &gains.utilisation),
    ]
}

/// All tables as text.
pub fn table(gains: &Gains) -> String {
    let mut out = String::new();
    for (title, headings, rows) in tables(gains) {
        out += &format!("{title:<54}");
        for heading in headings {
            out += &format!("{:>17}", heading.chars().take(16).collect::<String>());
        }
        out.push('\n');
        for row in rows {
            out += &format!("{:<54}", row.name);
            row.values.iter().for_each(|value| out += &format!("{value:>17.2}"));
            out += if row.same_pictures { "\n" } else { "  pictures differ\n" };
        }
        out.push('\n');
    }
    out
}

/// All tables as an HTML page.
pub fn page(gains: &Gains) -> String {
    let mut out = String::from(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Raw: gains</title>\
         <style>body{font:15px sans-serif;max-width:1100px;margin:auto}td,th{padding:2px 10px;\
         text-align:right}td:first-child{text-align:left}</style>\
         <h1>What each improvement gains</h1><p>320 triangles of 288 pixels; speed-ups are over the \
         single tile of the thesis.</p>",
    );
    for (title, headings, rows) in tables(gains) {
        out += &format!("<h2>{title}</h2><table><tr><th></th>");
        headings.iter().for_each(|heading| out += &format!("<th>{heading}</th>"));
        for row in rows {
            out += &format!("</tr><tr><td>{}</td>", row.name);
            row.values.iter().for_each(|value| out += &format!("<td>{value:.2}</td>"));
        }
        out += "</tr></table>";
    }
    out += "</html>\n";
    out
}
