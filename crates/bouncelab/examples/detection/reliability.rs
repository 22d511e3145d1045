//! Whether the probability stated for a drop is the share of such drops that are real.

use bouncelab::train::Train;

/// The least probability of each class; a drop of less than the first is not reported.
const CLASSES: [(f64, &str); 4] = [
    (0.0, "to 0.7"),
    (0.7, "0.7 to 0.9"),
    (0.9, "0.9 to 0.99"),
    (0.99, "above 0.99"),
];

/// A drop is real if this share of its impacts is.
const REAL_SHARE: f64 = 0.5;

/// How many drops of each class there were, and how many of them were real.
#[derive(Default)]
pub(crate) struct Reliability([Class; CLASSES.len()]);

#[derive(Clone, Copy, Default)]
struct Class {
    drops: usize,
    real: usize,
}

impl Reliability {
    /// Counts a drop of whose impacts so many are real.
    pub(crate) fn add(&mut self, train: &Train, real_impacts: usize) {
        let probability = train.probability();
        let class = CLASSES.iter().rposition(|(least, _)| probability >= *least);
        let class = &mut self.0[class.unwrap_or(0)];
        class.drops += 1;
        class.real += usize::from(real_impacts as f64 >= REAL_SHARE * train.impacts().len() as f64);
    }

    pub(crate) fn print(&self, of: &str) {
        let names = CLASSES.map(|(_, name)| name).join(" | ");
        let counts = self
            .0
            .map(|class| format!("{} of {}", class.real, class.drops));
        println!("\n| probability | {names} |\n|---|---|---|---|---|");
        println!("| {of} | {} |", counts.join(" | "));
    }
}
