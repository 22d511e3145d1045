//! What impacts have in common, and how far one of them is from it.

use super::wave::{KERNEL, convolve, derivative, dot, norm};
use crate::stats::median;

/// Impacts of one drop differ a little, and not as noise does: what they leave unexplained is like so
/// many numbers drawn at random, one or two for each mode that rings. (With modes of random phases,
/// 4 for a steel ball to 7 for a basketball give the errors of the times.)
const FREE_DIFFERENCES: f64 = 5.0;
/// An impact that differs by so many times what is usual is odd.
const ODD: f64 = 4.0;
/// So many standard errors make it sure that the impacts differ: the noise is not quite known.
const SURELY: f64 = 3.0;
/// At least this share of the slope of a template is that of the impacts.
const LEAST_SIGNAL: f64 = 0.1;
/// No shift is surer than this, in samples.
const LEAST_SIGMA: f64 = 0.0001;

pub(super) fn middle_size(waves: &[Vec<f32>]) -> f32 {
    median(waves.iter().map(|wave| f64::from(norm(wave)))).unwrap_or(0.0) as f32
}

/// The weight of a wave in a stack of waves of this middle size.
pub(super) fn weight(wave: &[f32], middle: f32) -> f32 {
    1.0 / norm(wave).max(middle).max(f32::MIN_POSITIVE)
}

/// The sum of the waves: each at unit energy, but those below the middle as quiet as they are,
/// because they hold more noise.
pub(super) fn stack(waves: &[Vec<f32>], middle: f32) -> Vec<f32> {
    let mut stack = vec![0.0; waves[0].len()];
    for wave in waves {
        let scale = weight(wave, middle);
        for (sum, value) in stack.iter_mut().zip(wave) {
            *sum += value * scale;
        }
    }
    stack
}

/// What other impacts say an impact sounds like.
pub(super) struct Template<'a> {
    wave: &'a [f32],
    derivative: Vec<f32>,
    energy: f32,
    slope: f32,
    /// Power of its noise over that of one impact.
    noise: f32,
    /// The weight of the wave that is compared with it, which would be in the stack.
    own: f32,
}

/// How a wave fits a template.
pub(super) struct Fit {
    level: f64,
    /// By how many samples the wave comes late.
    late: f64,
    /// The energy that neither level nor time explains, and of how many samples.
    unexplained: f64,
    count: f64,
}

impl<'a> Template<'a> {
    pub(super) fn new(wave: &'a [f32], noise: f32, own: f32) -> Self {
        let derivative = derivative(wave);
        Self {
            wave,
            noise,
            own,
            energy: dot(wave, wave),
            slope: dot(&derivative, &derivative),
            derivative,
        }
    }

    /// Fits level and time to a wave.
    pub(super) fn fit(&self, wave: &[f32]) -> Fit {
        let level = dot(wave, self.wave) / self.energy;
        let pairs = wave.iter().zip(self.wave);
        let residual: Vec<f32> = pairs.map(|(w, t)| w - level * t).collect();
        let along = dot(&self.derivative, &residual);
        Fit {
            level: level.into(),
            late: f64::from(-along / (level * self.slope)),
            unexplained: f64::from(dot(&residual, &residual) - along * along / self.slope),
            count: wave.len() as f64,
        }
    }

    /// By how many samples to shift a wave. The others are shifted too, each by what is its own
    /// share of the way: so all of them meet in one step.
    pub(super) fn step(&self, fit: &Fit) -> f64 {
        let share = 1.0 / (1.0 + f64::from(self.own) * fit.level);
        if fit.late.is_finite() {
            (share * fit.late).clamp(-0.5, 0.5)
        } else {
            0.0
        }
    }

    /// What keeps the shift of a wave in this noise from being known.
    pub(super) fn doubt(&self, fit: &Fit, noise: &Noise) -> Doubt {
        let square = fit.level * fit.level;
        let count = fit.count;
        // What the noise of both leaves, give or take chance: here, and in what was heard before,
        // from which it is known. (That of the template is common to all impacts, and shifts none
        // against another.)
        let by_noise = count * noise.power * (1.0 + square * f64::from(self.noise));
        let chance = (2.0 * noise.alike * (1.0 / count + 1.0 / noise.heard)).sqrt();
        // The noise of the template is steep too, but says nothing of the time.
        let steep = square * f64::from(self.slope);
        let of_noise = square * count * f64::from(self.noise) * noise.slope;
        let slope = (steep - of_noise).max(LEAST_SIGNAL * steep);
        Doubt {
            energy: square * f64::from(self.energy),
            different: fit.unexplained - by_noise,
            chance: chance * by_noise,
            density: noise.density,
            variance: steep / slope.powi(2),
        }
    }
}

/// What keeps the shift of an impact from being known: noise, and that no two impacts are alike.
pub(super) struct Doubt {
    /// The energy of the impact as far as it sounds like the others.
    pub(super) energy: f64,
    /// The energy that neither template nor noise explains, and its standard error.
    different: f64,
    chance: f64,
    /// The density of the noise.
    density: f64,
    /// Variance of the shift for each unit of density.
    variance: f64,
}

