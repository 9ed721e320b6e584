//! AArch64 NEON: four lanes.
