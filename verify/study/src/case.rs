//! One mesh with one polynomial degree.

/// One mesh with one polynomial degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    /// r.
    pub degree: usize,
    /// k: the cube is cut into 2^k cubes a side before it is cut into simplices.
    pub level: u32,
}
