//! Prints the fuzz targets for `cargo xtask fuzz`: of each the name, whether it reaches code that is not safe, and the
//! endings of the recordings that it begins with.

#![expect(clippy::print_stdout, reason = "it prints for a task")]

use bouncelab_testkit::fuzz::TARGETS;

fn main() {
    for target in TARGETS {
        let endings: Vec<&str> = target.endings().collect();
        let safety = if target.is_unsafe() { "unsafe" } else { "safe" };
        println!("{} {safety} {}", target.name, endings.join(" "));
    }
}
