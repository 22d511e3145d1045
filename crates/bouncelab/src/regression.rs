//! The log-linear fit of the paper, Eqs. 4 to 8.
//!
//! Without drag and with a constant coefficient of restitution e, the flight times of a drop shrink
//! by the same factor: log T<sub>n</sub> = n log e + log(2 v₀/g) (Eq. 4). A straight line through
//! log flight time against bounce number therefore gives e from its slope and the drop height from
//! its intercept (Eq. 6). The line knows nothing of drag: with a table-tennis ball it puts e some
//! one and a half points too low. See [`restitution`](crate::restitution) for the cure.
//!
//! ```
//! use bouncelab::regression::{self, NumberedFlight};
//!
//! let times_s = [0.4605, 0.4272, 0.3977, 0.3714, 0.3477, 0.3263, 0.3067, 0.2887, 0.2722, 0.2569];
//! let flights: Vec<_> = times_s
//!     .iter()
//!     .zip(1..)
//!     .map(|(&time_s, number)| NumberedFlight { number, time_s })
//!     .collect();
//! let line = regression::fit(&flights, 9.81)?;
//! assert_eq!(format!("{:.4}", line.restitution.value), "0.9375");
//! assert_eq!(format!("{:.3}", line.drop_height_m.value), "0.288"); // dropped from 0.305
//! # Ok::<(), bouncelab::Error>(())
//! ```

use std::f64::consts::LN_10;

use crate::drop;
use crate::error::{Error, Quantity, Result, in_order, positive};
use crate::estimate::Estimate;

/// A flight time with the number of the bounce that it follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumberedFlight {
    /// Number n of the bounce: 1 for the first impact after release. Missed impacts leave gaps.
    pub number: usize,
    /// Time T<sub>n</sub> from leaving the surface after bounce n to touching it again, s. Take the
    /// contact time off the time between two impacts if it matters.
    pub time_s: f64,
}

/// The straight line through log flight time against bounce number, and what follows from it.
///
/// Intervals are those of Student's t with as many degrees of freedom as there are flights beyond two;
/// with two flights the line is exact and its uncertainty unknown.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct LogLinearFit {
    /// How many flights went into it.
    pub flights: usize,
    /// Slope a of log₁₀ T<sub>n</sub> against n.
    pub slope: Estimate,
    /// Intercept b of log₁₀ T<sub>n</sub> (T in s) at n = 0.
    pub intercept: Estimate,
    /// Share of the variance of log₁₀ T<sub>n</sub> that the line explains; `None` if all flights
    /// last equally long.
    pub r_squared: Option<f64>,
    /// Coefficient of restitution e = 10^a (Eq. 6).
    ///
    /// With noise it can exceed 1, as if flights got longer.
    pub restitution: Estimate,
    /// Drop height h₀ = g (10^b)²/8 in m (Eq. 6; printed in the paper without the square).
    pub drop_height_m: Estimate,
    /// Share of the energy that a bounce keeps, e².
    pub energy_kept: Estimate,
    /// Total time from release to rest in s (Eq. 7); `None` if e is not below 1.
    pub total_time_s: Option<Estimate>,
    /// Total length of the path from release to rest in m (Eq. 8); `None` if e is not below 1.
    pub total_path_m: Option<Estimate>,
    /// What the line leaves of log₁₀ T<sub>n</sub>, in the order of the flights.
    pub residuals: Vec<f64>,
    #[cfg_attr(feature = "serde", serde(skip))]
    line: Line,
}

/// A straight line with the covariance of its two numbers.
#[derive(Debug, Clone, PartialEq)]
struct Line {
    gravity_m_s2: f64,
    slope: f64,
    intercept: f64,
    covariance: Option<Covariance>,
    degrees_of_freedom: f64,
}

/// Variances and covariance of slope and intercept.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Covariance {
    slope: f64,
    intercept: f64,
    mixed: f64,
}

impl Covariance {
    /// Standard error of a quantity with these derivatives (the delta method).
    fn standard_error(&self, by_slope: f64, by_intercept: f64) -> f64 {
        (by_slope * by_slope * self.slope
            + 2.0 * by_slope * by_intercept * self.mixed
            + by_intercept * by_intercept * self.intercept)
            .max(0.0)
            .sqrt()
    }
}

