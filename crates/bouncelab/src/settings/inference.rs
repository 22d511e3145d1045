//! The inference: laws, priors, questions and sampling.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use super::plausibility::{Ordinary, reading, shown};
use crate::analysis::Options;
use crate::drag::DragLaw;
use crate::error::{Quantity, within};
use crate::inference::{ApexTarget, InferenceOptions, Priors, SamplerConfig, UNKNOWN};
use crate::restitution::LawKind;
use crate::{Error, Result};

/// How many draws an inference may aim at: fewer do not show the tails, more take minutes.
const DRAWS: RangeInclusive<usize> = 100..=100_000;

/// What is given of the inference, and what it is asked.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct InferenceSettings {
    /// Whether to run the inference; `true` if left out.
    pub enabled: Option<bool>,
    /// Families of restitution laws to consider; all that the impacts can distinguish if left out.
    pub restitution_laws: Option<Vec<String>>,
    /// What is known of the restitution over the impact speed, as in `normal:0.5=0.93:0.01,3=0.86:0.02`, the text of a
    /// [`RestitutionPrior`](crate::restitution::RestitutionPrior); anything from 0 to 1 if left out.
    pub restitution_prior: Option<String>,
    /// Inputs of which nothing is known: the data decide.
    pub infer: Option<Vec<Inferred>>,
    /// How well inputs are known, as relative standard uncertainties; that of a ball and of air that nobody measured
    /// if left out.
    pub known: Option<BTreeMap<Input, f64>>,
    /// Impact speed at which to state the restitution; the middle of those detected if left out.
    pub at_speed_m_s: Option<f64>,
    /// Bounces of which to predict the drop height that makes them reach an apex.
    pub reach: Option<Vec<ApexTarget>>,
    /// Independent draws of the posterior to aim at, 100 to 100,000; 1,000 if left out.
    pub draws: Option<usize>,
    /// Seed of the random numbers; 1 if left out.
    pub seed: Option<u64>,
}

/// Ordinary values.
pub(super) const ORDINARY: &[Ordinary] = &[
    Ordinary {
        quantity: "impact-speed",
        given: |settings| settings.inference.at_speed_m_s,
        // From impacts that nobody hears to a fall of 100 m.
        range: 0.001..=50.0,
        shown: shown("m/s"),
        readings: &[reading(0.01, "cm/s"), reading(0.001, "mm/s")],
    },
    Ordinary {
        quantity: "apex",
        given: |settings| {
            let apexes = settings.inference.reach.iter().flatten();
            apexes.map(|target| target.apex_m).max_by(f64::total_cmp)
        },
        range: 0.001..=10.0,
        shown: shown("m"),
        readings: &[reading(0.01, "cm"), reading(0.001, "mm")],
    },
];

