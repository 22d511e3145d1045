//! bouncelab for Python: the module `bouncelab._core`.
//!
//! The package in `python/` is what people see: typed and documented. What crosses over is plain: settings
//! and results as JSON (the schema `bouncelab.analysis/3`), tables as columns and as streams of Arrow, numbers as bytes.
//! Whatever takes long runs without the lock of the interpreter, and asks between two steps whether to go on.
//! Whoever calls has the threads; those of a session end before it returns, so that the module is safe after
//! a fork.
//!
//! | module | question it answers |
//! |---|---|
//! | `failure` | which exception is it? |
//! | `watch` | shall the work go on? |
//! | `samples` | how do arrays become samples? |
//! | `table` | how does a table cross over? |
//! | `chart` | how is a figure drawn? |
//! | `analyzer` | what does sound say, or a list of times? |
//! | `detector` | what does sound say that is still coming? |
//! | `recording` | what is there to know of a result? |
//! | `physics` | what do the formulas give? |
//! | `simulation` | what would a drop do, and how would it sound? |
//! | `session` | what do many recordings say together? |
//! | `batch` | how does an engine analyse recordings, and what do its results say? |
//! | `program` | how is the program run in this process? |
//! | `verdict` | does a ball or a floor obey a rule? |

#![forbid(unsafe_code)]
#![allow(missing_debug_implementations, reason = "Python shows its own objects")]
#![allow(
    clippy::needless_pass_by_value,
    reason = "what Python hands over is converted into values"
)]

mod analyzer;
mod batch;
mod chart;
mod detector;
mod failure;
mod output;
mod page;
mod physics;
#[cfg(not(target_family = "wasm"))]
mod program;
mod recording;
mod samples;
mod session;
mod simulation;
mod table;
mod verdict;
mod watch;

#[pyo3::pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::analyzer::Analyzer;
    #[pymodule_export]
    use super::batch::{Kernel, Results, StudySums, batch_of_rows, endings};
    #[pymodule_export]
    use super::chart::{Chart, colour};
    #[pymodule_export]
    use super::detector::Detector;
    #[pymodule_export]
    use super::output::write_file;
    #[pymodule_export]
    use super::page::Page;
    #[pymodule_export]
    use super::physics::{
        air, balls, code_names, drag_coefficient, drag_laws, falls, flights, gravity_m_s2,
        languages, message, require_known, restitution_laws, setting_names, terminal_speed_m_s,
    };
    #[cfg(not(target_family = "wasm"))]
    #[pymodule_export]
    use super::program::run_program;
    #[pymodule_export]
    use super::recording::Recording;
    #[pymodule_export]
    use super::session::{Session, SessionWork};
    #[pymodule_export]
    use super::simulation::{Simulation, write_wav};
    #[pymodule_export]
    use super::table::{Arrow, Table};
    #[pymodule_export]
    use super::verdict::{Judge, Verdict, rules_built_in};

    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name is that of Python modules")]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    #[pymodule_init]
    #[expect(clippy::unnecessary_wraps, reason = "the type is that of PyO3")]
    fn init(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        bouncelab_audio::silence_contained_panics();
        Ok(())
    }
}
