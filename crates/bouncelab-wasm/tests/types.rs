//! The types in TypeScript are those in Rust.
//!
//! Run with `BOUNCELAB_UPDATE_TYPES=1` to write them.

#![cfg(not(target_family = "wasm"))]

use std::any::TypeId;
use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::Path;

use bouncelab::Recording;
use bouncelab::diagnostic::Argument;
use bouncelab_report::Chart;
use bouncelab_report::document::simulation;
use bouncelab_report::paper;
use bouncelab_report::paper::lesson::{PuzzleAnswer, PuzzleChoice};
use bouncelab_wasm::refusal::Refusal;
use bouncelab_wasm::wire;
use ts_rs::{Config, TS, TypeVisitor};

const HEAD: &str = "\
// The types that the laboratory's engine takes and gives, made from those in
// Rust (crates/bouncelab and bouncelab-wasm) by `cargo xtask web`. Do not edit.
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
    all.declare::<wire::SoFar>();
    all.declare::<wire::Demo>();
    all.declare::<wire::AnalysisRequest>();
    all.declare::<wire::Analysed<'static>>();
    all.declare::<wire::Drawn>();
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
    [HEAD, &declarations]
        .concat()
        .replace("/**\n * ", "/** ")
        .replace("\n */\n", " */\n")
        .replace("{ \n", "{\n")
        .replace(", \n", ",\n")
}

/// The page is compiled against what the engine really gives.
#[test]
fn typescript_knows_the_types() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/src/lab/types.ts");
    let expected = declarations();
    if std::env::var_os("BOUNCELAB_UPDATE_TYPES").is_some() {
        fs::write(&file, &expected).unwrap();
    }
    let found = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        found == expected,
        "web/src/lab/types.ts is not what the Rust types say; write it anew with \
         BOUNCELAB_UPDATE_TYPES=1 cargo test -p bouncelab-wasm --test types"
    );
}
