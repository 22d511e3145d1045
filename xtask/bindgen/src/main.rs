//! Makes the JavaScript side of a WebAssembly file: `bindgen FILE.wasm FOLDER NAME`.

use std::env;
use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [input, folder, name] = &arguments[..] else {
        eprintln!("usage: bindgen FILE.wasm FOLDER NAME");
        return ExitCode::from(2);
    };
    let made = Bindgen::new()
        .input_path(input)
        .web(true)
        .and_then(|bindgen| {
            // Names are for debuggers; they would be a fifth of the file.
            bindgen
                .typescript(true)
                .remove_name_section(true)
                .remove_producers_section(true)
                .out_name(name)
                .generate(folder)
        });
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("bindgen: {reason:#}");
            ExitCode::FAILURE
        }
    }
}
