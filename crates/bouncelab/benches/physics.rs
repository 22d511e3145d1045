//! What the physics costs: `cargo bench -p bouncelab --bench physics`.

use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, Start, Stop};
use bouncelab::regression::{self, NumberedFlight};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::{Impact, restitution};
use bouncelab_testkit::{clift_gauvin, table_tennis};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

/// Bounces in each simulated drop: divide its time by this, or read the items per second.
const BOUNCES: usize = 1000;

/// The laws of the Reynolds number.
fn laws() -> [DragLaw; 2] {
    [DragLaw::Standard, clift_gauvin()]
}

fn main() {
    divan::main();
}

fn contact(restitution: f64) -> Contact {
    Contact::new(Restitution::constant(restitution).unwrap(), 1e-3).unwrap()
}

#[divan::bench(args = laws())]
fn drag_coefficient(bencher: Bencher, law: &DragLaw) {
    bencher.bench_local(|| black_box(law).coefficient(black_box(6000.0)));
}

#[divan::bench]
fn flight_closed_form(bencher: Bencher) {
    let model = table_tennis(DragLaw::Constant(0.4));
    bencher.bench_local(|| black_box(&model).launch(black_box(2.0)));
}

#[divan::bench]
fn flight_from_time_closed_form(bencher: Bencher) {
    let model = table_tennis(DragLaw::Constant(0.4));
    bencher.bench_local(|| black_box(&model).from_flight_time(black_box(0.4)));
}

#[divan::bench]
fn state_closed_form(bencher: Bencher) {
    let model = table_tennis(DragLaw::Constant(0.4));
    let flight = model.launch(2.0).unwrap();
    bencher.bench_local(|| black_box(&model).state(&flight, black_box(0.1)));
}

#[divan::bench(args = laws())]
fn model_by_law(bencher: Bencher, law: &DragLaw) {
    bencher.bench_local(|| table_tennis(black_box(law.clone())));
}

#[divan::bench(args = laws())]
fn flight_by_quadrature(bencher: Bencher, law: &DragLaw) {
    let model = table_tennis(law.clone());
    bencher.bench_local(|| black_box(&model).launch(black_box(2.0)));
}

#[divan::bench(args = laws())]
fn flight_from_time_by_quadrature(bencher: Bencher, law: &DragLaw) {
    let model = table_tennis(law.clone());
    bencher.bench_local(|| black_box(&model).from_flight_time(black_box(0.4)));
}

/// A whole drop of `BOUNCES` bounces, the history included; items are bounces.
#[divan::bench(args = [DragLaw::None, DragLaw::Constant(0.4), DragLaw::Standard])]
fn drop_of_1000_bounces(bencher: Bencher, law: &DragLaw) {
    let model = table_tennis(law.clone());
    let contact = contact(0.999);
    bencher.counter(ItemsCount::new(BOUNCES)).bench_local(|| {
        let start = black_box(Start::Height(0.305));
        drop::simulate(black_box(&model), &contact, start, Stop::after(BOUNCES))
    });
}

#[divan::bench(args = [10, 40])]
fn regression_of_flights(bencher: Bencher, count: usize) {
    let flights: Vec<_> = (1..=count)
        .map(|number| NumberedFlight {
            number,
            time_s: 0.5 * 0.94_f64.powf(number as f64),
        })
        .collect();
    bencher.bench_local(|| regression::fit(black_box(&flights), 9.81));
}

/// Restitution of the 39 inner impacts of a drop with 41; items are impacts.
#[divan::bench(args = [DragLaw::Constant(0.4), DragLaw::Standard])]
fn drag_corrected_restitution(bencher: Bencher, law: &DragLaw) {
    let model = table_tennis(law.clone());
    let history = drop::simulate(
        &model,
        &contact(0.93),
        Start::Height(0.305),
        Stop::after(40),
    )
    .unwrap();
    let impacts: Vec<_> = history
        .impact_events()
        .zip(1..)
        .map(|(event, number)| Impact::new(number, event.time_s).with_time_sd_s(5e-5))
        .collect();
    bencher
        .counter(ItemsCount::new(impacts.len()))
        .bench_local(|| restitution::of_impacts(black_box(&impacts), 1e-3, &model));
}
