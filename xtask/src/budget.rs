//! Instructions of each draw state, against the kept record.
//!
//! `fillrate-budget` draws its scenes under callgrind, which leaves a part for
//! the frames of each. Instructions do not depend on what else the machine
//! does, so that a change of a few percent is seen.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context as _, Result, bail, ensure};
use serde::{Deserialize, Serialize};

/// The levels counted; valgrind has no AVX-512.
const LEVELS: [&str; 2] = ["sse4.1", "avx2"];
/// How much more than the record is let pass.
const ALLOWED: f64 = 1.02;
/// How much less is worth a line.
const BETTER: f64 = 0.98;

/// Workers among which the same work must stay the same.
const WORKERS: u32 = 16;
/// The level at which that is counted.
const WORKERS_LEVEL: &str = "avx2";
/// How much more all of them together may do than one.
/// Which worker takes what changes from run to run, by up to 5 % on a busy machine.
const SHARED: f64 = 1.15;

/// A line of `fillrate-budget`.
#[derive(Debug, Deserialize)]
struct Drawn {
    kernel: String,
    unit: String,
    count: u64,
    picture: String,
}

/// Instructions for each pixel, triangle or whatever is counted.
#[derive(Clone, Debug, Deserialize, Serialize)]
struct Cost {
    unit: String,
    instructions: f64,
}

/// Costs by kernel.
type Costs = BTreeMap<String, Cost>;

/// What is kept.
#[derive(Debug, Default, Deserialize, Serialize)]
struct Record {
    /// Of the last record.
    rustc: String,
    /// Why it was recorded, the last reason last.
    reasons: Vec<String>,
    /// By level.
    levels: BTreeMap<String, Costs>,
}

/// Counts and compares, or with a reason keeps what was counted.
///
/// # Errors
/// A kernel above its budget; pictures that differ between levels; what is
/// missing to count.
pub fn budget(root: &Path, reason: Option<&str>) -> Result<()> {
    let program = build(root)?;
    let plain = drawn(&run(Command::new(&program).arg("scalar"))?)?;
    let mut levels = BTreeMap::new();
    for level in LEVELS {
        levels.insert(level.to_string(), count(root, &program, level, 1, &plain)?);
    }
    let shared = count(root, &program, WORKERS_LEVEL, WORKERS, &plain)?;
    check_shared(&levels[WORKERS_LEVEL], &shared)?;
    let file = root.join("benches/records/budget.json");
    let mut record = match std::fs::read_to_string(&file) {
        Ok(text) => serde_json::from_str(&text).context("benches/records/budget.json")?,
        Err(_) => Record::default(),
    };
    let rustc = run(Command::new("rustc").arg("--version"))?.trim().to_string();
    if let Some(reason) = reason {
        record.reasons.push(reason.to_string());
        (record.rustc, record.levels) = (rustc, levels);
        let text = serde_json::to_string_pretty(&record)? + "\n";
        return std::fs::write(&file, text).context("the record cannot be written");
    }
    if record.rustc != rustc {
        println!("recorded with {}, counted with {rustc}", record.rustc);
    }
    let above = compare(&record.levels, &levels);
    ensure!(
        above.is_empty(),
        "above budget: {}\nmake it cheaper, or keep it: \
         cargo run -p fillrate-xtask -- budget --record \"why\"",
        above.join(", ")
    );
    Ok(())
}

/// Builds the program that draws; returns where it is.
pub fn build(root: &Path) -> Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["build", "--release", "--quiet", "-p", "fillrate-budget"]);
    run(command.current_dir(root))?;
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    Ok(target.join("release/fillrate-budget"))
}

