//! Gaps of lost sound, and the part of a drop that can be used.

use crate::diagnostic::{Code, Diagnostic};
use crate::impact::Impact;
use crate::train::{TrainImpact, latest_next_s};

/// An onset is detected where sound breaks off or sets in again. Impacts this near to a gap, in seconds, are removed.
const EDGE_S: f64 = 0.02;

/// An interval of a recording of which the sound was lost, in seconds, and replaced by silence.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Gap {
    /// Where the sound breaks off.
    pub start_s: f64,
    /// Length of the silence in its place; 0 if the length of the lost sound is unknown.
    pub duration_s: f64,
    /// Whether the lost sound was as long. If not, times after it and before it cannot be compared.
    pub certain: bool,
}

/// Keeps the longest part of a drop without a gap, numbered anew: flight times across a gap are wrong, and the number of
/// impacts in it is unknown. Returns a diagnostic if impacts were removed.
///
/// Silence in place of lost sound is not quiet.
pub(super) fn cut(impacts: &mut Vec<Impact>, gaps: &[Gap]) -> Option<Diagnostic> {
    let lost = cut_at_gaps(impacts, gaps);
    if let Some(first) = impacts.first_mut() {
        let ends_s = gaps.iter().map(|gap| gap.end_s() + EDGE_S);
        let before = ends_s.filter(|end_s| *end_s < first.time_s);
        let since_s = first.time_s - before.fold(f64::NEG_INFINITY, f64::max);
        first.quiet_before_s = first.quiet_before_s.map(|quiet_s| quiet_s.min(since_s));
    }
    lost
}

fn cut_at_gaps(impacts: &mut Vec<Impact>, gaps: &[Gap]) -> Option<Diagnostic> {
    let (first_s, last_s) = (impacts.first()?.time_s, impacts.last()?.time_s);
    let within: Vec<&Gap> = gaps
        .iter()
        .filter(|gap| gap.end_s() + EDGE_S > first_s && gap.start_s - EDGE_S < last_s)
        .collect();
    let gap = within.first()?;
    let all = impacts.len();
    impacts.retain(|impact| within.iter().all(|gap| !gap.is_near(impact.time_s)));
    let longest = impacts
        .chunk_by(|a, b| {
            within
                .iter()
                .all(|gap| !gap.lies_between(a.time_s, b.time_s))
        })
        .rev()
        .max_by_key(|part| part.len());
    *impacts = longest.unwrap_or_default().to_vec();
    let before = impacts.first().map_or(0, |first| first.number - 1);
    for impact in &mut *impacts {
        impact.number -= before;
    }
    Some(
        Diagnostic::new(Code::SoundLost)
            .with("at_s", gap.start_s)
            .with("impacts", all)
            .with("kept", impacts.len()),
    )
}

/// The time after which no more impacts of a drop are expected, in seconds. Impacts in lost sound are not detected, so the
/// wait of [`latest_next_s`] begins anew where the sound sets in again.
///
/// ```
/// use bouncelab::analysis::{Gap, rests_at_s};
/// use bouncelab::onset::Onset;
/// use bouncelab::train;
///
/// let found = train::find(&[0.0, 0.5, 0.9, 1.2, 1.4].map(Onset::click));
/// let impacts = found.trains[0].impacts();
/// let lost = Gap { start_s: 1.5, duration_s: 3.0, certain: true };
/// assert!(rests_at_s(impacts, &[lost]) > rests_at_s(impacts, &[]) + 3.0);
/// ```
pub fn rests_at_s(impacts: &[TrainImpact], gaps: &[Gap]) -> f64 {
    let last_s = impacts.last().map_or(0.0, |impact| impact.onset.time_s);
    let at_s = latest_next_s(impacts);
    let wait_s = at_s - last_s;
    let after = gaps.iter().filter(|gap| gap.end_s() > last_s);
    after.fold(at_s, |at_s, gap| {
        if gap.start_s < at_s {
            at_s.max(gap.end_s() + wait_s)
        } else {
            at_s
        }
    })
}

impl Gap {
    /// Where the sound sets in again.
    pub fn end_s(&self) -> f64 {
        self.start_s + self.duration_s
    }

    fn is_near(&self, time_s: f64) -> bool {
        (self.start_s - EDGE_S..=self.end_s() + EDGE_S).contains(&time_s)
    }

    pub(super) fn lies_between(&self, earlier_s: f64, later_s: f64) -> bool {
        earlier_s < self.end_s() && self.start_s < later_s
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::impacts_of_times;

    /// The times that are left, and where the first gap is.
    fn cut_at(times_s: &[f64], gaps: &[(f64, f64)]) -> (Vec<f64>, Option<f64>) {
        let gaps = gaps.iter().map(|&(start_s, end_s)| Gap {
            start_s,
            duration_s: end_s - start_s,
            certain: true,
        });
        let mut impacts = impacts_of_times(times_s);
        let lost = cut(&mut impacts, &gaps.collect::<Vec<_>>());
        let numbers = impacts.iter().map(|impact| impact.number);
        assert!(numbers.eq(1..=impacts.len()), "numbered anew");
        let at_s = lost.and_then(|lost| lost.number("at_s"));
        (impacts.iter().map(|impact| impact.time_s).collect(), at_s)
    }

    #[test]
    fn no_flight_across_a_gap_is_left() {
        let times_s = [1.0, 1.5, 1.95, 2.355, 2.7195];
        let (left, at_s) = cut_at(&times_s, &[(1.6, 1.7)]);
        assert_eq!(left, times_s[2..]);
        assert_eq!(at_s, Some(1.6));
        // A gap whose length is not known takes no time.
        assert_eq!(cut_at(&times_s, &[(2.5, 2.5)]).0, times_s[..4]);
        // Of equally long parts the first, which is louder.
        assert_eq!(cut_at(&times_s, &[(1.6, 1.7), (2.5, 2.5)]).0, times_s[..2]);
    }

    #[test]
    fn onsets_where_sound_sets_in_again_are_no_impacts() {
        let times_s = [1.0, 1.5, 1.95, 2.355, 2.7195];
        assert_eq!(cut_at(&times_s, &[(2.6, 2.715)]).0, times_s[..4]);
    }

    #[test]
    fn a_gap_elsewhere_changes_nothing() {
        let times_s = [1.0, 1.5, 1.95];
        for gap in [(0.2, 0.8), (2.5, 2.6)] {
            assert_eq!(cut_at(&times_s, &[gap]), (times_s.to_vec(), None));
        }
    }

    #[test]
    fn a_drop_full_of_gaps_has_nothing_left() {
        let (left, at_s) = cut_at(&[1.0, 1.5], &[(0.99, 1.01), (1.49, 1.51)]);
        assert!(left.is_empty() && at_s.is_some());
    }
}
