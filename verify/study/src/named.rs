//! Things that the command line and the reports know by name.

use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;

/// One of a fixed list of things, each with a name.
pub trait Named: Clone + Send + Sync + 'static {
    /// What the list is of, in the singular.
    const KIND: &'static str;

    /// All of them, in the order in which they are offered.
    fn all() -> Vec<Self>;

    /// Its name.
    fn name_of(&self) -> &'static str;

    /// The one with this name.
    fn from_name(name: &str) -> Option<Self> {
        Self::all().into_iter().find(|one| one.name_of() == name)
    }
}

impl Named for Metric {
    const KIND: &'static str = "metric";

    fn all() -> Vec<Self> {
        Self::ALL.iter().map(|entry| entry.1).collect()
    }

    fn name_of(&self) -> &'static str {
        self.name()
    }
}

impl Named for Interpolant {
    const KIND: &'static str = "interpolant";

    fn all() -> Vec<Self> {
        Self::ALL.to_vec()
    }

    fn name_of(&self) -> &'static str {
        self.name()
    }
}