/// Runs a command; returns what it printed.
///
/// # Errors
/// Where it cannot be started, or fails.
pub fn run(command: &mut Command) -> Result<String> {
    let output = command.output().with_context(|| format!("{command:?} cannot be started"))?;
    if !output.status.success() {
        bail!("{command:?}: {}\n{}", output.status, String::from_utf8_lossy(&output.stderr));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn drawn(text: &str) -> Result<Vec<Drawn>> {
    text.lines()
        .map(|line| serde_json::from_str(line).context("a line of fillrate-budget"))
        .collect()
}

/// Compares what one worker does with what several do together, over all
/// scenes alike.
fn check_shared(one: &Costs, several: &Costs) -> Result<()> {
    let ratios = one.iter().filter_map(|(name, cost)| {
        several.get(name).map(|several| several.instructions / cost.instructions)
    });
    let ratio = ratios.sum::<f64>() / one.len() as f64;
    println!("{WORKERS} workers do {ratio:.4} times the work of one");
    ensure!(ratio <= SHARED, "work grows with the number of workers");
    Ok(())
}

/// Draws all scenes at a level under callgrind.
fn count(root: &Path, program: &Path, level: &str, workers: u32, plain: &[Drawn]) -> Result<Costs> {
    let folder = root.join("target/budget").join(format!("{level}-{workers}"));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder)?;
    let mut command = Command::new("valgrind");
    command
        .args(["--tool=callgrind", "--dump-before=*budget_mark*"])
        .arg(format!("--callgrind-out-file={}/part", folder.display()))
        .arg(program)
        .args([level, &workers.to_string()]);
    let drawn = drawn(&run(&mut command)?)?;
    ensure!(drawn.len() == plain.len(), "{level}: {} kernels of {}", drawn.len(), plain.len());
    let mut costs = Costs::new();
    for (i, (drawn, plain)) in drawn.into_iter().zip(plain).enumerate() {
        ensure!(drawn.picture == plain.picture, "{}: {level} and scalar differ", drawn.kernel);
        let part = folder.join(format!("part.{}", 2 * i + 2));
        let instructions = total(&part)? as f64 / drawn.count as f64;
        // Enough digits to tell one percent.
        let instructions = (instructions * 1000.0).round() / 1000.0;
        costs.insert(drawn.kernel, Cost { unit: drawn.unit, instructions });
    }
    Ok(costs)
}

/// Instructions of a part.
fn total(part: &Path) -> Result<u64> {
    let name = part.display();
    let text = std::fs::read_to_string(part).with_context(|| format!("{name} is missing"))?;
    let line = text.lines().find_map(|line| line.strip_prefix("summary:"));
    let line = line.or_else(|| text.lines().find_map(|line| line.strip_prefix("totals:")));
    let number = line.and_then(|line| line.trim().parse().ok());
    number.with_context(|| format!("{name} has no sum"))
}

/// Prints a table; returns what is above its budget, or has none.
fn compare(kept: &BTreeMap<String, Costs>, now: &BTreeMap<String, Costs>) -> Vec<String> {
    let mut above = Vec::new();
    println!("{:20} {:8} {:>12} {:>12} {:>8}", "kernel", "level", "kept", "now", "unit");
    for (level, costs) in now {
        for (kernel, cost) in costs {
            let kept = kept.get(level).and_then(|costs| costs.get(kernel));
            let limit = kept.map_or(0.0, |kept| kept.instructions);
            let ratio = cost.instructions / limit;
            let verdict = match kept {
                None => "  no budget is kept".to_string(),
                Some(_) if ratio > ALLOWED => format!("  {:+.1} %", (ratio - 1.0) * 100.0),
                Some(_) if ratio < BETTER => format!("  {:+.1} %, less", (ratio - 1.0) * 100.0),
                Some(_) => String::new(),
            };
            println!(
                "{kernel:20} {level:8} {limit:12.3} {:12.3} {:>8}{verdict}",
                cost.instructions, cost.unit
            );
            if kept.is_none() || ratio > ALLOWED {
                above.push(format!("{kernel} ({level})"));
            }
        }
    }
    above
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(instructions: f64) -> BTreeMap<String, Costs> {
        let cost = Cost { unit: "pixel".into(), instructions };
        BTreeMap::from([("avx2".into(), BTreeMap::from([("flat".into(), cost)]))])
    }

    #[test]
    fn work_must_not_grow_with_workers() {
        let costs = |instructions| levels(instructions)["avx2"].clone();
        assert!(check_shared(&costs(100.0), &costs(100.0 * SHARED - 1.0)).is_ok());
        assert!(check_shared(&costs(100.0), &costs(100.0 * SHARED + 1.0)).is_err());
    }

    #[test]
    fn two_percent_are_let_pass() {
        assert!(compare(&levels(100.0), &levels(101.9)).is_empty());
        assert!(compare(&levels(100.0), &levels(50.0)).is_empty());
        assert_eq!(compare(&levels(100.0), &levels(102.1)), ["flat (avx2)"]);
        assert_eq!(compare(&BTreeMap::new(), &levels(1.0)), ["flat (avx2)"]);
    }
}
