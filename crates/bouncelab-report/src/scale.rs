//! The scale of an axis, and its ticks.

use serde::{Deserialize, Serialize};

use crate::digits::{superscript, with_minus};

/// Nothing has more ticks than this, whatever the numbers.
const MAX_TICKS: usize = 60;

/// Values beyond this, or as many times smaller than 1 on a logarithmic axis, do not decide
/// what an axis shows: nothing that bounces has such a size, and sums would overflow.
const LARGEST: f64 = 1e100;

/// Which values an axis shows, and how they lie on it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Scale {
    kind: Kind,
    low: f64,
    high: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
enum Kind {
    Linear,
    /// Linear with ticks at whole numbers only.
    Counting,
    Log,
}

/// A value with its label.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    pub(crate) label: String,
}

/// The ticks of an axis: labelled ones, and small ones between.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct TickMarks {
    pub(crate) major: Vec<Tick>,
    pub(crate) minor: Vec<f64>,
}

impl Scale {
    /// A linear scale over the values; around a single value, or from 0 to 1 without any.
    pub(crate) fn linear(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = extent(values.into_iter().filter(|v| v.abs() <= LARGEST))
            .map_or((0.0, 1.0), |(low, high)| apart(low, high));
        Self {
            kind: Kind::Linear,
            low,
            high,
        }
    }

    /// A linear scale over the bulk of the values, without those further from the quartiles than three
    /// times the distance between the quartiles (Tukey's "far out").
    pub(crate) fn bulk(values: impl IntoIterator<Item = f64>) -> Self {
        Self::within(3.0, values)
    }

    /// The same for values that follow a curve with a long tail: `times` the distance.
    pub(crate) fn within(times: f64, values: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let Some(last) = sorted.len().checked_sub(1) else {
            return Self::linear([]);
        };
        let quartile = |share: f64| sorted[(share * last as f64).round() as usize];
        let (lower, upper) = (quartile(0.25), quartile(0.75));
        let far = times * (upper - lower);
        let near = |value: &f64| (lower - far..=upper + far).contains(value);
        Self::linear(sorted.iter().copied().filter(near))
    }

