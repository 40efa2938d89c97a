//! Loops over a simplex' unknowns that the compiler unrolls: there are few of them, and where their number is no constant most of the
//! time goes into counting them.

/// `by_width!(width, W => fast, else general)`: `fast` with the constant W where a simplex of the usual degrees, p = 2 and 3 in space and up
/// to 4 in the plane, has so many unknowns.
macro_rules! by_width {
    (@ [$($known:literal)*] $width:expr, $w:ident => $fast:expr, else $general:expr) => {
        match $width {
            $($known => {
                const $w: usize = $known;
                $fast
            })*
            _ => $general,
        }
    };
    ($width:expr, $w:ident => $fast:expr, else $general:expr) => {
        by_width!(@ [1 2 3 5 7] $width, $w => $fast, else $general)
    };
}
pub(super) use by_width;
