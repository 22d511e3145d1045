//! The statistics of many drops, by simulation: intervals hold what they promise.

use bouncelab::groups::{Drop, Factor, Mean, compare, compare_means, drops_needed, outliers};
use bouncelab::inference::Measured;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

const REPEATS: usize = 2000;

struct World(ChaCha8Rng);

impl World {
    fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    fn normal(&mut self, sd: f64) -> f64 {
        let z: f64 = self.0.sample(StandardNormal);
        sd * z
    }

    /// Drops of a ball with this restitution, each with an error of its own between half and twice
    /// the typical one.
    fn drops(&mut self, count: usize, mean: f64, between: f64, own: f64) -> Vec<Measured> {
        (0..count)
            .map(|_| {
                let sd = own * 2_f64.powf(self.0.random_range(-1.0..1.0));
                let value = mean + self.normal(between) + self.normal(sd);
                Measured { value, sd }
            })
            .collect()
    }
}

fn holds([low, high]: [f64; 2], truth: f64) -> bool {
    (low..=high).contains(&truth)
}

fn share(hits: usize) -> f64 {
    hits as f64 / REPEATS as f64
}

/// 95 % intervals of the mean, of the scatter and of the next drop, for few and many drops, with
/// scatter far below, equal to and above the errors. 2000 repeats tell 95 % to 0.5 points; where
/// drops scatter no more than their errors, the interval of the mean is allowed to be wide.
#[test]
fn intervals_of_a_mean_cover() {
    let mut world = World::new(1);
    for count in [3, 5, 20] {
        for between in [0.0, 0.001, 0.004] {
            let (mut of_mean, mut of_scatter, mut of_next) = (0, 0, 0);
            for _ in 0..REPEATS {
                let mean = Mean::of(&world.drops(count, 0.93, between, 0.001)).unwrap();
                of_mean += usize::from(holds(mean.interval95.unwrap(), 0.93));
                of_scatter += usize::from(holds(mean.between95.unwrap(), between));
                let next = 0.93 + world.normal(between);
                of_next += usize::from(holds(mean.next95.unwrap(), next));
            }
            let case = format!("{count} drops, {between} between");
            let covered = share(of_mean);
            // Where drops scatter no more than their errors, it is wide for the sake of few drops.
            let most = if between > 0.002 { 0.985 } else { 1.0 };
            assert!((0.935..=most).contains(&covered), "mean: {covered}, {case}");
            let covered = share(of_scatter);
            assert!(
                (0.935..=0.985).contains(&covered),
                "scatter: {covered}, {case}"
            );
            let covered = share(of_next);
            // Known to be a little narrow for few drops that scatter as much as their errors.
            assert!(covered > 0.90, "next: {covered}, {case}");
        }
    }
}

/// Two groups that scatter differently.
#[test]
fn intervals_of_a_difference_cover_by_welch() {
    let mut world = World::new(2);
    let mut covered = 0;
    for _ in 0..REPEATS {
        let means = [(0.93, 0.001, 12), (0.90, 0.005, 5)]
            .map(|(mean, between, count)| Mean::of(&world.drops(count, mean, between, 0.001)));
        let means = means.map(Result::unwrap);
        let difference = compare_means(&means)[0];
        covered += usize::from(holds(difference.interval95, -0.03));
    }
    assert!(
        (0.935..=0.985).contains(&share(covered)),
        "{}",
        share(covered)
    );
}

/// Balls compared over surfaces that vary more than the balls, in a design with gaps.
#[test]
fn intervals_of_a_difference_cover_over_crossed_factors() {
    const BALLS: [f64; 3] = [0.93, 0.925, 0.94];
    const REPEATS: usize = 300;
    let mut world = World::new(3);
    let factor = |name: &str, levels: usize| Factor {
        name: name.to_owned(),
        levels: (0..levels).map(|level| level.to_string()).collect(),
    };
    let factors = [factor("ball", 3), factor("surface", 4)];
    let mut covered = 0;
    for _ in 0..REPEATS {
        let surfaces = [0; 4].map(|_| world.normal(0.02));
        let mut drops = Vec::new();
        for (ball, mean) in BALLS.into_iter().enumerate() {
            for (surface, shift) in surfaces.into_iter().enumerate() {
                // The last ball never met the last surface.
                let count = if ball + surface == 5 {
                    0
                } else {
                    2 + (ball + surface) % 3
                };
                for measured in world.drops(count, mean + shift, 0.002, 0.001) {
                    let levels = vec![Some(ball), Some(surface)];
                    drops.push(Drop { measured, levels });
                }
            }
        }
        for difference in compare(&drops, &factors, 0, &[1]).unwrap() {
            let truth = BALLS[difference.of] - BALLS[difference.less];
            covered += usize::from(holds(difference.interval95, truth));
        }
    }
    let covered = covered as f64 / (3 * REPEATS) as f64;
    assert!((0.925..=0.975).contains(&covered), "{covered}");
}

/// The promise of the plan: with so many drops the interval is about as narrow as was wanted.
#[test]
fn the_planned_number_of_drops_suffices() {
    let mut world = World::new(4);
    let wanted = 0.001;
    let pilot = Mean::of(&world.drops(400, 0.93, 0.003, 0.001)).unwrap();
    let needed = drops_needed(&pilot, wanted).unwrap();
    let mut widths = 0.0;
    for _ in 0..200 {
        let mean = Mean::of(&world.drops(needed, 0.93, 0.003, 0.001)).unwrap();
        let [low, high] = mean.interval95.unwrap();
        widths += 0.5 * (high - low) / 200.0;
    }
    assert!((0.85..1.15).contains(&(widths / wanted)), "{widths}");
}

/// Twenty good drops: one in a few hundred is named. With one wrong ball among them, it is.
#[test]
fn outliers_are_named_and_good_drops_seldom() {
    const REPEATS: usize = 500;
    let mut world = World::new(5);
    let (mut falsely, mut found) = (0, 0);
    for _ in 0..REPEATS {
        let mut drops = world.drops(20, 0.93, 0.002, 0.001);
        falsely += outliers(&drops, &[0; 20]).len();
        drops[7].value = 0.90;
        let named = outliers(&drops, &[0; 20]);
        found += usize::from(named.first().is_some_and(|outlier| outlier.drop == 7));
    }
    assert!(falsely < 20 * REPEATS / 100, "{falsely}");
    assert_eq!(found, REPEATS);
}