    /// A linear scale over whole numbers, with ticks at whole numbers only.
    pub(crate) fn counting(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) =
            extent(values.into_iter().filter(|v| v.abs() <= LARGEST)).unwrap_or((0.0, 1.0));
        let margin = if low < high { 0.0 } else { 0.5 };
        Self {
            kind: Kind::Counting,
            low: low - margin,
            high: high + margin,
        }
    }

    /// A logarithmic scale over the values above zero; from 0.1 to 1 without any.
    pub(crate) fn log(values: impl IntoIterator<Item = f64>) -> Self {
        let usable = values
            .into_iter()
            .filter(|v| (LARGEST.recip()..=LARGEST).contains(v));
        let (low, high) = extent(usable).map_or((0.1, 1.0), |(low, high)| {
            if high / low < 1.05 {
                (low / 1.1, high * 1.1)
            } else {
                (low, high)
            }
        });
        Self {
            kind: Kind::Log,
            low,
            high,
        }
    }

    /// With margins below and above, as shares of the length.
    #[must_use]
    pub(crate) fn padded(self, below: f64, above: f64) -> Self {
        let Self { kind, low, high } = self;
        let (low, high) = if kind == Kind::Log {
            let decades = (high / low).log10();
            (
                low / 10_f64.powf(below * decades),
                high * 10_f64.powf(above * decades),
            )
        } else {
            let span = high - low;
            (low - below * span, high + above * span)
        };
        Self { kind, low, high }
    }

    pub(crate) fn low(&self) -> f64 {
        self.low
    }

    pub(crate) fn high(&self) -> f64 {
        self.high
    }

    /// Where the value lies: 0 at the low end, 1 at the high end; not a number if it has no
    /// position on this axis.
    pub(crate) fn share(&self, value: f64) -> f64 {
        if self.kind == Kind::Log {
            if value > 0.0 {
                (value / self.low).ln() / (self.high / self.low).ln()
            } else {
                f64::NAN
            }
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    /// At most about `most` labelled ticks at round values.
    pub(crate) fn ticks(&self, most: usize) -> TickMarks {
        let most = most.clamp(2, MAX_TICKS);
        if self.kind == Kind::Log {
            self.log_ticks(most)
        } else {
            TickMarks {
                major: self.linear_ticks(most),
                minor: Vec::new(),
            }
        }
    }

    fn linear_ticks(&self, most: usize) -> Vec<Tick> {
        let step = round_step((self.high - self.low) / most as f64);
        let ticks = self.ticks_every(step);
        let finer = self.ticks_every(round_step(0.4 * step));
        if finer.len() <= most + 1 || ticks.len() < 2 {
            finer
        } else {
            ticks
        }
    }

    fn ticks_every(&self, step: f64) -> Vec<Tick> {
        let step = match self.kind {
            Kind::Counting => step.max(1.0),
            Kind::Linear | Kind::Log => step,
        };
        let first = (self.low / step - 1e-9).ceil();
        let last = (self.high / step + 1e-9).floor();
        let count = (last - first + 1.0).clamp(0.0, MAX_TICKS as f64) as usize;
        (0..count)
            .map(|i| {
                let value = (first + i as f64) * step;
                Tick {
                    value,
                    label: decimal_label(value, step),
                }
            })
            .collect()
    }

    /// Powers of ten if there are enough of them; else 1, 2, 5; else all digits; else, on a
    /// short stretch, the round steps of a linear axis. One style of label on one axis.
    fn log_ticks(&self, most: usize) -> TickMarks {
        let minor = self.digits(&[1, 2, 3, 4, 5, 6, 7, 8, 9], 1);
        let decades = (self.high / self.low).log10();
        let skip = (decades / most as f64).ceil().max(1.0) as i32;
        let candidates = [
            self.digits(&[1], skip),
            self.digits(&[1, 2, 5], 1),
            minor.clone(),
        ];
        let enough = most.min(3);
        let powers = candidates[0].clone();
        let fitting = candidates
            .into_iter()
            .find(|values| values.len() >= enough && values.len() <= most.max(9));
        let values = match fitting {
            Some(values) => values,
            None if decades > 1.0 => powers,
            None => {
                return TickMarks {
                    major: self.linear_ticks(most),
                    minor: Vec::new(),
                };
            }
        };
        let plain = values.iter().all(|v| (9.9e-4..=1.01e4).contains(v));
        TickMarks {
            major: values
                .into_iter()
                .map(|value| Tick {
                    value,
                    label: if plain {
                        digit_label(value)
                    } else {
                        power_label(value)
                    },
                })
                .collect(),
            minor: if 1.5 * decades <= most as f64 {
                minor
            } else {
                self.digits(&[1], 1)
            },
        }
    }

    /// The values `digit * 10^n` within the scale, for every `skip`th n.
    fn digits(&self, digits: &[u8], skip: i32) -> Vec<f64> {
        let first = self.low.log10().floor() as i32;
        let last = self.high.log10().ceil() as i32;
        (first..=last)
            .filter(|n| n.rem_euclid(skip) == 0)
            .flat_map(|n| digits.iter().map(move |&d| f64::from(d) * 10_f64.powi(n)))
            .filter(|v| (-1e-9..=1.0 + 1e-9).contains(&self.share(*v)))
            .collect()
    }
}

/// The least and the greatest value.
pub(crate) fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.fold(None, |extent, v| {
        let (low, high) = extent.unwrap_or((v, v));
        Some((v.min(low), v.max(high)))
    })
}

/// Two ends far enough apart that floating-point numbers can distinguish points between them.
fn apart(low: f64, high: f64) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    if high - low > (1e-9 * size).max(LARGEST.recip()) {
        return (low, high);
    }
    let margin = if size > LARGEST.recip() {
        0.05 * size
    } else {
        0.5
    };
    (low - margin, high + margin)
}

/// The smallest of 1, 2, 5, 10, 20, ... (or 0.5, 0.2, ...) that is not below `least`.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|digit| digit * power >= least * (1.0 - 1e-9));
    step.unwrap_or(10.0) * power
}

/// The value with the decimals that the step needs, or as a power of ten when that is
/// shorter.
fn decimal_label(value: f64, step: f64) -> String {
    let place = (step.log10() + 1e-9).floor() as i32;
    let size = value.abs().max(step);
    if size >= 1e6 || place < -6 {
        if value.abs() < step / 2.0 {
            return "0".to_owned();
        }
        let power = size.log10().floor() as i32;
        let decimals = (power - place).clamp(0, 12) as usize;
        let label = format!("{:.decimals$}", value / 10_f64.powi(power));
        return format!("{}×10{}", with_minus(&label), superscript(power));
    }
    let decimals = (-place).max(0) as usize;
    let value = if value.abs() < step / 2.0 { 0.0 } else { value };
    with_minus(&format!("{value:.decimals$}"))
}

