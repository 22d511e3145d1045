//! The experiment of the paper: its ball, its air, its drops.

use bouncelab::Result;
use bouncelab::air::Air;
use bouncelab::ball::{self, Ball};
use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, History, Start, Stop};
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::regression::{self, LogLinearFit, NumberedFlight};
use bouncelab::restitution::{Contact, Restitution};

pub(super) const GRAVITY_M_S2: f64 = 9.81;
pub(super) const DROP_HEIGHT_M: f64 = 0.305;
/// The constant coefficient that the paper takes from a textbook.
pub(super) const CONSTANT: DragLaw = DragLaw::Constant(0.4);
/// The restitution that the paper's regression gives, and the one of its simulation (Fig. 8).
pub(super) const REGRESSED: f64 = 0.9375;
pub(super) const SIMULATED: f64 = 0.935;
/// The buoyancy that the paper prints, from which its density of air follows.
const BUOYANCY_N: f64 = 3.46e-4;
/// The kinematic viscosity implied by its Reynolds number of 6200.
const KINEMATIC_VISCOSITY_M2_S: f64 = 1.5e-5;

/// The ball: 38 mm, 2.5 g.
pub(super) fn ball() -> Result<Ball> {
    Ok(ball::preset("table-tennis-38")?.known.ball)
}

/// The air that makes the printed numbers come out.
pub(super) fn air() -> Result<Air> {
    let density = BUOYANCY_N / (GRAVITY_M_S2 * ball()?.volume_m3());
    Air::new(density, KINEMATIC_VISCOSITY_M2_S * density)
}

/// The flight model with this drag law; like the paper without buoyancy.
pub(super) fn model(drag: DragLaw) -> Result<FlightModel> {
    FlightModel::new(&ball()?, &environment(drag, false)?)
}

/// The flight model with buoyancy and the mass of the air that moves along.
pub(super) fn model_with_buoyancy(drag: DragLaw) -> Result<FlightModel> {
    FlightModel::new(&ball()?, &environment(drag, true)?)
}

fn environment(drag: DragLaw, buoyancy: bool) -> Result<Environment> {
    Ok(Environment {
        gravity_m_s2: GRAVITY_M_S2,
        air: air()?,
        drag,
        buoyancy,
        added_mass: buoyancy,
    })
}

/// A drop from the paper's height with a constant restitution.
pub(super) fn dropped(model: &FlightModel, restitution: f64, stop: Stop) -> Result<History> {
    dropped_by(model, Restitution::constant(restitution)?, stop)
}

/// A drop from the paper's height by a restitution law.
pub(super) fn dropped_by(model: &FlightModel, law: Restitution, stop: Stop) -> Result<History> {
    let contact = Contact::instantaneous(law);
    drop::simulate(model, &contact, Start::Height(DROP_HEIGHT_M), stop)
}

/// The flights of a drop, numbered as the paper numbers them.
pub(super) fn flights(history: &History) -> Vec<NumberedFlight> {
    let numbered = history.bounces().iter().zip(1..);
    numbered
        .map(|(bounce, number)| NumberedFlight {
            number,
            time_s: bounce.flight.time_s(),
        })
        .collect()
}

/// What the log-linear fit of the paper makes of the first flights of a drop with drag.
pub(super) fn regressed(restitution: f64, count: usize) -> Result<LogLinearFit> {
    regressed_by(
        Restitution::constant(restitution)?,
        &model(CONSTANT)?,
        count,
    )
}

/// The same of a drop by a restitution law, in any air.
pub(super) fn regressed_by(
    law: Restitution,
    model: &FlightModel,
    count: usize,
) -> Result<LogLinearFit> {
    let history = dropped_by(model, law, Stop::after(count))?;
    regression::fit(&flights(&history), GRAVITY_M_S2)
}

/// The constant restitution that, with drag, regresses to the paper's e over this number of flights.
pub(super) fn behind_the_regression(count: usize) -> Result<f64> {
    // The regressed value grows with the true one.
    let [low, high] = bisected([REGRESSED, 1.0], 1e-12, |restitution| {
        Ok(regressed(restitution, count)?.restitution.value < REGRESSED)
    })?;
    Ok(f64::midpoint(low, high))
}

/// Two ends so close together, between which something stops to hold that holds at the lower one.
pub(super) fn bisected(
    [mut low, mut high]: [f64; 2],
    width: f64,
    mut holds: impl FnMut(f64) -> Result<bool>,
) -> Result<[f64; 2]> {
    while high - low > width {
        let middle = f64::midpoint(low, high);
        if holds(middle)? {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok([low, high])
}

/// Time and path from release until the ball no longer bounces measurably, with drag.
pub(super) fn totals(restitution: f64) -> Result<(f64, f64)> {
    // A nanometre: what comes after adds less than a tenth of a millisecond.
    let history = dropped(&model(CONSTANT)?, restitution, Stop::below(1e-12))?;
    Ok((history.total_time_s(), history.total_path_m()))
}
