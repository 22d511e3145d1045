//! The common waveform of impacts, and the shift of one of them against it.

use super::wave::{convolve, derivative, dot, norm};
use crate::stats::median;
use crate::train::parameters::{
    CHANCE_SIGMAS, DIFFERENCE_ROUNDS, FREE_DIFFERENCES, KERNEL_REACH, MAX_STEP_SAMPLES,
    MIN_DIFFERENT_SIGMA, MIN_OUTLIER_DIFFERENCE, MIN_SHIFT_SIGMA, MIN_SIGNAL_SHARE,
};

/// The median norm of these waves.
pub(super) fn median_size(waves: &[Vec<f32>]) -> f32 {
    median(waves.iter().map(|wave| f64::from(norm(wave)))).unwrap_or(0.0) as f32
}

/// The weight of a wave in a stack of waves of this median size.
pub(super) fn weight(wave: &[f32], median_size: f32) -> f32 {
    1.0 / norm(wave).max(median_size).max(f32::MIN_POSITIVE)
}

/// The sum of the waves: each at unit energy, but those below the median size are not amplified further,
/// because they hold more noise.
pub(super) fn stack(waves: &[Vec<f32>], median_size: f32) -> Vec<f32> {
    let mut stack = vec![0.0; waves[0].len()];
    for wave in waves {
        let scale = weight(wave, median_size);
        for (sum, value) in stack.iter_mut().zip(wave) {
            *sum += value * scale;
        }
    }
    stack
}

/// The waveform of an impact, from the other impacts.
pub(super) struct Template<'a> {
    wave: &'a [f32],
    derivative: Vec<f32>,
    energy: f32,
    /// Energy of the derivative.
    slope: f32,
    /// Power of its noise over that of one impact.
    noise: f32,
    /// The weight that the wave that is compared with it has in the stack of all.
    own: f32,
}

/// How a wave fits a template.
pub(super) struct Fit {
    level: f64,
    /// Delay of the wave in samples.
    late: f64,
    /// The residual energy after level and time are fitted, and the number of samples.
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

    /// Fits level and time to a wave: a(s(t) - d s'(t)), linear least squares in a and a d, since s and s' are
    /// orthogonal.
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

    /// The shift of a wave in this round, in samples. The others are shifted too, and the wave itself pulls their stack,
    /// so each is shifted by its own share: all of them agree after one step.
    pub(super) fn step(&self, fit: &Fit) -> f64 {
        let share = 1.0 / (1.0 + f64::from(self.own) * fit.level);
        if fit.late.is_finite() {
            (share * fit.late).clamp(-MAX_STEP_SAMPLES, MAX_STEP_SAMPLES)
        } else {
            0.0
        }
    }

    /// The uncertainty of the shift of a wave in this noise.
    pub(super) fn uncertainty(&self, fit: &Fit, noise: &Noise) -> Uncertainty {
        let square = fit.level * fit.level;
        let count = fit.count;
        // The residual energy that the noise of wave and template makes, and its standard error: chance in these samples,
        // and in those before the impact, from which its power was measured. (The noise of the template is common to all
        // impacts, and shifts none against another.)
        let by_noise = count * noise.power * (1.0 + square * f64::from(self.noise));
        let chance = (2.0 * noise.correlated * (1.0 / count + 1.0 / noise.samples)).sqrt();
        // The noise of the template has a slope too, which is no information on the time.
        let steep = square * f64::from(self.slope);
        let of_noise = square * count * f64::from(self.noise) * noise.slope;
        let slope = (steep - of_noise).max(MIN_SIGNAL_SHARE * steep);
        Uncertainty {
            energy: square * f64::from(self.energy),
            difference: fit.unexplained - by_noise,
            chance: chance * by_noise,
            density: noise.density,
            // The Cramér-Rao bound, 1/slope, if noise did not add to the slope by which the shift was fitted.
            variance: steep / slope.powi(2),
        }
    }
}

/// The sources of the error of a shift: noise, and the differences between the impacts.
pub(super) struct Uncertainty {
    /// The energy of the impact that the template explains.
    pub(super) energy: f64,
    /// The energy that neither template nor noise explains, and its standard error.
    difference: f64,
    chance: f64,
    /// The density of the noise.
    density: f64,
    /// Variance of the shift for each unit of density.
    variance: f64,
}

impl Uncertainty {
    /// Standard error of the shift in samples, if the impacts of the drop differ by this share of
    /// their energy. An outlier has its own difference.
    pub(super) fn shift_error(&self, share: f64) -> f64 {
        let difference = if self.difference > self.max_usual(share) {
            self.difference
        } else {
            share * self.energy
        };
        let variance = (self.density + difference / FREE_DIFFERENCES) * self.variance;
        variance.sqrt().hypot(MIN_SHIFT_SIGMA)
    }

