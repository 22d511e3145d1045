//! The balls that a drop may be of, if nobody stated which.

use super::priors::Priors;
use crate::ball::{Ball, KnownBall};

/// A ball that a drop may be of.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PossibleBall {
    /// A stable name of the kind; empty where the ball was stated.
    pub kind: &'static str,
    /// Mass, size and contact time, and how well they are known.
    pub known: KnownBall,
}

/// The kinds of balls that people drop. Only two numbers of a ball affect its flight times: mass over cross-section, which
/// divides the drag, and contact time. A kind is a region of the two; together they cover every
/// [preset](crate::ball::presets) and what lies between.
#[rustfmt::skip]
const KINDS: [PossibleBall; 5] = [
    kind("table-tennis", [2.7, 40.0], 1e-3, [0.05, 0.02, 0.05, 0.5]),
    // Pickleball, floorball, practice balls of golf.
    kind("light-plastic", [23.0, 73.0], 2e-3, [0.2, 0.1, 0.3, 0.7]),
    // Golf, steel, glass, wood.
    kind("hard", [46.0, 40.0], 4e-4, [0.4, 0.2, 0.1, 1.2]),
    // Tennis, padel, squash, racquetball, solid rubber.
    kind("soft-rubber", [50.0, 60.0], 4.5e-3, [0.15, 0.1, 0.2, 0.4]),
    // Basketball, football, futsal, volleyball, handball.
    kind("inflated", [450.0, 220.0], 1.2e-2, [0.3, 0.1, 0.15, 0.4]),
];

const fn kind(
    kind: &'static str,
    [mass_g, diameter_mm]: [f64; 2],
    contact_time_s: f64,
    [
        mass_rel_sd,
        diameter_rel_sd,
        drag_rel_sd,
        contact_time_rel_sd,
    ]: [f64; 4],
) -> PossibleBall {
    let known = KnownBall {
        ball: Ball::nominal(mass_g, diameter_mm),
        contact_time_s,
        mass_rel_sd,
        diameter_rel_sd,
        contact_time_rel_sd,
        drag_rel_sd,
    };
    PossibleBall { kind, known }
}

impl PossibleBall {
    /// Every kind of ball that a drop may be of.
    ///
    /// ```
    /// use bouncelab::inference::PossibleBall;
    ///
    /// assert!(PossibleBall::kinds().iter().any(|possible| possible.kind == "inflated"));
    /// ```
    pub const fn kinds() -> &'static [Self] {
        &KINDS
    }

    /// The kind that is most like a ball: the nearest in the logarithms of mass over cross-section and contact time, in
    /// standard uncertainties of the kind.
    ///
    /// ```
    /// use bouncelab::ball;
    /// use bouncelab::inference::PossibleBall;
    ///
    /// assert_eq!(PossibleBall::kind_of(&ball::preset("futsal")?.known), "inflated");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn kind_of(known: &KnownBall) -> &'static str {
        let column = |known: &KnownBall| known.ball.mass_kg() / known.ball.area_m2();
        let distance = |possible: &&Self| {
            let kind = &possible.known;
            let by_drag = (column(known) / column(kind)).ln()
                / kind
                    .mass_rel_sd
                    .hypot(kind.drag_rel_sd)
                    .hypot(2.0 * kind.diameter_rel_sd);
            let by_contact =
                (known.contact_time_s / kind.contact_time_s).ln() / kind.contact_time_rel_sd;
            by_drag.hypot(by_contact)
        };
        let nearest = |one: &&Self, other: &&Self| distance(one).total_cmp(&distance(other));
        KINDS
            .iter()
            .min_by(nearest)
            .map_or("", |possible| possible.kind)
    }

    /// The one ball that was stated.
    pub(super) const fn stated(ball: Ball, contact_time_s: f64, priors: &Priors) -> Self {
        let known = priors.known(ball, contact_time_s);
        Self { kind: "", known }
    }

    /// These priors, with what is known of this ball.
    pub(super) fn inform(&self, priors: &Priors) -> Priors {
        priors.clone().with_ball(&self.known)
    }
}