/// Height of a flight without drag from its time, h = g T²/8, in m (paper Eqs. 1 and 5).
///
/// Drag changes it in fourth order only, by less than 3 parts in 10 000 at launches below half the
/// terminal speed: the height that a flight time gives can be trusted.
///
/// ```
/// let height_m = bouncelab::regression::height_of_flight_m(0.4605, 9.81);
/// assert_eq!(format!("{:.1} cm", 100.0 * height_m), "26.0 cm");
/// ```
pub fn height_of_flight_m(time_s: f64, gravity_m_s2: f64) -> f64 {
    gravity_m_s2 * time_s * time_s / 8.0
}

/// Fits the straight line by least squares (paper Eqs. 4 to 6).
///
/// Flights are in order of their number, which may have gaps. The caller chooses which flights take
/// part; the answer depends on it, because drag makes the true curve bend.
///
/// # Errors
/// [`Error::TooFewFlights`] below two flights, [`Error::OutOfRange`] for a time or gravity that is
/// not finite and above zero, [`Error::NotInOrder`] if a number does not exceed the one before.
///
/// ```
/// use bouncelab::regression::{self, NumberedFlight};
///
/// let flights = [(1, 0.4), (2, 0.36), (3, 0.324)].map(|(number, time_s)| NumberedFlight { number, time_s });
/// let line = regression::fit(&flights, 9.81)?;
/// assert!((line.restitution.value - 0.9).abs() < 1e-12);
/// // The sum of all flights, and the fall before the first.
/// assert!((line.total_time_s.unwrap().value - (0.4 / 0.1 + 0.2 / 0.9)).abs() < 1e-12);
/// // One flight is no line.
/// assert!(regression::fit(&flights[..1], 9.81).is_err());
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn fit(flights: &[NumberedFlight], gravity_m_s2: f64) -> Result<LogLinearFit> {
    positive(Quantity::Gravity, gravity_m_s2)?;
    if flights.len() < 2 {
        return Err(Error::TooFewFlights {
            flights: flights.len(),
        });
    }
    for flight in flights {
        positive(Quantity::FlightTime, flight.time_s)?;
    }
    in_order("flight", flights.iter().map(|flight| flight.number))?;
    Ok(least_squares(flights, gravity_m_s2))
}

/// Least squares about the means, so that nothing cancels for late flights.
fn least_squares(flights: &[NumberedFlight], gravity_m_s2: f64) -> LogLinearFit {
    let count = flights.len() as f64;
    let points = || {
        flights
            .iter()
            .map(|flight| (flight.number as f64, flight.time_s.log10()))
    };
    let mean_n = points().map(|(n, _)| n).sum::<f64>() / count;
    let mean_y = points().map(|(_, y)| y).sum::<f64>() / count;
    let spread_n: f64 = points().map(|(n, _)| (n - mean_n).powi(2)).sum();
    let spread_y: f64 = points().map(|(_, y)| (y - mean_y).powi(2)).sum();
    let together: f64 = points().map(|(n, y)| (n - mean_n) * (y - mean_y)).sum();

    let slope = together / spread_n;
    let intercept = mean_y - slope * mean_n;
    let residuals: Vec<f64> = points()
        .map(|(n, y)| y - mean_y - slope * (n - mean_n))
        .collect();
    let unexplained: f64 = residuals.iter().map(|residual| residual * residual).sum();
    let covariance = (flights.len() > 2).then(|| {
        let variance = unexplained / (count - 2.0);
        Covariance {
            slope: variance / spread_n,
            intercept: variance * (1.0 / count + mean_n * mean_n / spread_n),
            mixed: -variance * mean_n / spread_n,
        }
    });
    let r_squared = (spread_y > 0.0).then(|| 1.0 - unexplained / spread_y);
    let line = Line {
        gravity_m_s2,
        slope,
        intercept,
        covariance,
        degrees_of_freedom: count - 2.0,
    };
    LogLinearFit {
        flights: flights.len(),
        slope: line.estimate(slope, 1.0, 0.0),
        intercept: line.estimate(intercept, 0.0, 1.0),
        r_squared,
        restitution: line.restitution(),
        drop_height_m: line.drop_height_m(),
        energy_kept: line.energy_kept(),
        total_time_s: line.total_time_s(),
        total_path_m: line.total_path_m(),
        residuals,
        line,
    }
}

