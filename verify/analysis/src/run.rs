//! Floor 6. Runs the claims, or some of them.

use crate::claim::{Claim, Effort};
use crate::claims::ALL;
use crate::report::{Measured, Report};
use regge_curvature::Error;

/// Does a claim go by this name: its row, or a label of the paper?
pub fn is_called(claim: &Claim, name: &str) -> bool {
    claim.label.eq_ignore_ascii_case(name) || claim.paper.contains(&name)
}

/// Measures the claims of these names, or all if there are none. `begin` is told of each claim before it is measured, with how
/// many there are.
///
/// # Errors
/// If a measurement is not possible, which its claim is named for.
pub fn run(
    effort: &Effort,
    only: &[String],
    begin: &dyn Fn(&Claim, usize),
) -> Result<Report, Error> {
    let wanted = |claim: &&Claim| only.is_empty() || only.iter().any(|name| is_called(claim, name));
    let claims: Vec<&Claim> = ALL.iter().filter(wanted).collect();
    let mut measured = Vec::new();
    for claim in &claims {
        begin(claim, claims.len());
        let findings = (claim.measure)(effort)
            .map_err(|error| Error::Solver(format!("{}: {error}", claim.label)))?;
        let measured_of = Measured::new(claim, &findings);
        if let (false, Some(label)) = (effort.quick, measured_of.silent_on()) {
            let nothing = format!("{}: no finding is about {label}", claim.label);
            return Err(Error::Solver(nothing));
        }
        // A quick run leaves out what cannot be seen on a few small meshes.
        if !(effort.quick && findings.is_empty()) {
            measured.push(measured_of);
        }
    }
    Ok(Report {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        seed: effort.seed,
        quick: effort.quick,
        claims: measured,
    })
}
