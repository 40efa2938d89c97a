//! What is known of a claim, in a few words: proved, tested exactly, or tested up to rounding.

use super::summary::Row;
use crate::harness::{Entry, Verdict};

impl Row<'_> {
    /// As the tables say it.
    pub fn standing(&self) -> String {
        if self.verdict() == Verdict::Fail {
            return "**fails**".to_owned();
        }
        let entries = |wanted: &dyn Fn(&Entry) -> bool| -> Vec<usize> {
            let mut all: Vec<usize> = (self.entries.iter().filter(|e| wanted(e)))
                .map(|e| e.dimension)
                .collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        let proved = entries(&|e| e.proof.is_some());
        let on_meshes = !entries(&|e| e.on_meshes).is_empty();
        let exactly = self.chance_log2();
        match (on_meshes, exactly) {
            (true, None) => "tested (rounding)".to_owned(),
            (true, Some(_)) if !proved.is_empty() => {
                "tested (rounding); at a point proved".to_owned()
            }
            (true, Some(k)) => format!("tested (rounding); in part exactly (chance < 2^{k:.0})"),
            (false, _) if proved == self.dimensions() => "proved".to_owned(),
            (false, Some(k)) if proved.is_empty() => {
                format!("tested exactly (chance < 2^{k:.0})")
            }
            (false, Some(k)) => {
                let listed: Vec<String> = proved.iter().map(usize::to_string).collect();
                let listed = listed.join(", ");
                format!("proved for N = {listed}; else tested exactly (chance < 2^{k:.0})")
            }
            (false, None) => "tested (rounding)".to_owned(),
        }
    }

    /// log₂ of the chance that a false identity passed, in the dimension where it is largest.
    fn chance_log2(&self) -> Option<f64> {
        let chances = self.entries.iter().filter_map(|e| e.false_accept_log2);
        chances.reduce(f64::max)
    }
}