impl Doubt {
    /// Standard error of the shift in samples, if the impacts of the drop differ by this share of
    /// their energy.
    pub(super) fn shift_error(&self, share: f64) -> f64 {
        let usual = share * self.energy;
        let different = if self.different > self.most(share) {
            self.different
        } else {
            usual
        };
        let variance = (self.density + different / FREE_DIFFERENCES) * self.variance;
        variance.sqrt().hypot(LEAST_SIGMA)
    }

    /// The most that usual differences and chance leave over.
    fn most(&self, share: f64) -> f64 {
        ODD * share * self.energy + 2.0 * self.chance
    }
}

/// The share of their energy by which the impacts of a drop differ; 0 if all may be alike.
pub(super) fn usual_difference(doubts: &[&Doubt]) -> f64 {
    const ROUNDS: usize = 8;
    let (share, error) = mean_difference(doubts, 0.0);
    if doubts.is_empty() || share < SURELY * error {
        return 0.0;
    }
    (0..ROUNDS).fold(share, |share, _| mean_difference(doubts, share).0.max(0.0))
}

/// The mean of the shares by which impacts seem to differ, and its standard error, where they are
/// thought to differ by `share`: those known better weigh more, and odd ones count no more than the
/// most that is usual.
fn mean_difference(doubts: &[&Doubt], share: f64) -> (f64, f64) {
    let (mut weights, mut sum) = (0.0, 0.0);
    for doubt in doubts {
        let by_chance = (doubt.chance / doubt.energy).max(f64::EPSILON);
        let weight = 1.0 / (by_chance.powi(2) + share.powi(2));
        weights += weight;
        sum += weight * doubt.different.min(doubt.most(share)) / doubt.energy;
    }
    (sum / weights, 1.0 / weights.sqrt())
}

/// The noise under an impact.
pub(super) struct Noise {
    /// Its power, and from how many samples that is known.
    pub(super) power: f64,
    pub(super) heard: f64,
    /// How many samples in a row are alike, because it was smoothed.
    pub(super) alike: f64,
    /// Its density where the template is steep.
    pub(super) density: f64,
    /// The power of its slope.
    pub(super) slope: f64,
}

/// What smoothing leaves of white noise.
pub(super) struct Left {
    /// The share of its power that can shift impacts like those of this stack: the shift smooths
    /// once what is left of a wave and once the template.
    pub(super) where_steep: f64,
    /// The power of its slope, for each unit of power before.
    pub(super) slope: f64,
}

impl Left {
    pub(super) fn new(stack: &[f32], smoothing: &[f32]) -> Self {
        let slope = derivative(stack);
        let twice = convolve(&slope, smoothing);
        let mut impulse = vec![0.0; smoothing.len() + 2 * KERNEL];
        impulse[KERNEL..][..smoothing.len()].copy_from_slice(smoothing);
        let of_noise = derivative(&impulse);
        Self {
            where_steep: f64::from(
                dot(&twice, &twice) / dot(&slope, &slope).max(f32::MIN_POSITIVE),
            ),
            slope: f64::from(dot(&of_noise, &of_noise)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An impact of this energy, of which so much is left over, give or take 0.01.
    fn doubt(energy: f64, different: f64) -> Doubt {
        Doubt {
            energy,
            different,
            chance: 0.01,
            density: 1e-4,
            variance: 1.0,
        }
    }

    fn usual(doubts: &[Doubt]) -> f64 {
        usual_difference(&doubts.iter().collect::<Vec<_>>())
    }

    #[test]
    fn what_chance_leaves_over_is_no_difference() {
        let alike: Vec<Doubt> = (0..30)
            .map(|n| doubt(1.0, 0.01 * f64::from(n % 3 - 1)))
            .collect();
        assert!(usual(&alike).abs() < f64::EPSILON);
        assert!(usual(&[]).abs() < f64::EPSILON);
    }

    /// Loud impacts tell by how much all differ; a faint one differs as much, though noise hides it.
    #[test]
    fn a_faint_impact_is_known_no_better_than_a_loud_one() {
        let mut doubts: Vec<Doubt> = (0..30).map(|_| doubt(10.0, 1.0)).collect();
        doubts.push(doubt(0.01, 0.0));
        let share = usual(&doubts);
        assert!((share - 0.1).abs() < 1e-3, "{share}");
        assert!(doubts[30].shift_error(share) > doubts[30].shift_error(0.0));
    }

    #[test]
    fn an_odd_impact_counts_its_own_difference_and_hardly_moves_the_usual_one() {
        let mut doubts: Vec<Doubt> = (0..30).map(|_| doubt(10.0, 1.0)).collect();
        doubts.push(doubt(10.0, 100.0));
        let share = usual(&doubts);
        assert!((0.1..0.12).contains(&share), "{share}");
        assert!(doubts[30].shift_error(share) > 5.0 * doubts[0].shift_error(share));
    }
}
