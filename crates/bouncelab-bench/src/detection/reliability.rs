//! Whether the probability stated for a drop is the share of such drops that are real.

use bouncelab::train::Train;

/// The least probability of each class, and its name.
const CLASSES: [(f64, &str); 4] = [
    (0.0, "to 0.7"),
    (0.7, "0.7 to 0.9"),
    (0.9, "0.9 to 0.99"),
    (0.99, "above 0.99"),
];

/// How many drops of each class there were, and how many of them were real.
#[derive(Default)]
pub(crate) struct Reliability([Class; CLASSES.len()]);

#[derive(Clone, Copy, Default)]
struct Class {
    drops: usize,
    real: usize,
}

impl Reliability {
    /// Counts a drop with this number of real impacts; the drop is real if at least half of its impacts are.
    pub(crate) fn add(&mut self, train: &Train, real_impacts: usize) {
        let probability = train.probability();
        let class = CLASSES.iter().rposition(|(least, _)| probability >= *least);
        let class = &mut self.0[class.unwrap_or(0)];
        class.drops += 1;
        class.real += usize::from(2 * real_impacts >= train.impacts().len());
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
