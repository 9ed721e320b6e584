//! `fillrate model`: the guide's first program by the guide's table.

use super::super::{fillrate, root, run};
use super::{compile, draw};

fn json(output: &[u8]) -> Vec<serde_json::Value> {
    let text = String::from_utf8_lossy(output);
    text.lines().map(|line| serde_json::from_str(line).expect("a line of JSON")).collect()
}

/// 300 by 200 pixels in half: attributes x and y, 200 lines, 30000 pixels; and
/// what the buffers' clears take.
#[test]
fn the_first_triangle_by_the_table() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let program = compile(&root().join("examples/redline/htri1.c"), folder.path());
    let frames = folder.path().join("frames");
    draw(&program, "v2000", &["-n", "3"], &frames);
    let trace = frames.join("trace");
    let mut limits = Vec::new();
    for (chip, [setup, lines, pixels]) in
        [("v1000", [2 * 20, 200 * 2 * 2, 30000]), ("v2000", [2 * 10, 200, 30000])]
    {
        let output =
            run(fillrate().args(["model", "--json", "--primitives", "--chip", chip]).arg(&trace));
        let models = json(&output.stdout);
        assert_eq!(models.len(), 3);
        let model = &models[1];
        let kinds = model["kinds"].as_array().expect("kinds");
        let triangle = kinds.iter().find(|kind| kind["command"] == "V_FIFO_TRIANGLE");
        let triangle = triangle.expect("a triangle");
        assert_eq!(triangle["vertex"], "V_FIFO_XY");
        let cycles = ["setup_cycles", "line_cycles", "pixel_cycles"]
            .map(|key| triangle[key].as_u64().expect("a number"));
        assert_eq!(cycles, [setup, lines, pixels]);
        assert_eq!((&triangle["lines"], &triangle["pixels"]), (&200.into(), &30000.into()));
        // One clear of 640x480 pixels of two bytes.
        let clear = kinds.iter().find(|kind| kind["command"] == "V_FIFO_MEM_CLEAR_RECT");
        assert_eq!(clear.expect("a clear")["bytes"], 614_400);
        let total = setup + lines + pixels + 614_400 / 8;
        assert_eq!(model["cycles"], total);
        assert_eq!(model["primitives"].as_array().map(Vec::len), Some(2));
        let milliseconds = model["chip_ms"].as_f64().expect("a number");
        let clock = if chip == "v1000" { 50e3 } else { 60e3 };
        assert!((milliseconds - total as f64 / clock).abs() < 1e-9);
        limits.push(model["limit"].clone());
    }
    assert_eq!(limits, ["chip", "chip"]);
    let output = run(fillrate().args(["model", "--json", "--cpu-ms", "20"]).arg(&trace));
    let slow = &json(&output.stdout)[1];
    assert_eq!((&slow["limit"], &slow["frames_per_second"]), (&"cpu".into(), &50.0.into()));
    let text = run(fillrate().args(["model", "--clock", "25"]).arg(&trace));
    assert!(String::from_utf8_lossy(&text.stdout).contains("limit: the chip"));
}

/// Other recordings and other files are told of.
#[test]
fn other_recordings_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let trace = folder.path().join("trace");
    let flat =
        super::super::compile(&root().join("examples/glide/flat.c"), "glide2x", folder.path());
    run(fillrate().args(["run", "--frames", "1", "--trace"]).arg(&trace).arg("--").arg(flat));
    for file in [trace, root().join("Cargo.toml")] {
        let output = fillrate().arg("model").arg(&file).output().expect("the program starts");
        assert_eq!(output.status.code(), Some(3));
    }
}