macro_rules! inputs {
    ($(#[$meta:meta])+ $type:ident { $($(#[$doc:meta])+ $variant:ident = $name:literal;)+ }) => {
        $(#[$meta])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
        pub enum $type {
            $($(#[$doc])+ #[cfg_attr(feature = "serde", serde(rename = $name))] $variant,)+
        }

        impl $type {
            /// Every one.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Its name, as in settings.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)+ }
            }
        }
    };
}

inputs! {
    /// An input that may be left to the data, as if nothing were known of it.
    Inferred {
        /// The acceleration of gravity. The first impact detected is then the first impact.
        Gravity = "gravity";
        /// The drag coefficient.
        Drag = "drag";
        /// The contact time.
        ContactTime = "contact-time";
    }
}

inputs! {
    /// An input whose uncertainty may be given.
    Input {
        /// Mass of the ball.
        Mass = "mass";
        /// Diameter of the ball.
        Diameter = "diameter";
        /// Density of the air.
        AirDensity = "air-density";
        /// Gravity.
        Gravity = "gravity";
        /// Added mass of the air.
        AddedMass = "added-mass";
        /// Drag coefficient, around its law.
        Drag = "drag";
        /// Contact time.
        ContactTime = "contact-time";
        /// The stated errors of the impact times, as a common factor.
        Timing = "timing";
        /// Typical scatter of restitution from impact to impact on this surface.
        Scatter = "scatter";
        /// Width of the prior of the scatter over the usual width; 0 takes the typical scatter as exact.
        ScatterSpread = "scatter-spread";
        /// Losses of slow impacts beyond the law; 0 lets restitution follow its law until rest.
        SlowLosses = "slow-losses";
    }
}

impl Inferred {
    const fn input(self) -> Input {
        match self {
            Self::Gravity => Input::Gravity,
            Self::Drag => Input::Drag,
            Self::ContactTime => Input::ContactTime,
        }
    }
}

impl Input {
    fn of(self, priors: &mut Priors) -> &mut f64 {
        match self {
            Self::Mass => &mut priors.mass_rel_sd,
            Self::Diameter => &mut priors.diameter_rel_sd,
            Self::AirDensity => &mut priors.air_density_rel_sd,
            Self::Gravity => &mut priors.gravity_rel_sd,
            Self::AddedMass => &mut priors.added_mass_rel_sd,
            Self::Drag => &mut priors.drag_rel_sd,
            Self::ContactTime => &mut priors.contact_time_rel_sd,
            Self::Timing => &mut priors.timing_rel_sd,
            Self::Scatter => &mut priors.restitution_scatter,
            Self::ScatterSpread => &mut priors.scatter_spread,
            Self::SlowLosses => &mut priors.slow_loss_exponent,
        }
    }
}

impl InferenceSettings {
    /// The laws to consider, and how well the inputs are known.
    pub(super) fn inform(&self, priors: &mut Priors) -> Result<()> {
        let laws = self.restitution_laws.iter().flatten();
        priors.restitution_laws = laws.map(|law| law.parse()).collect::<Result<_>>()?;
        priors.restitution = self
            .restitution_prior
            .as_ref()
            .map(|prior| prior.parse())
            .transpose()?;
        let other = priors
            .restitution_laws
            .iter()
            .find(|&&law| law != LawKind::Smooth);
        if let (Some(_), Some(law)) = (&priors.restitution, other) {
            let law = format!("restitution law {law}");
            return Err(Error::contradiction("restitution prior", &law));
        }
        for inferred in self.infer.iter().flatten() {
            *inferred.input().of(priors) = UNKNOWN;
        }
        for (input, &share) in self.known.iter().flatten() {
            *input.of(priors) = share;
        }
        Ok(())
    }

    /// An input cannot be left to the data if its uncertainty is given, or if the model does not depend on it.
    pub(super) fn check_against(&self, options: &Options) -> Result<()> {
        let inferred = self.infer.as_deref().unwrap_or_default();
        let contradiction = |inferred: Inferred, other: &str| {
            let name = inferred.name();
            Err(Error::contradiction(&format!("infer {name}"), other))
        };
        for &of in inferred {
            let known = self.known.as_ref();
            if known.is_some_and(|known| known.contains_key(&of.input())) {
                return contradiction(of, &format!("known {}", of.input().name()));
            }
        }
        let environment = &options.environment;
        let no_drag = environment.drag == DragLaw::None || environment.air.is_vacuum();
        if no_drag && inferred.contains(&Inferred::Drag) {
            return contradiction(Inferred::Drag, "no drag at all (drag none, air density 0)");
        }
        if options.contact_time_s == 0.0 && inferred.contains(&Inferred::ContactTime) {
            return contradiction(Inferred::ContactTime, "a contact time of exactly 0");
        }
        Ok(())
    }

    pub(super) fn resolve(&self) -> Result<Option<InferenceOptions>> {
        let usual = SamplerConfig::default();
        let sampler = SamplerConfig {
            draws: self.draws.unwrap_or(usual.draws),
            seed: self.seed.unwrap_or(usual.seed),
        };
        let draws = *DRAWS.start() as f64..=*DRAWS.end() as f64;
        within(Quantity::Draws, sampler.draws as f64, draws)?;
        let options = InferenceOptions {
            at_speed_m_s: self.at_speed_m_s,
            reach: self.reach.clone().unwrap_or_default(),
            sampler,
            each_impact: true,
        };
        Ok((self.enabled != Some(false)).then_some(options))
    }
}
