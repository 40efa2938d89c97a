//! Where the identities between integrals are tried, and how exactly they hold.

use super::shapes::pressed;
use crate::harness::{Judgement, Setting, Shape, grid};

/// The judgement of identities that hold at every quadrature point: sums of 10⁴ terms at the most, each with an
/// error of a few hundred ulps (inverse of g, derivatives of products).
pub const ROUNDING: Judgement = Judgement::Rounding { tolerance: 1e-12 };
/// The judgement of identities between integrals of functions that are no polynomials: at the order of the case the
/// rules' errors have fallen below this.
pub const QUADRATURE: Judgement = Judgement::Quadrature { tolerance: 1e-11 };

/// The cases of the integral identities that only quadrature keeps apart.
pub fn everywhere(dimension: usize, quick: bool) -> Vec<Setting> {
    use Shape::{Alfeld, Cube, Sphere, Torus};
    let (orders, times) = (orders(dimension), if quick { 1 } else { 4 });
    // Test functions whose Hessians are not constant, once.
    let cubic = Setting::new(Alfeld, 1, orders[1] + 2).tested_by(3);
    let mut all = match dimension {
        2 => grid(&[Alfeld, Cube(2), Torus(3), Sphere], &orders, times),
        3 => {
            let mut all = grid(&[Cube(2), Torus(3)], &orders[..1], 1);
            all.extend(grid(&[Alfeld, Sphere], &orders, times - times / 3));
            all
        }
        _ if quick => grid(&[Alfeld], &orders[..2], 1),
        _ => {
            let mut all = grid(&[Torus(3)], &orders[..1], 1);
            all.extend(grid(&[Alfeld, Sphere], &orders, 1));
            all
        }
    };
    if dimension < 4 {
        all.push(cubic);
    }
    all
}

/// By degree r: where the rules' errors are below 1e-11 of the sums, on these meshes with fields that are not far
/// from flat ones. For r = 0 the integrands are polynomials of degree ≤ 2.
///
/// N = 4, r = 2 is decided by Alfeld's thin cells.
pub fn orders(dimension: usize) -> [usize; 3] {
    match dimension {
        2 => [2, 26, 30],
        3 => [2, 22, 24],
        _ => [2, 14, 16],
    }
}

/// The cases on one simplex: nothing there is continuous, and v is free.
pub fn on_one_simplex(dimension: usize, quick: bool) -> Vec<Setting> {
    let times = if quick { 2 } else { 9 };
    match dimension {
        2 | 3 => grid(&[Shape::Single], &orders(dimension), times),
        // The reference simplex is no thin one: lower orders do.
        _ => grid(&[Shape::Single], &[2, 12, 14], times / 2),
    }
}

/// The cases of identities that hold at every point, of all degrees by a rule of low order.
pub fn at_points(quick: bool) -> Vec<Setting> {
    let times = if quick { 1 } else { 4 };
    grid(&[Shape::Alfeld, Shape::Sphere], &[3, 3, 3], times)
}

/// The judgement in stretched cells: the metric's condition in the cells' coordinates is 10⁴ and more, and g⁻¹, of which
/// products of up to four are taken, has so many times the error.
pub const STRETCHED: Judgement = Judgement::Rounding { tolerance: 1e-9 };

/// The cases in stretched cells of identities that hold at every point, for so many degrees. Squared edges change by so little
/// that the squared heights, which are 900 times smaller, change by up to a sixth, by less where N = 4 and there are more edges.
pub fn in_stretched_cells(dimension: usize, degrees: usize, quick: bool) -> Vec<Setting> {
    let times = if quick { 1 } else { 4 };
    let noise = if dimension < 4 { 5.0 } else { 1.5 } / pressed(dimension).powi(2);
    let all = grid(&[Shape::Stretched], &[3, 3, 3][..degrees], times).into_iter();
    all.map(|at| at.wild(noise)).collect()
}
