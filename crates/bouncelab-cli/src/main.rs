//! The program `bouncelab` on its own; that of the Python package calls the same library.

use std::env;
use std::path::PathBuf;
use std::process::ExitCode;

use bouncelab_cli::Invocation;

fn main() -> ExitCode {
    let mut words = env::args_os();
    let name = words.next().unwrap_or_else(|| "bouncelab".into());
    let program = env::current_exe().map_or(name, PathBuf::into_os_string);
    ExitCode::from(bouncelab_cli::run(Invocation {
        program: vec![program],
        arguments: words.collect(),
    }))
}
