//! Seeds: every case of every entry has its own, so that each can be replayed alone.

use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// What identifies one case of one entry.
#[derive(Clone, Copy, Debug)]
pub struct Key<'a> {
    /// The run's seed.
    pub seed: u64,
    /// The claim.
    pub label: &'a str,
    /// N.
    pub dimension: usize,
    /// The method's name.
    pub method: &'a str,
    /// Which case.
    pub case: usize,
}

impl Key<'_> {
    /// A runner of proptest strategies with randomness of its own.
    pub fn runner(&self) -> TestRunner {
        let config = Config {
            failure_persistence: None,
            ..Config::default()
        };
        TestRunner::new_with_rng(
            config,
            TestRng::from_seed(RngAlgorithm::ChaCha, &self.bytes()),
        )
    }

    /// FNV-1a of the key, spread to 32 bytes by splitmix64.
    fn bytes(&self) -> [u8; 32] {
        let mut state: u64 = 0xcbf2_9ce4_8422_2325;
        let mut absorb = |bytes: &[u8]| {
            for b in bytes {
                state = (state ^ u64::from(*b)).wrapping_mul(0x100_0000_01b3);
            }
        };
        absorb(&self.seed.to_le_bytes());
        absorb(self.label.as_bytes());
        absorb(&(self.dimension as u64).to_le_bytes());
        absorb(self.method.as_bytes());
        absorb(&(self.case as u64).to_le_bytes());
        let mut bytes = [0; 32];
        for chunk in bytes.chunks_exact_mut(8) {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            chunk.copy_from_slice(&mix(state).to_le_bytes());
        }
        bytes
    }
}

/// The output function of splitmix64.
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