impl LogLinearFit {
    /// The line at bounce number n, as a flight time in s.
    pub fn flight_time_s(&self, number: usize) -> Estimate {
        self.line.flight_time_s(number)
    }
}

impl Line {
    fn restitution(&self) -> Estimate {
        let restitution = 10_f64.powf(self.slope);
        self.estimate(restitution, LN_10 * restitution, 0.0)
    }

    fn drop_height_m(&self) -> Estimate {
        let height_m = height_of_flight_m(10_f64.powf(self.intercept), self.gravity_m_s2);
        self.estimate(height_m, 0.0, 2.0 * LN_10 * height_m)
    }

    fn energy_kept(&self) -> Estimate {
        let kept = 10_f64.powf(2.0 * self.slope);
        self.estimate(kept, 2.0 * LN_10 * kept, 0.0)
    }

    fn flight_time_s(&self, number: usize) -> Estimate {
        let number = number as f64;
        let time_s = 10_f64.powf(self.slope * number + self.intercept);
        self.estimate(time_s, LN_10 * time_s * number, LN_10 * time_s)
    }

    fn total_time_s(&self) -> Option<Estimate> {
        let e = self.restitution().value;
        let time_s = drop::total_time_s(e, self.drop_height_m().value, self.gravity_m_s2).ok()?;
        // d ln(total)/de = 2/(1 - e²); the total goes with the root of h₀, so with 10^b.
        Some(self.estimate(
            time_s,
            time_s * 2.0 / (1.0 - e * e) * LN_10 * e,
            time_s * LN_10,
        ))
    }

    fn total_path_m(&self) -> Option<Estimate> {
        let e = self.restitution().value;
        let path_m = drop::total_path_m(e, self.drop_height_m().value).ok()?;
        // d ln(total)/de = 4 e/(1 - e⁴); the total goes with h₀, so with the square of 10^b.
        let by_slope = path_m * 4.0 * e / (1.0 - e.powi(4)) * LN_10 * e;
        Some(self.estimate(path_m, by_slope, path_m * 2.0 * LN_10))
    }

