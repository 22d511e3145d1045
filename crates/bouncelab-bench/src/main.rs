//! The measuring programs of the project: `cargo xtask help` lists them.

#![expect(
    clippy::print_stderr,
    clippy::print_stdout,
    reason = "it prints for contributors"
)]

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use bouncelab_bench::net::{self, Number};

type Result<T = ()> = std::result::Result<T, Box<dyn Error>>;

/// Its name, and what runs it with its arguments.
const PROGRAMS: [(&str, fn(&[String]) -> Result); 1] = [("net", run_net)];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (name, arguments) = arguments
        .split_first()
        .map_or(("", &[][..]), |(name, arguments)| {
            (name.as_str(), arguments)
        });
    let Some((_, run)) = PROGRAMS.iter().find(|(program, _)| *program == name) else {
        let names = PROGRAMS.map(|(name, _)| name).join(", ");
        eprintln!("'{name}' is no measuring program; there are {names}");
        return ExitCode::from(2);
    };
    match run(arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("{name}: {reason}");
            ExitCode::FAILURE
        }
    }
}

/// How many drops the tests compare with the stored copy.
const STORED_DROPS: usize = 200;

/// `net [drops=1000] [sounds=FOLDER]... [out=FILE] [compare=FILE] [store=FILE]`
///
/// Every number of simulated drops and of the sounds in these folders, and in that of `BOUNCELAB_RECORDINGS`; or how they
/// differ from those that `out` wrote earlier. `store` writes the copy that the tests compare with.
fn run_net(arguments: &[String]) -> Result {
    let mut drops = 1000;
    let (mut out, mut compare, mut store) = (None, None, None);
    let recordings = std::env::var("BOUNCELAB_RECORDINGS");
    let mut folders: Vec<String> = recordings.into_iter().collect();
    for argument in arguments {
        match argument.split_once('=') {
            Some(("drops", count)) => drops = count.parse()?,
            Some(("sounds", folder)) => folders.push(folder.to_owned()),
            Some(("out", file)) => out = Some(file),
            Some(("compare", file)) => compare = Some(file),
            Some(("store", file)) => store = Some(file),
            _ => {
                return Err(format!(
                    "'{argument}' is none of: drops=N, sounds=FOLDER, out=FILE, compare=FILE, store=FILE"
                )
                .into());
            }
        }
    }
    if let Some(file) = store {
        let table = net::stored_table(&net::numbers_of_drops(STORED_DROPS));
        return Ok(fs::write(file, table)?);
    }
    let mut numbers = net::numbers_of_drops(drops);
    for folder in folders {
        numbers.extend(net::numbers_of_folder(Path::new(&folder))?);
    }
    let numbers: Vec<Number> = numbers.concat();
    let text = net::text(&numbers);
    if let Some(file) = out {
        fs::write(file, &text)?;
    }
    match compare {
        Some(file) => match net::difference(&fs::read_to_string(file)?, &text) {
            None => println!("net: same"),
            Some(difference) => return Err(difference.into()),
        },
        None if out.is_none() => print!("{text}"),
        None => {}
    }
    Ok(())
}
