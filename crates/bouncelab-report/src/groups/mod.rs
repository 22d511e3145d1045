//! Many drops together: the study of groups as tables, figures and a page.
//!
//! The caller passes what each drop adds to a study and what was noted of it ([`NotedDrop`]); the program
//! takes them from recordings, the page from the table of drops.
//!
//! ```
//! use std::collections::BTreeMap;
//!
//! use bouncelab::groups::CurveEvidence;
//! use bouncelab::inference::Measured;
//! use bouncelab_report::groups::{About, GroupStudy, NotedDrop, Question, tables};
//! use bouncelab_report::messages::Translator;
//!
//! let noted: Vec<BTreeMap<String, String>> = ["golf", "tennis"]
//!     .map(|ball| BTreeMap::from([("ball".to_owned(), ball.to_owned())]))
//!     .into();
//! let drops = [(0, 0.82), (0, 0.84), (1, 0.73), (1, 0.74)].map(|(of, value)| NotedDrop {
//!     name: format!("e = {value}").into(),
//!     factors: &noted[of],
//!     evidence: CurveEvidence::measured(&[(1.0, Measured { value, sd: 0.002 })]),
//!     scatter: None,
//! });
//! let translator = Translator::english();
//! let groups = GroupStudy::of(About::default(), drops.into(), &Question::default(), &translator)?;
//! let study = groups.study.as_ref().unwrap();
//! let table = tables::group_table(&groups, study, None, &translator).to_string();
//! let golf = table.lines().find(|line| line.starts_with("golf")).unwrap();
//! assert!(golf.contains("0.83"), "{table}");
//! # Ok::<(), bouncelab_report::groups::UnknownField>(())
//! ```

mod figures;
mod page;
mod study;
pub mod tables;

pub use figures::figures;
pub use page::{page, some_of};
pub use study::{About, GroupStudy, NotedDrop, Parts, Question, Reason, StudyParts, UnknownField};
