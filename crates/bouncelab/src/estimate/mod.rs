//! scaffold

mod fit;
mod knowledge;
mod likelihood;
mod model;
mod observed;
mod posterior;
mod sample;
mod summary;

pub use knowledge::{Knowledge, LawKind, Measured, UNKNOWN};
pub use posterior::Effort;
pub use sample::GREATEST_PARETO_SHAPE;
pub use summary::Summary;

use crate::ball::Ball;
use crate::error::Result;
use crate::flight::Environment;
use crate::restitution::TimedImpact;
use likelihood::Evaluator;
use posterior::Posterior;

#[doc(hidden)]
#[derive(Debug)]
pub struct Proto {
    pub e: Vec<f64>,
    pub h: Vec<f64>,
    pub cd: Vec<f64>,
    pub k: Vec<f64>,
    pub pareto: f64,
    pub ess: f64,
    pub models: Vec<(String, usize, f64, f64)>,
    pub scatter: Vec<f64>,
}

#[doc(hidden)]
pub fn proto(
    impacts: &[TimedImpact],
    ball: &Ball,
    environment: &Environment,
    contact_time_s: f64,
    knowledge: &Knowledge,
    effort: &Effort,
) -> Result<Proto> {
    let post = Posterior::new(impacts, ball, environment, contact_time_s, knowledge, effort)?;
    let mut proto = Proto {
        e: vec![],
        h: vec![],
        cd: vec![],
        k: vec![],
        scatter: vec![],
        pareto: post.pareto_shape(),
        ess: post.effective_draws(),
        models: post
            .candidates
            .iter()
            .map(|c| {
                (
                    format!("{} {}", c.law, post.surroundings[c.surroundings].drag_law),
                    c.missed_first,
                    c.weight,
                    c.sample.as_ref().map_or(f64::NAN, |s| s.pareto_shape),
                )
            })
            .collect(),
    };
    let models: Vec<_> = post.candidates.iter().map(|c| post.model(c)).collect();
    let mut evs: Vec<_> = models.iter().map(Evaluator::new).collect();
    for d in &post.draws {
        let p = models[d.candidate].point(d.vector.as_slice()).unwrap();
        let g = p.gravity_m_s2;
        let t = evs[d.candidate].table(p.drag_strength);
        let (h, _, _) = t.fall(p.fall_launch_m_s).unwrap();
        proto.h.push(h / g);
        proto.e.push(p.law.at(post.middle.speed_m_s));
        proto.cd.push(p.drag_scale);
        proto.scatter.push(p.scatter);
        proto.k.push(models[d.candidate].missed_first as f64);
    }
    Ok(proto)
}
