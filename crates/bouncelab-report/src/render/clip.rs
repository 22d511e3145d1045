//! Clips curves to the parts that are drawn: those within a frame, and those between the gaps of a dashed line.

/// A position in the drawing, in figure pixels from the upper left corner.
pub(super) type Position = (f64, f64);

/// A rectangle in the drawing, in figure pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rect {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Rect {
    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn height(&self) -> f64 {
        self.bottom - self.top
    }
}

/// Lengths of the strokes and gaps of a line, in figure pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Dash {
    pub(super) stroke: f64,
    pub(super) gap: f64,
}

/// Whether both coordinates are numbers.
pub(super) fn is_finite((x, y): Position) -> bool {
    x.is_finite() && y.is_finite()
}

/// The parts of a curve inside a rectangle. Cut here and not by the library, which would need
/// names for the regions that are then not unique on a page with several figures.
pub(super) fn within(rect: Rect, points: &[Position]) -> Vec<Vec<Position>> {
    let mut pieces: Vec<Vec<Position>> = Vec::new();
    let mut open = false;
    for pair in points.windows(2) {
        let Some([from, to]) = segment_within(rect, pair[0], pair[1]) else {
            open = false;
            continue;
        };
        match pieces.last_mut() {
            Some(piece) if open => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
        open = to == pair[1];
    }
    pieces
}

/// The part of a segment inside a rectangle (Liang and Barsky 1984).
fn segment_within(rect: Rect, from: Position, to: Position) -> Option<[Position; 2]> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut start, mut end) = (0.0_f64, 1.0_f64);
    for (run, distance) in [
        (-dx, from.0 - rect.left),
        (dx, rect.right - from.0),
        (-dy, from.1 - rect.top),
        (dy, rect.bottom - from.1),
    ] {
        if run == 0.0 {
            if distance < 0.0 {
                return None;
            }
        } else if run < 0.0 {
            start = start.max(distance / run);
        } else {
            end = end.min(distance / run);
        }
    }
    let at = |share: f64| match share {
        0.0 => from,
        1.0 => to,
        _ => (from.0 + share * dx, from.1 + share * dy),
    };
    (start <= end).then(|| [at(start), at(end)])
}

/// The strokes that make a dashed line along the points.
pub(super) fn dashes(points: &[Position], dash: Dash) -> Vec<Vec<Position>> {
    let mut pieces = Vec::new();
    let mut piece: Vec<Position> = points.first().copied().into_iter().collect();
    let mut drawing = true;
    let mut left = dash.stroke;
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        let mut length = (to.0 - from.0).hypot(to.1 - from.1);
        while length > left {
            let share = left / length;
            from = (
                from.0 + share * (to.0 - from.0),
                from.1 + share * (to.1 - from.1),
            );
            length -= left;
            if drawing {
                piece.push(from);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![from];
            }
            drawing = !drawing;
            left = if drawing { dash.stroke } else { dash.gap };
        }
        left -= length;
        if drawing {
            piece.push(to);
        }
    }
    pieces.push(piece);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_run_on_across_the_points_of_a_curve() {
        let dash = Dash {
            stroke: 6.0,
            gap: 4.0,
        };
        // The same 30-pixel line, as one segment and as thirty.
        let coarse = dashes(&[(0.0, 0.0), (30.0, 0.0)], dash);
        let fine: Vec<Position> = (0..=30).map(|x| (f64::from(x), 0.0)).collect();
        let ends = |pieces: &[Vec<Position>]| -> Vec<(f64, f64)> {
            pieces
                .iter()
                .filter(|piece| piece.len() > 1)
                .map(|piece| (piece[0].0, piece[piece.len() - 1].0))
                .collect()
        };
        assert_eq!(ends(&coarse), [(0.0, 6.0), (10.0, 16.0), (20.0, 26.0)]);
        assert_eq!(ends(&dashes(&fine, dash)), ends(&coarse));
    }

    #[test]
    fn curves_end_at_the_frame_and_come_back() {
        let rect = Rect {
            left: 0.0,
            top: 0.0,
            right: 10.0,
            bottom: 10.0,
        };
        // In, out above, and in again; then a segment that passes outside a corner.
        let points = [
            (0.0, 5.0),
            (5.0, -5.0),
            (10.0, 5.0),
            (15.0, 5.0),
            (5.0, 16.0),
        ];
        let pieces = within(rect, &points);
        assert_eq!(
            pieces,
            [
                vec![(0.0, 5.0), (2.5, 0.0)],
                vec![(7.5, 0.0), (10.0, 5.0), (10.0, 5.0)],
            ]
        );
    }
}
