//! Claims about fields on a mesh.

use super::cases::{STRETCHED, in_stretched_cells};
use crate::harness::{
    Catalogue, Check, Draw, Equation, Excuses, Judgement, Kind, Method, OnMeshes, Record, Setting,
    has,
};
use std::marker::PhantomData;

/// A statement about fields on a mesh.
pub trait OnMesh: 'static {
    /// What the page says.
    const RECORD: Record;
    /// How.
    const METHOD: Method = Method::Ad;
    /// How the residuals are judged.
    const JUDGEMENT: Judgement;
    /// Where it is meaningful.
    const DIMENSIONS: &'static [usize] = &[2, 3, 4];
    /// Why there is one method only, or why there are few cases.
    const EXCUSES: Excuses = Excuses::NONE;

    /// The cases in one of these dimensions. The harness runs the simplest first.
    fn settings(dimension: usize, quick: bool) -> Vec<Setting>;

    /// The equations of one case.
    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>>;
}

/// A claim that holds at every point, in stretched cells: for metrics of all degrees below this number.
pub struct Stretched<C, const DEGREES: usize>(PhantomData<fn() -> C>);

impl<C: OnMesh, const DEGREES: usize> OnMesh for Stretched<C, DEGREES> {
    const RECORD: Record = C::RECORD;
    const METHOD: Method = C::METHOD;
    const JUDGEMENT: Judgement = STRETCHED;
    const DIMENSIONS: &'static [usize] = C::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        in_stretched_cells(dimension, DEGREES, quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        C::equations::<N>(at, draw)
    }
}

/// Adds a claim in dimension N, if it is meaningful there. The condition is a constant, so that nothing is compiled for
/// dimensions that a claim does not have. There is one caller for each claim and dimension: inlined, it is no function of
/// its own.
#[inline(always)]
pub fn add<C: OnMesh, const N: usize>(all: &mut Catalogue) {
    if const { has(C::DIMENSIONS, N) } {
        all.push(Check {
            record: &C::RECORD,
            dimension: N,
            method: C::METHOD,
            excuses: C::EXCUSES,
            kind: Kind::Mesh(OnMeshes {
                judgement: C::JUDGEMENT,
                settings: C::settings,
                equations: C::equations::<N>,
            }),
        });
    }
}
