//! Runs the charted modes and prints speed-up, utilisation and rates.

use fillrate_raw::bench::{HERTZ, run};

fn main() -> Result<(), fillrate_raw::sim::Deadlock> {
    let setting = run::Setting::default();
    for o in run::run_all(&run::charted(), &setting, 2, |_| {})? {
        let u = o.grid.utilisation(o.columns).map(|u| (u * 100.0).round());
        println!(
            "{} {} {:4}: speed-up {:.2} expected {:.2} overhead {:5.1}% single {:4.1}% chip {:4.1}% stages {u:?} Mpixel/s {:.2} {:.2} ktri/s {:.0} {:.0} {}",
            o.test.outer.name,
            o.test.inner.name,
            o.test.scale,
            o.speed_up(),
            o.expected_speed_up(),
            100.0 * o.overhead(),
            100.0 * o.single.single_utilisation(),
            100.0 * o.grid.chip_utilisation(o.columns),
            o.grid.pixel_rate(HERTZ) / 1e6,
            o.single.pixel_rate(HERTZ) / 1e6,
            o.grid.triangle_rate(HERTZ) / 1e3,
            o.single.triangle_rate(HERTZ) / 1e3,
            if o.same_picture { "" } else { "PICTURES DIFFER" },
        );
    }
    Ok(())
}
