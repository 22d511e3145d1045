//! Writes what the engine takes and gives as TypeScript, to the standard output.
//!
//! `cargo xtask web` runs it: the page is compiled against what the engine really gives.

#![expect(clippy::print_stdout, reason = "it prints for contributors")]

use std::any::TypeId;
use std::collections::{BTreeMap, HashSet};

use bouncelab::Recording;
use bouncelab::analysis::{CONFIDENT_PROBABILITY, Gap};
use bouncelab::diagnostic::Argument;
use bouncelab_audio::{SoundFormat, times};
use bouncelab_report::Chart;
use bouncelab_report::csv::FORMULA_SIGNS;
use bouncelab_report::document::simulation;
use bouncelab_report::job::MAX_NUMBER;
use bouncelab_report::link::{DropLink, LinkedDrop};
use bouncelab_report::paper;
use bouncelab_report::paper::lesson::{PuzzleAnswer, PuzzleChoice};
use bouncelab_wasm::refusal::Refusal;
use bouncelab_wasm::wire;
use ts_rs::{Config, TS, TypeVisitor};

const HEAD: &str = "\
// What the engine takes and gives, from the types in Rust. `cargo xtask web` makes this file.
";

/// Declares types and all that they are made of.
struct Declarations {
    config: Config,
    seen: HashSet<TypeId>,
    /// By name: the order in which types are found changes from build to build.
    found: BTreeMap<String, String>,
}

impl Declarations {
    fn declare<T: TS + 'static + ?Sized>(&mut self) {
        if !self.seen.insert(TypeId::of::<T>()) {
            return;
        }
        T::visit_dependencies(self);
        T::visit_generics(self);
        // Lists and the like have no name of their own.
        if T::output_path().is_none() {
            return;
        }
        let docs = T::docs().unwrap_or_default();
        let declaration = T::decl(&self.config);
        let text = ["\n", &docs, "export ", &declaration, "\n"].concat();
        self.found.insert(T::ident(&self.config), text);
    }
}

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        self.declare::<T>();
    }
}

fn declarations() -> String {
    let mut all = Declarations {
        config: Config::new().with_large_int("number"),
        seen: HashSet::new(),
        found: BTreeMap::new(),
    };
    all.declare::<Refusal>();
    all.declare::<wire::Catalogue>();
    all.declare::<Recording>();
    all.declare::<Argument>();
    all.declare::<Gap>();
    all.declare::<wire::SoFar>();
    all.declare::<wire::Demo>();
    all.declare::<wire::AnalysisRequest>();
    all.declare::<wire::Analysed<'static>>();
    all.declare::<wire::Drawn>();
    all.declare::<LinkedDrop>();
    all.declare::<DropLink>();
    all.declare::<wire::StudyRequest>();
    all.declare::<wire::Studied>();
    all.declare::<wire::RuleChoice>();
    all.declare::<wire::VerdictRequest>();
    all.declare::<wire::Judged>();
    all.declare::<wire::ReboundRequest>();
    all.declare::<wire::NewJob>();
    all.declare::<wire::JobChange>();
    all.declare::<wire::JobShown>();
    all.declare::<wire::SimulationRequest>();
    all.declare::<wire::SceneRequest>();
    all.declare::<wire::SimulationRun>();
    all.declare::<wire::ComparedDrop>();
    all.declare::<simulation::Document>();
    all.declare::<Chart>();
    all.declare::<PuzzleChoice>();
    all.declare::<PuzzleAnswer>();
    all.declare::<paper::Document>();
    let declarations: String = all.found.into_values().collect();
    let certain = format!(
        "\n/** An impact below this probability counts as uncertain. */\nexport const CONFIDENT_PROBABILITY = {CONFIDENT_PROBABILITY};\n"
    );
    let endings: Vec<&str> = SoundFormat::endings_of_all()
        .chain(times::endings())
        .collect();
    let formats = format!(
        "\n/** Names of the sound formats. */\nexport const SOUND_FORMATS = '{}';\n\
         \n/** Endings of the names of recordings and of lists of times. */\nexport const ENDINGS = {endings:?};\n",
        SoundFormat::names()
    );
    let job = format!(
        "\n/** Maximum number of places of a test series, and of drops in each. */\nexport const MAX_NUMBER = {MAX_NUMBER};\n"
    );
    let signs = format!(
        "\n/** What begins a formula in a spreadsheet. */\nexport const FORMULA_SIGNS = {FORMULA_SIGNS:?};\n"
    );
    [HEAD, &declarations, &certain, &formats, &job, &signs]
        .concat()
        .replace("/**\n * ", "/** ")
        .replace("\n */\n", " */\n")
        .replace("{ \n", "{\n")
        .replace(", \n", ",\n")
}

fn main() {
    print!("{}", declarations());
}
