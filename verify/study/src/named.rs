//! Things that the command line and the reports know by name.

use regge_curvature::metrics::Metric;

/// One of a fixed list of things, each with a name.
pub trait Named: Copy + PartialEq + Send + Sync + 'static {
    /// What the list is of, in the singular.
    const KIND: &'static str;
    /// All of them, by name.
    const ALL: &'static [(&'static str, Self)];

    /// Its name.
    fn name_of(self) -> &'static str {
        Self::ALL
            .iter()
            .find(|entry| entry.1 == self)
            .map_or("?", |entry| entry.0)
    }

    /// The one with this name.
    fn from_name(name: &str) -> Option<Self> {
        Self::ALL
            .iter()
            .find(|entry| entry.0 == name)
            .map(|entry| entry.1)
    }
}

impl Named for Metric {
    const KIND: &'static str = "metric";
    const ALL: &'static [(&'static str, Self)] = &Metric::ALL;
}
