//! A small generator of random numbers.

/// SplitMix64: one 64-bit state, stepped by the golden ratio and mixed.
#[derive(Clone, Debug)]
pub struct Rng {
    state: u64,
}

impl Rng {
    /// The generator of a seed; different seeds are unrelated.
    pub fn new(seed: u64) -> Rng {
        let mut rng = Rng { state: seed };
        Rng { state: rng.bits() }
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// 32 random bits.
    pub fn word(&mut self) -> u32 {
        (self.bits() >> 32) as u32
    }

    /// 0 to `end` - 1; `end` must not be 0.
    pub fn below(&mut self, end: u32) -> u32 {
        self.word() % end
    }

    /// `low` to `high`, both included.
    pub fn range(&mut self, low: i32, high: i32) -> i32 {
        low + self.below((high - low + 1) as u32) as i32
    }

    /// True one time in `times`.
    pub fn one_in(&mut self, times: u32) -> bool {
        self.below(times) == 0
    }

    /// True half of the time.
    pub fn coin(&mut self) -> bool {
        self.one_in(2)
    }

    /// One of several values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len() as u32) as usize]
    }

    /// A value one time in `times`.
    pub fn maybe<T>(&mut self, times: u32, make: impl FnOnce(&mut Rng) -> T) -> Option<T> {
        if self.one_in(times) { Some(make(self)) } else { None }
    }

    /// `low` up to `high`, in 2^24 steps.
    pub fn float(&mut self, low: f32, high: f32) -> f32 {
        let unit = (self.word() >> 8) as f32 / (1u32 << 24) as f32;
        low + unit * (high - low)
    }

    /// A float of random bits: denormals, infinities and not-a-number too.
    pub fn any_float(&mut self) -> f32 {
        f32::from_bits(self.word())
    }
}