    /// A quantity with these derivatives by slope and intercept.
    fn estimate(&self, value: f64, by_slope: f64, by_intercept: f64) -> Estimate {
        let Some(covariance) = &self.covariance else {
            return Estimate::unbounded(value);
        };
        let sd = covariance.standard_error(by_slope, by_intercept);
        Estimate::student(value, sd, self.degrees_of_freedom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbered(times_s: &[f64]) -> Vec<NumberedFlight> {
        times_s
            .iter()
            .zip(1..)
            .map(|(&time_s, number)| NumberedFlight { number, time_s })
            .collect()
    }

    fn close(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    /// Flights that obey Eq. 3 exactly, with gaps: the line is exact, whatever flights are missing.
    #[test]
    fn exact_flights_give_the_exact_line() {
        let (e, h0, g) = (0.9_f64, 0.5_f64, 9.81_f64);
        let flights: Vec<_> = [1, 2, 5, 6, 11]
            .map(|number| NumberedFlight {
                number,
                time_s: e.powf(number as f64) * 2.0 * (2.0 * g * h0).sqrt() / g,
            })
            .to_vec();
        let line = fit(&flights, g).unwrap();
        assert!(close(line.restitution.value, e, 1e-14));
        assert!(close(line.drop_height_m.value, h0, 1e-14));
        assert!(close(line.energy_kept.value, e * e, 1e-14));
        assert!(close(line.flight_time_s(5).value, flights[2].time_s, 1e-14));
        assert!(close(line.r_squared.unwrap(), 1.0, 1e-14));
        let total = drop::total_time_s(e, h0, g).unwrap();
        assert!(close(line.total_time_s.unwrap().value, total, 1e-13));
        let path = drop::total_path_m(e, h0).unwrap();
        assert!(close(line.total_path_m.unwrap().value, path, 1e-13));
    }

    /// Small enough to work by hand: y = 1, 3, 2, 5 at n = 1 to 4 has slope 1.1, intercept 0 and
    /// residual variance 1.35.
    #[test]
    fn standard_errors_follow_the_textbook() {
        let flights = numbered(&[1.0, 3.0, 2.0, 5.0].map(|y: f64| 10_f64.powf(y)));
        let line = fit(&flights, 9.81).unwrap();
        assert!(close(line.slope.value, 1.1, 1e-12));
        assert!(line.intercept.value.abs() < 1e-12);
        assert!(close(line.slope.sd, (1.35_f64 / 5.0).sqrt(), 1e-12));
        let of_intercept = (1.35_f64 * (0.25 + 6.25 / 5.0)).sqrt();
        assert!(close(line.intercept.sd, of_intercept, 1e-12));
        // At the mean of n the line is known best: to the standard error of the mean.
        let at_mean = |n| line.flight_time_s(n).sd / line.flight_time_s(n).value;
        assert!(at_mean(2) < at_mean(1) && at_mean(3) < at_mean(4));
        assert!(close(line.r_squared.unwrap(), 6.05 / 8.75, 1e-12));
    }

    /// The delta method against a finite difference through the fit's own covariance.
    #[test]
    fn derived_errors_are_slopes_times_errors() {
        let flights = numbered(&[0.46, 0.43, 0.395, 0.372, 0.347]);
        let line = fit(&flights, 9.81).unwrap();
        let line = line.line;
        let covariance = line.covariance.unwrap();
        let nudged = |slope: f64, intercept: f64| Line {
            slope: line.slope + slope,
            intercept: line.intercept + intercept,
            ..line.clone()
        };
        let step = 1e-6;
        let quantities: [fn(&Line) -> Estimate; 6] = [
            Line::restitution,
            Line::drop_height_m,
            Line::energy_kept,
            |line| line.flight_time_s(3),
            |line| line.total_time_s().unwrap(),
            |line| line.total_path_m().unwrap(),
        ];
        for quantity in quantities {
            let value = |slope, intercept| quantity(&nudged(slope, intercept)).value;
            let by_slope = (value(step, 0.0) - value(-step, 0.0)) / (2.0 * step);
            let by_intercept = (value(0.0, step) - value(0.0, -step)) / (2.0 * step);
            let expected = covariance.standard_error(by_slope, by_intercept);
            assert!(close(quantity(&line).sd, expected, 1e-5));
        }
    }

    #[test]
    fn two_flights_have_a_line_but_no_error() {
        let line = fit(&numbered(&[0.4, 0.36]), 9.81).unwrap();
        assert!(close(line.restitution.value, 0.9, 1e-14));
        assert_eq!(line.restitution.known_sd(), None);
        assert_eq!(line.total_time_s.unwrap().known_sd(), None);
    }

    #[test]
    fn growing_flights_have_a_restitution_but_no_total() {
        let line = fit(&numbered(&[0.3, 0.33, 0.36]), 9.81).unwrap();
        assert!(line.restitution.value > 1.0);
        assert_eq!(line.total_time_s, None);
        assert_eq!(line.total_path_m, None);
        assert_eq!(fit(&numbered(&[0.3, 0.3]), 9.81).unwrap().r_squared, None);
    }

    #[test]
    fn absurd_flights_are_refused() {
        assert_eq!(fit(&[], 9.81), Err(Error::TooFewFlights { flights: 0 }));
        assert_eq!(
            fit(&numbered(&[0.4]), 9.81),
            Err(Error::TooFewFlights { flights: 1 })
        );
        for time_s in [0.0, -0.4, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                fit(&numbered(&[0.4, time_s]), 9.81),
                Err(Error::OutOfRange { .. })
            ));
        }
        let twice = [NumberedFlight {
            number: 2,
            time_s: 0.4,
        }; 2];
        assert_eq!(
            fit(&twice, 9.81),
            Err(Error::NotInOrder {
                what: "flight",
                number: 2
            })
        );
        assert!(fit(&numbered(&[0.4, 0.3]), 0.0).is_err());
    }
}
