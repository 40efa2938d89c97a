//! Why terms vanish.

/// Why R_T, H and G vanish when r = 0.
pub const FLAT: &str = "g is constant on cells";
/// Why the forms on hinges vanish when N = 2.
pub const POINTS: &str = "hinges are points when N = 2";
/// Why G vanishes.
pub const NO_G: &str = "G = 0 when N = 2, or g is constant on cells";
/// Why II‾ vanishes.
pub const NO_II: &str = "II‾ = 0 when N = 2, or g is constant on cells";
