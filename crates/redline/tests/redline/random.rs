//! Seeded numbers: `FILLRATE_CASES` and `FILLRATE_SEED` choose how many cases.

/// SplitMix64.
pub struct Random(u64);

impl Random {
    pub fn new(case: u64) -> Random {
        let seed = std::env::var("FILLRATE_SEED").ok().and_then(|s| s.parse().ok());
        Random(seed.unwrap_or(2026u64).wrapping_mul(0x1_0000_0001).wrapping_add(case))
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn word(&mut self) -> u32 {
        self.next() as u32
    }

    /// 0 to before `end`.
    pub fn below(&mut self, end: u32) -> u32 {
        (self.next() % u64::from(end.max(1))) as u32
    }

    pub fn flag(&mut self) -> bool {
        self.below(2) == 1
    }

    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u32) as usize]
    }
}

/// How many cases to run: `usual`, or what the environment says.
pub fn cases(usual: u64) -> u64 {
    std::env::var("FILLRATE_CASES").ok().and_then(|s| s.parse().ok()).unwrap_or(usual)
}
