//! Text figures: a level meter, and the flights of a drop.

/// The eighths of a block, from the bottom and from the left.
const RISING: [char; 9] = [' ', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
const GROWING: [char; 9] = [' ', '▏', '▎', '▍', '▌', '▋', '▊', '▉', '█'];

/// The level below which the meter shows nothing, in dB relative to full scale.
const QUIETEST_DB: f64 = -60.0;
const METER_WIDTH: usize = 30;

/// A bar for a level in dB relative to full scale.
pub(super) fn meter(level_db: f64) -> String {
    let share = ((level_db - QUIETEST_DB) / -QUIETEST_DB).clamp(0.0, 1.0);
    let eighths = (share * (METER_WIDTH * 8) as f64).round() as usize;
    (0..METER_WIDTH)
        .map(|cell| GROWING[eighths.saturating_sub(cell * 8).min(8)])
        .collect()
}

/// The shortest flight that is drawn, in seconds: its bar has no height.
const SHORTEST_S: f64 = 0.01;
/// The flight at the top, in seconds.
const LONGEST_S: f64 = 1.0;
/// Rows of the figure.
const ROWS: usize = 4;

/// The flight times of a drop as bars on a logarithmic scale, on which those of a ball fall in a
/// straight line; a flight that was not measured leaves a gap. At most the last `width` flights.
///
/// Each flight is its number, from 1, and its time in seconds.
pub(super) fn flights(flights: &[(usize, f64)], width: usize) -> Vec<String> {
    let last = flights.last().map_or(0, |&(number, _)| number);
    let first = last.saturating_sub(width) + 1;
    let mut eighths = vec![0; (last + 1).saturating_sub(first)];
    for &(number, time_s) in flights.iter().filter(|(number, _)| *number >= first) {
        eighths[number - first] = height(time_s);
    }
    (0..ROWS)
        .rev()
        .map(|row| {
            let bars = eighths
                .iter()
                .map(|&eighths| RISING[eighths.saturating_sub(row * 8).min(8)]);
            let label = match row {
                0 => format!("{:.0} ms", 1e3 * SHORTEST_S),
                1 => "flight".to_owned(),
                row if row == ROWS - 1 => format!("{LONGEST_S:.0} s"),
                _ => String::new(),
            };
            let line = format!("{label:>6} │{}", bars.collect::<String>());
            line.trim_end().to_owned()
        })
        .collect()
}

/// The height of a bar in eighths of a row; a flight that was measured is always visible.
fn height(time_s: f64) -> usize {
    let share = (time_s / SHORTEST_S).ln() / (LONGEST_S / SHORTEST_S).ln();
    ((share * (ROWS * 8) as f64).round() as usize).clamp(1, ROWS * 8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_meter_spans_sixty_decibels() {
        assert_eq!(meter(f64::NEG_INFINITY).trim(), "");
        assert_eq!(meter(-60.0).trim(), "");
        assert_eq!(meter(-30.0).trim_end(), "█".repeat(15));
        // A quarter of a cell is half a decibel.
        assert_eq!(meter(-29.5).trim_end(), format!("{}▎", "█".repeat(15)));
        assert_eq!(meter(0.0), "█".repeat(METER_WIDTH));
        assert_eq!(meter(f64::NAN).chars().count(), METER_WIDTH);
    }

    #[test]
    fn flights_fall_in_a_straight_line() {
        // Two rows, sixteen eighths, are a decade, so a tenth of one is 1.6 eighths: the heights
        // are 32, 30, 29, 27, 26, 24 and so on; the last would be 0.
        let times: Vec<(usize, f64)> = (1..=21)
            .map(|number| (number, 10_f64.powf(-0.1 * (number - 1) as f64)))
            .collect();
        let figure = flights(&times, 40);
        assert_eq!(
            figure,
            [
                "   1 s │█▆▅▃▂",
                "       │██████▆▅▃▂",
                "flight │███████████▆▅▃▂",
                " 10 ms │████████████████▆▅▃▂▁",
            ]
            .map(str::to_owned)
        );
    }

    #[test]
    fn an_unknown_flight_leaves_a_gap_and_old_ones_leave_the_figure() {
        let figure = flights(&[(1, 0.5), (2, 0.4), (4, 0.3), (5, 1e-9)], 4);
        assert_eq!(figure[3], " 10 ms │█ █▁");
        assert!(flights(&[], 10).iter().all(|row| row.ends_with('│')));
    }
}