/// 0.02, 5, 200: a digit at its decimal place.
fn digit_label(value: f64) -> String {
    let decimals = (-(value.log10() + 1e-9).floor()).max(0.0) as usize;
    format!("{value:.decimals$}")
}

/// 10⁻³, or 2×10⁻³.
fn power_label(value: f64) -> String {
    let power = (value.log10() + 1e-9).floor() as i32;
    let digit = (value / 10_f64.powi(power)).round();
    let power = superscript(power);
    if digit > 1.0 {
        format!("{digit}×10{power}")
    } else {
        format!("10{power}")
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn labels(scale: Scale, most: usize) -> Vec<String> {
        let ticks = scale.ticks(most).major;
        ticks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        assert_eq!(
            labels(Scale::linear([0.0, 7.5]), 8),
            ["0", "1", "2", "3", "4", "5", "6", "7"]
        );
        assert_eq!(
            labels(Scale::linear([-0.31, 0.33]), 4),
            ["−0.2", "0.0", "0.2"]
        );
        assert_eq!(
            labels(Scale::linear([0.93, 0.95]), 4),
            ["0.930", "0.935", "0.940", "0.945", "0.950"]
        );
    }

    #[test]
    fn what_is_counted_has_ticks_at_whole_numbers() {
        let scale = Scale::counting([1.0, 2.0]).padded(0.1, 0.1);
        assert_eq!(labels(scale, 8), ["1", "2"]);
        assert_eq!(labels(Scale::counting([7.0]).padded(0.1, 0.1), 8), ["7"]);
    }

    #[test]
    fn log_ticks_suit_the_stretch() {
        // Ten flights of the paper's drop: less than one decade and no 1, 2 or 5 but one.
        assert_eq!(
            labels(Scale::log([0.25, 0.46]), 6),
            ["0.25", "0.30", "0.35", "0.40", "0.45"]
        );
        assert_eq!(labels(Scale::log([0.08, 0.6]), 6), ["0.1", "0.2", "0.5"]);
        assert_eq!(
            labels(Scale::log([0.01, 10.0]), 6),
            ["0.01", "0.1", "1", "10"]
        );
    }

    #[test]
    fn an_axis_never_mixes_decimals_with_powers_of_ten() {
        assert_eq!(
            labels(Scale::log([1e-5, 1.0]), 8),
            ["10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"]
        );
    }

    #[test]
    fn extreme_values_are_written_as_powers_of_ten() {
        assert_eq!(
            labels(Scale::linear([0.0, 3e7]), 4),
            ["0", "1×10⁷", "2×10⁷", "3×10⁷"]
        );
    }

    #[test]
    fn without_values_there_is_still_an_axis() {
        assert!((Scale::linear([]).share(0.5) - 0.5).abs() < 1e-15);
        assert_eq!(Scale::linear([f64::NAN]), Scale::linear([]));
        assert!(Scale::log([-1.0, 0.0]).share(0.5).is_finite());
        assert!(Scale::log([1.0]).share(0.0).is_nan());
    }

    proptest! {
        /// Whatever the numbers: few ticks, all on the axis, in order, labels distinct.
        #[test]
        fn ticks_lie_on_the_axis(a in any::<f64>(), b in any::<f64>(), log: bool, most in 0_usize..100) {
            let scale = if log { Scale::log([a, b]) } else { Scale::linear([a, b]) };
            let ticks = scale.ticks(most);
            prop_assert!(ticks.major.len() <= MAX_TICKS.max(most));
            for tick in &ticks.major {
                prop_assert!((-1e-6..=1.0 + 1e-6).contains(&scale.share(tick.value)), "{tick:?} {scale:?}");
                prop_assert!(tick.label.chars().count() <= 24, "{tick:?}");
            }
            for pair in ticks.major.windows(2) {
                prop_assert!(pair[0].value < pair[1].value);
            }
        }

        /// For the numbers that occur: at least two labels, and no two the same.
        #[test]
        fn labels_are_distinct(low in -1e3..1e3_f64, span in 1e-4..1e4_f64, most in 3_usize..10) {
            let labels = labels(Scale::linear([low, low + span]), most);
            prop_assert!(labels.len() >= 2, "{labels:?}");
            for pair in labels.windows(2) {
                prop_assert_ne!(&pair[0], &pair[1]);
            }
        }
    }
}
