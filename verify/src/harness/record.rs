//! What is known of a claim before it is checked: its page, and what it need not do.

/// What a page says of a claim, whatever the dimension.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// The row of the catalogue: `P13`.
    pub label: &'static str,
    /// The labels of the paper's LaTeX source; none for what the paper does not print.
    pub paper: &'static [&'static str],
    /// A name for it.
    pub title: &'static str,
    /// The statement, in LaTeX (math mode).
    pub statement: &'static str,
    /// What keeps the two sides apart: which functions each of them uses.
    pub sides: &'static str,
}

/// What a claim need not do, and why.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Excuses {
    /// Why no second method checks it.
    pub one_method: Option<&'static str>,
    /// Why it has fewer than [`ENOUGH`] random instances.
    pub few_cases: Option<&'static str>,
}

impl Excuses {
    /// None.
    pub const NONE: Self = Self {
        one_method: None,
        few_cases: None,
    };

    /// There is one method only.
    pub const fn one_method(why: &'static str) -> Self {
        Self {
            one_method: Some(why),
            few_cases: None,
        }
    }

    /// There are as many instances as there are.
    pub const fn few_cases(self, why: &'static str) -> Self {
        Self {
            few_cases: Some(why),
            ..self
        }
    }
}

/// How many random instances a claim has by one of its methods at least, over its dimensions and degrees.
pub const ENOUGH: usize = 64;
