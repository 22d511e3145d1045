//! A ball, air and a surface become flights, and the flights a result: the round trip without sound.
//! `cargo run --release --example simulate`.

#![expect(clippy::print_stdout, reason = "it prints for contributors")]

use bouncelab::drop::{self, Start, Stop};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::{Options, Result, analyze_times, ball};

fn main() -> Result<()> {
    let options = Options::new(ball::preset("table-tennis-40")?);
    let contact = Contact::new(Restitution::constant(0.93)?, options.contact_time_s)?;
    let start = Start::Height(0.305);
    let history = drop::simulate(&options.model()?, &contact, start, Stop::after(12))?;

    println!("bounce   time (s)   apex (cm)   speed (m/s)");
    for (number, bounce) in (1..).zip(history.bounces()) {
        let apex_cm = 100.0 * bounce.flight.apex_m;
        println!(
            "{number:6} {:10.4} {apex_cm:11.2} {:13.3}",
            bounce.time_s, bounce.impact_speed_m_s
        );
    }

    let times_s: Vec<f64> = history.impact_events().map(|event| event.time_s).collect();
    for drop in analyze_times(&times_s, &options).drops {
        println!(
            "log-linear fit: e = {:.4}",
            drop.log_linear_fit?.restitution.value
        );
        println!(
            "with the air:  e = {:.4}",
            drop.posterior?.restitution.value
        );
    }
    Ok(())
}
