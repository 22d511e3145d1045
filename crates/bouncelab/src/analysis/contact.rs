//! Impacts that are so close to each other that the ball cannot have flown in between.

use crate::diagnostic::{Code, Diagnostic};
use crate::error::{Error, InferenceFailure, Result};
use crate::impact::Impact;

/// Impacts fewer contact times apart than this have no flight between them that is longer than the contact: the time of
/// such a flight shows next to nothing of its speed.
const MIN_CONTACTS: f64 = 2.0;

/// How long it takes from one impact to the next, in contact times for each flight.
fn contacts(from: &Impact, to: &Impact, contact_time_s: f64) -> f64 {
    let flights = to.number.saturating_sub(from.number) as f64;
    (to.time_s - from.time_s) / (contact_time_s * flights)
}

/// `Ok` if the ball can have flown between any two successive impacts.
///
/// # Errors
/// [`InferenceFailure::ContactOverlaps`].
pub(super) fn check(impacts: &[Impact], contact_time_s: f64) -> Result<()> {
    let mut pairs = impacts.windows(2);
    let overlapping =
        pairs.find(|pair| contacts(&pair[0], &pair[1], contact_time_s) < MIN_CONTACTS);
    overlapping.map_or(Ok(()), |pair| {
        Err(Error::CannotInfer(InferenceFailure::of_contact(
            &pair[0],
            &pair[1],
            contact_time_s,
        )))
    })
}

/// The impacts between which the ball can have flown, and a diagnostic about the late ones after them.
///
/// A ball that comes to rest ends with flights as short as its contact; and if a ball is stated that touches the surface
/// for longer, more flights seem so short. Two impacts too close to each other that long flights follow are something else,
/// such as one impact detected twice: they stay.
pub(super) fn flying(impacts: &[Impact], contact_time_s: f64) -> (&[Impact], Option<Diagnostic>) {
    /// The drop ends where no later flight lasts longer than this number of contacts.
    const LATE: f64 = 8.0;
    let lasts = |from: usize, least: f64| {
        contacts(&impacts[from], &impacts[from + 1], contact_time_s) >= least
    };
    let mut intervals = 0..impacts.len().saturating_sub(1);
    let late = intervals.clone().rfind(|&from| lasts(from, LATE));
    let late = late.map_or(0, |last_long| last_long + 1);
    let last = intervals.find(|&from| from >= late && !lasts(from, MIN_CONTACTS));
    // One impact has no flight.
    let Some(last) = last.filter(|&last| last > 0) else {
        return (impacts, None);
    };
    let (flying, others) = impacts.split_at(last + 1);
    let too_close = Diagnostic::new(Code::ImpactsTooClose)
        .with("count", others.len())
        .with("start_s", others[0].time_s)
        .with("contact_time_s", contact_time_s);
    (flying, Some(too_close))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::impacts_of_times;

    /// How many impacts remain, and how many are left out, of these intervals in ms with a contact of 5 ms.
    fn split(intervals_ms: &[f64]) -> (usize, Option<f64>) {
        let times_s: Vec<f64> = intervals_ms
            .iter()
            .scan(0.0, |time_s, interval_ms| {
                *time_s += interval_ms / 1000.0;
                Some(*time_s)
            })
            .collect();
        let impacts = (1..).zip([0.0].into_iter().chain(times_s));
        let impacts: Vec<Impact> = impacts
            .map(|(number, time_s)| Impact::new(number, time_s))
            .collect();
        let (flying, too_close) = flying(&impacts, 0.005);
        (flying.len(), too_close.and_then(|it| it.number("count")))
    }

    #[test]
    fn late_impacts_closer_than_a_contact_are_left_out() {
        assert_eq!(split(&[200.0, 100.0, 50.0, 25.0, 12.0]), (6, None));
        assert_eq!(
            split(&[200.0, 100.0, 50.0, 25.0, 12.0, 6.0, 11.0, 1.0]),
            (6, Some(3.0))
        );
    }

    #[test]
    fn an_impact_detected_twice_stays() {
        assert_eq!(split(&[200.0, 2.0, 100.0, 50.0]), (5, None));
    }

    #[test]
    fn where_no_flight_would_remain_all_stay() {
        assert_eq!(split(&[4.0, 2.0, 1.0]), (4, None));
        assert_eq!(split(&[]), (1, None));
        assert!(flying(&impacts_of_times(&[]), 0.005).0.is_empty());
    }
}
