//! The table of the interpolants: what is known of each without a mesh.

/// Which one. How each makes its coefficients is said in `Interpolant::coefficients`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Method {
    Canonical,
    Average,
    AverageHierarchical,
    Geodesic,
}

/// A line of the table.
pub(super) struct Record {
    pub(super) method: Method,
    /// As reports and the command line write it.
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    /// None: there is one for every degree.
    pub(super) highest_degree: Option<usize>,
    /// Does it begin with a local L² projection?
    pub(super) projects: bool,
}

pub(super) const TABLE: [Record; 4] = [
    Record {
        method: Method::Canonical,
        name: "canonical",
        about: "the canonical degrees of freedom agree",
        highest_degree: None,
        projects: false,
    },
    Record {
        method: Method::Average,
        name: "average",
        about: "local L2 projection, canonical degrees of freedom averaged (the paper's appendix)",
        highest_degree: None,
        projects: true,
    },
    Record {
        method: Method::AverageHierarchical,
        name: "average-hierarchical",
        about: "local L2 projection, hierarchical coefficients averaged (the printed tables)",
        highest_degree: None,
        projects: true,
    },
    Record {
        method: Method::Geodesic,
        name: "geodesic",
        about: "the edge lengths are geodesic distances (degree 0 only)",
        highest_degree: Some(0),
        projects: false,
    },
];

impl Method {
    /// Its line.
    pub(super) fn record(self) -> &'static Record {
        const { &TABLE }
            .iter()
            .find(|record| record.method == self)
            .expect("every method has its line in the table")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_distinct() {
        for (i, one) in TABLE.iter().enumerate() {
            assert_eq!(one.method.record().name, one.name);
            assert!(TABLE[..i].iter().all(|other| other.name != one.name));
        }
    }
}
