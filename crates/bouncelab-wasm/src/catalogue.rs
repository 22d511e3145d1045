//! The choices of the settings: balls, laws and others.

use bouncelab::air::{Air, Conditions};
use bouncelab::drag::DragLaw;
use bouncelab::restitution::LawKind;
use bouncelab::synth::Voice;
use bouncelab::{ball, gravity};

use crate::wire::{BallPreset, Body, Catalogue, RestitutionLawEntry};

/// Everything that a page can offer.
///
/// # Errors
///
/// None: ordinary air is within its range.
pub fn catalogue() -> bouncelab::Result<Catalogue> {
    let air = Conditions::default();
    let balls = ball::presets().iter();
    Ok(Catalogue {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        balls: balls
            .map(|preset| BallPreset {
                name: preset.name.to_owned(),
                label: preset.label.to_owned(),
                mass_kg: preset.known.ball.mass_kg(),
                diameter_m: preset.known.ball.diameter_m(),
                contact_time_s: preset.known.contact_time_s,
                source: preset.source.to_owned(),
            })
            .collect(),
        drag_laws: DragLaw::EXAMPLES.map(str::to_owned).into(),
        restitution_laws: LawKind::ALL
            .iter()
            .map(|law| RestitutionLawEntry {
                name: law.name().to_owned(),
                example: law.example().to_owned(),
            })
            .collect(),
        voices: Voice::NAMES.map(str::to_owned).to_vec(),
        bodies: bodies(&Air::moist(&air)?),
        usual_air: air,
        standard_gravity_m_s2: gravity::STANDARD_M_S2,
    })
}

/// Gravity at the equator and air at the surface, or at 1 bar where there is no surface, of NASA's
/// planetary fact sheets (D. R. Williams, nssdc.gsfc.nasa.gov/planetary/factsheet). Viscosity of
/// the main gas at the temperature there, by Sutherland's formula with the constants of White,
/// Viscous Fluid Flow: good to some per cent.
fn bodies(earth: &Air) -> Vec<Body> {
    let body = |name: &str, gravity_m_s2: f64, density: f64, viscosity: Option<f64>| Body {
        name: name.to_owned(),
        gravity_m_s2,
        air_density_kg_m3: density,
        air_viscosity_pa_s: viscosity,
    };
    vec![
        body(
            "earth",
            gravity::STANDARD_M_S2,
            earth.density_kg_m3(),
            Some(earth.viscosity_pa_s()),
        ),
        body("moon", 1.62, 0.0, None),
        body("mars", 3.73, 0.020, Some(1.1e-5)),
        body("venus", 8.87, 65.0, Some(3.3e-5)),
        body("titan", 1.35, 5.4, Some(6.5e-6)),
        body("jupiter", 24.79, 0.16, Some(7.5e-6)),
    ]
}
