//! Sound that was lost, and what of a drop can be trusted in spite of it.

use bouncelab::analysis::Impact;

/// Where sound breaks off or sets in again, something is heard that is no impact: impacts this
/// near to a gap, in seconds, are not believed.
const EDGE_S: f64 = 0.02;

/// The gaps in the sound so far.
#[derive(Default)]
pub(super) struct Gaps {
    gaps: Vec<Gap>,
    frames: u64,
}

/// A stretch without sound, in seconds of the recording.
struct Gap {
    from_s: f64,
    to_s: f64,
}

impl Gaps {
    /// Notes that so many frames were lost; the stretch is what stands for them.
    pub(super) fn note(&mut self, from_s: f64, to_s: f64, frames: u64) {
        self.frames += frames;
        self.gaps.push(Gap { from_s, to_s });
    }

    /// How often sound was lost.
    pub(super) fn count(&self) -> usize {
        self.gaps.len()
    }

    /// How many frames were lost, as far as is known.
    pub(super) fn frames(&self) -> u64 {
        self.frames
    }

    /// Keeps of a drop the longest part without a gap, numbered anew. How long a gap really
    /// was is not known well enough for physics: no flight across it is right, nor is the number
    /// of impacts in it. Returns what was left out, in words.
    pub(super) fn cut(&self, impacts: &mut Vec<Impact>) -> Option<String> {
        let (first_s, last_s) = (impacts.first()?.time_s, impacts.last()?.time_s);
        let within: Vec<&Gap> = self
            .gaps
            .iter()
            .filter(|gap| gap.to_s + EDGE_S > first_s && gap.from_s - EDGE_S < last_s)
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
        Some(format!(
            "sound was lost at {:.2} s: no flight across a gap is used, and of {all} impacts the \
             {} of the longest part without one",
            gap.from_s,
            impacts.len()
        ))
    }
}

impl Gap {
    fn is_near(&self, time_s: f64) -> bool {
        (self.from_s - EDGE_S..=self.to_s + EDGE_S).contains(&time_s)
    }

    fn lies_between(&self, earlier_s: f64, later_s: f64) -> bool {
        earlier_s < self.from_s && self.to_s < later_s
    }
}

#[cfg(test)]
mod tests {
    use bouncelab::analysis;

    use super::*;

    /// The times that are left, and the words.
    fn cut(times_s: &[f64], gaps: &[(f64, f64)]) -> (Vec<f64>, Option<String>) {
        let mut all = Gaps::default();
        for &(from_s, to_s) in gaps {
            all.note(from_s, to_s, 100);
        }
        let mut impacts = analysis::impacts_of_times(times_s);
        let words = all.cut(&mut impacts);
        let numbers = impacts.iter().map(|impact| impact.number);
        assert!(numbers.eq(1..=impacts.len()), "numbered anew");
        (impacts.iter().map(|impact| impact.time_s).collect(), words)
    }

    #[test]
    fn no_flight_across_a_gap_is_left() {
        let times_s = [1.0, 1.5, 1.95, 2.355, 2.7195];
        let (left, words) = cut(&times_s, &[(1.6, 1.7)]);
        assert_eq!(left, times_s[2..]);
        assert!(words.is_some_and(|words| words.contains("1.60 s")));
        // A gap whose length is not known takes no time.
        assert_eq!(cut(&times_s, &[(2.5, 2.5)]).0, times_s[..4]);
        // Of equally long parts the first, which is louder.
        assert_eq!(cut(&times_s, &[(1.6, 1.7), (2.5, 2.5)]).0, times_s[..2]);
    }

    #[test]
    fn what_sounds_where_sound_sets_in_again_is_no_impact() {
        let times_s = [1.0, 1.5, 1.95, 2.355, 2.7195];
        assert_eq!(cut(&times_s, &[(2.6, 2.715)]).0, times_s[..4]);
    }

    #[test]
    fn a_gap_elsewhere_changes_nothing() {
        let times_s = [1.0, 1.5, 1.95];
        for gap in [(0.2, 0.8), (2.5, 2.6)] {
            assert_eq!(cut(&times_s, &[gap]), (times_s.to_vec(), None));
        }
    }

    #[test]
    fn a_drop_full_of_gaps_has_nothing_left() {
        let (left, words) = cut(&[1.0, 1.5], &[(0.99, 1.01), (1.49, 1.51)]);
        assert!(left.is_empty());
        assert!(words.is_some());
    }
}
