//! Acceleration of gravity.

use crate::error::{Quantity, Result, within};

/// Standard gravity in m/s² (3rd CGPM, 1901).
pub const STANDARD_M_S2: f64 = 9.806_65;

/// Gravity of the WGS 84 ellipsoid at a latitude, less the free-air gradient of 3.086e-6 1/s² with
/// height above sea level.
///
/// Local rock and terrain change it by some 1e-4 m/s²; nothing in a bouncing ball shows that.
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) unless the latitude is from -90 to 90 degrees
/// and the altitude from -1000 to 10 000 m, the habitable range in which the gradient is constant.
///
/// ```
/// let milwaukee = bouncelab::gravity::at(43.04, 188.0)?;
/// assert_eq!(format!("{milwaukee:.4}"), "9.8038");
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn at(latitude_deg: f64, altitude_m: f64) -> Result<f64> {
    /// Normal gravity at the equator, m/s².
    const EQUATOR_M_S2: f64 = 9.780_325_335_9;
    /// Somigliana's constant of WGS 84.
    const SOMIGLIANA: f64 = 1.931_852_652_41e-3;
    /// First eccentricity of the ellipsoid, squared.
    const ECCENTRICITY_SQUARED: f64 = 6.694_379_990_14e-3;
    const FREE_AIR_PER_S2: f64 = 3.086e-6;

    within(Quantity::Latitude, latitude_deg, -90.0..=90.0)?;
    within(Quantity::Altitude, altitude_m, -1000.0..=10_000.0)?;
    let sine_squared = latitude_deg.to_radians().sin().powi(2);
    let sea_level = EQUATOR_M_S2 * (1.0 + SOMIGLIANA * sine_squared)
        / (1.0 - ECCENTRICITY_SQUARED * sine_squared).sqrt();
    Ok(sea_level - FREE_AIR_PER_S2 * altitude_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Normal gravity of WGS 84 (NIMA TR8350.2).
    #[test]
    fn gravity_follows_the_ellipsoid() {
        for (latitude, expected) in [(0.0, "9.7803253"), (45.0, "9.8061978"), (90.0, "9.8321849")] {
            assert_eq!(format!("{:.7}", at(latitude, 0.0).unwrap()), expected);
            assert_eq!(at(latitude, 0.0), at(-latitude, 0.0));
        }
    }

    #[test]
    fn gravity_falls_with_height() {
        let drop = at(45.0, 0.0).unwrap() - at(45.0, 1000.0).unwrap();
        assert!((drop - 3.086e-3).abs() < 1e-12);
    }

    #[test]
    fn places_off_the_earth_are_refused() {
        for (latitude, altitude) in [(91.0, 0.0), (f64::NAN, 0.0), (0.0, 4e5), (0.0, -5000.0)] {
            assert!(at(latitude, altitude).is_err());
        }
    }
}