    /// The maximum difference of an impact that is no outlier.
    fn max_usual(&self, share: f64) -> f64 {
        MIN_OUTLIER_DIFFERENCE * share * self.energy + CHANCE_SIGMAS * self.chance
    }
}

/// The share of their energy by which the impacts of a drop differ; 0 if all may be equal.
pub(super) fn usual_difference(uncertainties: &[&Uncertainty]) -> f64 {
    let (share, error) = mean_difference(uncertainties, 0.0);
    if uncertainties.is_empty() || share < MIN_DIFFERENT_SIGMA * error {
        return 0.0;
    }
    (0..DIFFERENCE_ROUNDS).fold(share, |share, _| {
        mean_difference(uncertainties, share).0.max(0.0)
    })
}

/// The weighted mean of the shares by which impacts differ, and its standard error, assuming that they
/// differ by `share`. The weights are inverse variances, and an outlier counts no more than the
/// maximum of the others.
fn mean_difference(uncertainties: &[&Uncertainty], share: f64) -> (f64, f64) {
    let (mut weights, mut sum) = (0.0, 0.0);
    for it in uncertainties {
        let by_chance = (it.chance / it.energy).max(f64::EPSILON);
        let weight = 1.0 / (by_chance.powi(2) + share.powi(2));
        weights += weight;
        sum += weight * it.difference.min(it.max_usual(share)) / it.energy;
    }
    (sum / weights, 1.0 / weights.sqrt())
}

/// The noise under an impact.
pub(super) struct Noise {
    /// Its power, and the number of samples from which that was measured.
    pub(super) power: f64,
    pub(super) samples: f64,
    /// Samples per independent one, because it was smoothed.
    pub(super) correlated: f64,
    /// Its density where the template is steep.
    pub(super) density: f64,
    /// The power of its slope.
    pub(super) slope: f64,
}

/// White noise of power 1 after smoothing.
pub(super) struct SmoothedNoise {
    /// The part of its power that can shift impacts like those of this stack: the shift is the product of a
    /// smoothed residual and the derivative of a smoothed template.
    pub(super) where_steep: f64,
    /// The power of its derivative.
    pub(super) slope: f64,
}

impl SmoothedNoise {
    pub(super) fn new(stack: &[f32], smoothing: &[f32]) -> Self {
        let slope = derivative(stack);
        let twice = convolve(&slope, smoothing);
        // The power of filtered white noise is the energy of the impulse response.
        let mut impulse = vec![0.0; smoothing.len() + 2 * KERNEL_REACH];
        impulse[KERNEL_REACH..][..smoothing.len()].copy_from_slice(smoothing);
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

    /// An impact of this energy and this difference, whose standard error is 0.01.
    fn uncertainty(energy: f64, difference: f64) -> Uncertainty {
        Uncertainty {
            energy,
            difference,
            chance: 0.01,
            density: 1e-4,
            variance: 1.0,
        }
    }

    fn usual(uncertainties: &[Uncertainty]) -> f64 {
        usual_difference(&uncertainties.iter().collect::<Vec<_>>())
    }

    #[test]
    fn a_residual_by_chance_is_no_difference() {
        let alike: Vec<Uncertainty> = (0..30)
            .map(|n| uncertainty(1.0, 0.01 * f64::from(n % 3 - 1)))
            .collect();
        assert!(usual(&alike).abs() < f64::EPSILON);
        assert!(usual(&[]).abs() < f64::EPSILON);
    }

    /// Loud impacts show by how much all differ; a faint one differs as much, though noise hides it.
    #[test]
    fn a_faint_impact_is_no_more_certain_than_a_loud_one() {
        let mut impacts: Vec<Uncertainty> = (0..30).map(|_| uncertainty(10.0, 1.0)).collect();
        impacts.push(uncertainty(0.01, 0.0));
        let share = usual(&impacts);
        assert!((share - 0.1).abs() < 1e-3, "{share}");
        assert!(impacts[30].shift_error(share) > impacts[30].shift_error(0.0));
    }

    #[test]
    fn an_outlier_has_its_own_difference_and_hardly_moves_the_usual_one() {
        let mut impacts: Vec<Uncertainty> = (0..30).map(|_| uncertainty(10.0, 1.0)).collect();
        impacts.push(uncertainty(10.0, 100.0));
        let share = usual(&impacts);
        assert!((0.1..0.12).contains(&share), "{share}");
        assert!(impacts[30].shift_error(share) > 5.0 * impacts[0].shift_error(share));
    }
}
