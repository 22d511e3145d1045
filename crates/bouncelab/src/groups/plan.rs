//! The number of drops needed for an uncertainty, and the limit for a drift.

/// Upper limit of the number of drops.
pub const MAX_DROPS: usize = 100_000;

/// How many drops of this kind, those made included, give the restitution a 95 % interval of plus or minus `half_width`.
///
/// The scatter has to be estimated from as many drops, which takes z²/2 more than the normal distribution says (W. C. Guenther,
/// Am. Stat. 35, 243, 1981). `one_drop` is the standard deviation of a single drop, `shared` what no number of drops makes smaller. `None` if it takes
/// more than [`MAX_DROPS`].
///
/// ```
/// use bouncelab::groups::drops_needed;
///
/// // 1.96 times 0.002 over the root of 16 is 0.00098, and two more.
/// assert_eq!(drops_needed(0.002, 0.0, 0.001), Some(18));
/// assert_eq!(drops_needed(0.002, 0.0006, 0.001), None);
/// ```
pub fn drops_needed(one_drop: f64, shared: f64, half_width: f64) -> Option<usize> {
    const HALF95: f64 = 1.959_964;
    let left = (half_width / HALF95).powi(2) - shared * shared;
    let drops = (one_drop * one_drop / left + 0.5 * HALF95 * HALF95).ceil();
    (half_width > 0.0 && left > 0.0 && drops <= MAX_DROPS as f64).then_some(drops as usize)
}

/// How far single values lie from their mean as long as nothing changes: three standard deviations,
/// from the differences of successive values, so that a drift does not widen it (chart of
/// individuals: Montgomery, *Introduction to Statistical Quality Control*, 2012, section 6.4).
/// `None` for fewer than two values.
///
/// ```
/// // Successive values differ by 1, 2 and 3.
/// let limit = bouncelab::groups::run_limit(&[1.0, 2.0, 0.0, 3.0]).unwrap();
/// assert!((limit - 3.0 * 2.0 / 1.128).abs() < 1e-12);
/// ```
pub fn run_limit(values: &[f64]) -> Option<f64> {
    /// Mean range of two normal values over their standard deviation, 2/sqrt(pi).
    const RANGE_OF_TWO: f64 = 1.128;
    if values.len() < 2 {
        return None;
    }
    let ranges = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let mean = ranges.sum::<f64>() / (values.len() - 1) as f64;
    Some(3.0 * mean / RANGE_OF_TWO)
}
