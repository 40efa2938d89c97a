//! From values to colours and labels.

/// A diverging map, blue for negative and red for positive values, white at 0. Source: Moreland, "Diverging color maps
/// for scientific visualization" (2009), cool-warm, brightened in the middle.
const NEGATIVE: [f64; 3] = [59.0, 76.0, 192.0];
const POSITIVE: [f64; 3] = [180.0, 4.0, 38.0];
const ZERO: [f64; 3] = [246.0, 246.0, 246.0];

/// For values of one sign: viridis, which is even in lightness. Source: Smith and van der Walt (2015), five of its 256.
const VIRIDIS: [[f64; 3]; 5] = [
    [68.0, 1.0, 84.0],
    [59.0, 82.0, 139.0],
    [33.0, 145.0, 140.0],
    [94.0, 201.0, 98.0],
    [253.0, 231.0, 37.0],
];

/// The values that the colours stand for.
pub struct Range {
    /// The least.
    pub low: f64,
    /// The largest.
    pub high: f64,
    /// Are there values below, and above?
    pub beyond: [bool; 2],
}

/// The part of the values at either end that may be beyond the colours, where they would leave all others alike.
const BEYOND: f64 = 0.02;

impl Range {
    /// From the least to the largest value; a little around them where they are one.
    pub fn new(values: &[f64]) -> Self {
        let finite = || values.iter().copied().filter(|x| x.is_finite());
        let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
            (l.min(x), h.max(x))
        });
        let size = low.abs().max(high.abs());
        // Differences in the last places are no picture.
        let half = match high - low > 1e-9 * size {
            true => 0.0,
            false => 0.5 * size.max(1e-12),
        };
        match size.is_finite() {
            true => Self {
                low: low - half,
                high: high + half,
                beyond: [false; 2],
            },
            false => Self {
                low: -1.0,
                high: 1.0,
                beyond: [false; 2],
            },
        }
    }

    /// Without the outermost two of a hundred values at either end, if these take more than two thirds of the whole range: noise
    /// of a scanned surface, corners of a box.
    pub fn without_outliers(values: &[f64]) -> Self {
        let mut sorted: Vec<f64> = values.iter().copied().filter(|x| x.is_finite()).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let all = Self::new(values);
        let Some(last) = sorted.len().checked_sub(1) else {
            return all;
        };
        let out = (BEYOND * last as f64) as usize;
        let inner = Self::new(&sorted[out..=last - out]);
        match inner.high - inner.low < (all.high - all.low) / 3.0 {
            true => Self {
                beyond: [all.low < inner.low, all.high > inner.high],
                ..inner
            },
            false => all,
        }
    }

    /// With both signs: white at 0, full colour at the largest absolute value. With one: from end to end.
    pub fn color(&self, value: f64) -> String {
        self.lit(value, 1.0)
    }

    /// The colour in a light between 0 and 1.
    pub fn lit(&self, value: f64, light: f64) -> String {
        let [r, g, b] = self
            .rgb(value)
            .map(|part| (f64::from(part) * light).round() as u8);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    fn rgb(&self, value: f64) -> [u8; 3] {
        if !value.is_finite() {
            return [0xbb; 3];
        }
        match self.low < 0.0 && self.high > 0.0 {
            true => {
                let part = (value / self.low.abs().max(self.high.abs())).clamp(-1.0, 1.0);
                let end = if part < 0.0 { NEGATIVE } else { POSITIVE };
                mixed(ZERO, end, part.abs())
            }
            false => {
                let part = ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0) * 4.0;
                let first = (part as usize).min(3);
                mixed(VIRIDIS[first], VIRIDIS[first + 1], part - first as f64)
            }
        }
    }

    /// With as many digits as tell the ends apart.
    pub fn label(&self, value: f64) -> String {
        let (size, width) = (self.low.abs().max(self.high.abs()), self.high - self.low);
        let value = if value.abs() < 1e-9 * size {
            0.0
        } else {
            value
        };
        let digits = ((size / width).log10().ceil().max(0.0) as usize + 2).min(9);
        let text = match (1e-3..1e4).contains(&size) {
            true => format!(
                "{value:.*}",
                (digits as i32 - size.log10().floor() as i32).max(0) as usize
            ),
            false => format!("{value:.digits$e}"),
        };
        // A minus, not a hyphen.
        text.replace('-', "−")
    }
}

/// (1−t) a + t b.
fn mixed(a: [f64; 3], b: [f64; 3], t: f64) -> [u8; 3] {
    std::array::from_fn(|i| (a[i] + t * (b[i] - a[i])).round() as u8)
}
