//! Streams of nonsense through every way in: no panic, no hang. `FILLRATE_CASES` runs more,
//! `FILLRATE_SEED` others.

use fillrate_raw::hostile::feed;

fn variable(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

/// Numbers that are the same on every machine: xorshift.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

#[test]
fn nonsense_does_no_harm() {
    let seed = variable("FILLRATE_SEED", 1);
    for case in 0..variable("FILLRATE_CASES", 2000) {
        let mut random = Random((seed << 32 | (case + 1)).wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let length = random.next() % 400;
        let mut bytes = vec![(case % 8) as u8 | (random.next() as u8 & 0x80)];
        // Half of the streams enter a scene first and send triangles between the nonsense.
        if random.next().is_multiple_of(2) {
            bytes.extend([0xc0, 100, 102]);
        }
        while (bytes.len() as u64) < length {
            match random.next() % 8 {
                0 => triangle(&mut bytes, &mut random),
                _ => bytes.push(random.next() as u8),
            }
        }
        feed(&bytes);
    }
}

/// Three framed vertices and an end marker.
fn triangle(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..3 {
        bytes.extend([6, 3]);
        (0..5).for_each(|_| bytes.push(0x80 | random.next() as u8 & 0x3f));
    }
    bytes.push(0);
}
