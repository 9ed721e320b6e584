//! WebAssembly simd128: four lanes.
