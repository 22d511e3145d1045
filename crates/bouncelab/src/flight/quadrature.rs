//! Adaptive Gauss-Kronrod quadrature of two integrands at once.

/// Nodes of the 15-point Kronrod rule on [-1, 1] from the outermost to the middle; every second one
/// belongs to the 7-point Gauss rule (Piessens et al., QUADPACK, 1983).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];

const KRONROD_WEIGHTS: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];

const GAUSS_WEIGHTS: [f64; 4] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_64,
    0.381_830_050_505_118_9,
    0.417_959_183_673_469_4,
];

/// Intervals are halved at most this often; they are then below the spacing of floating point
/// numbers relative to the whole, where nothing is left to gain.
const MAX_HALVINGS: u32 = 48;

/// Two integrals over the same interval.
pub(super) type Pair = [f64; 2];

/// Integrates both components of `f` from `from` to `to`, halving until the difference of the
/// Kronrod and the Gauss rule is below `tolerance` (absolute) in each part.
///
/// That difference is the error of the Gauss rule; the Kronrod value that is returned is better by
/// orders of magnitude for the smooth functions of this crate.
pub(super) fn integrate(f: &impl Fn(f64) -> Pair, from: f64, to: f64, tolerance: Pair) -> Pair {
    halve(f, from, to, tolerance, MAX_HALVINGS)
}

fn halve(f: &impl Fn(f64) -> Pair, from: f64, to: f64, tolerance: Pair, halvings: u32) -> Pair {
    let (integral, error) = gauss_kronrod(f, from, to);
    if halvings == 0 || (error[0] <= tolerance[0] && error[1] <= tolerance[1]) {
        return integral;
    }
    let middle = 0.5 * (from + to);
    let left = halve(f, from, middle, tolerance, halvings - 1);
    let right = halve(f, middle, to, tolerance, halvings - 1);
    [left[0] + right[0], left[1] + right[1]]
}

/// The Kronrod integrals and how far the Gauss integrals are from them.
fn gauss_kronrod(f: &impl Fn(f64) -> Pair, from: f64, to: f64) -> (Pair, Pair) {
    let middle = 0.5 * (from + to);
    let half = 0.5 * (to - from);
    let mut kronrod = [0.0; 2];
    let mut gauss = [0.0; 2];
    for (i, (&node, &weight)) in NODES.iter().zip(&KRONROD_WEIGHTS).enumerate() {
        let above = f(middle + half * node);
        let below = if node > 0.0 {
            f(middle - half * node)
        } else {
            [0.0; 2]
        };
        for k in 0..2 {
            let sum = above[k] + below[k];
            kronrod[k] += weight * sum;
            if i % 2 == 1 {
                gauss[k] += GAUSS_WEIGHTS[i / 2] * sum;
            }
        }
    }
    let error = [0, 1].map(|k| ((kronrod[k] - gauss[k]) * half).abs());
    (kronrod.map(|sum| sum * half), error)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The 15-point Kronrod rule is exact for polynomials up to degree 22.
    #[test]
    fn polynomials_are_exact() {
        let (integral, _) = gauss_kronrod(&|x| [x.powi(22), x.powi(21)], 0.0, 1.0);
        assert!((integral[0] - 1.0 / 23.0).abs() < 1e-16);
        assert!((integral[1] - 1.0 / 22.0).abs() < 1e-16);
    }

    /// The 7-point Gauss rule is exact up to degree 13, so both rules agree.
    #[test]
    fn both_rules_agree_where_both_are_exact() {
        let (_, error) = gauss_kronrod(&|x| [x.powi(13), x.powi(12)], 0.0, 2.0);
        assert!(error[0] < 1e-11 && error[1] < 1e-11);
    }

    #[test]
    fn sharp_peaks_are_resolved() {
        let width = 1e-4;
        let peak = |x: f64| [width / (width * width + x * x), 1.0];
        let integral = integrate(&peak, -1.0, 1.0, [1e-12; 2]);
        assert!((integral[0] - 2.0 * (1.0 / width).atan()).abs() < 1e-12);
        assert!((integral[1] - 2.0).abs() < 1e-14);
    }
}
