//! No damage to a file of any format makes a wrong result that looks like a right one. `cargo xtask damage`
//! tries every percent of each file, with the inference; here it is four places without.

use bouncelab::Options;
use bouncelab_testkit::damage::{Damage, Verdict, analyse, files, is_warned, judge, words};

#[test]
fn no_damage_makes_a_wrong_result_that_looks_right() {
    let options = Options::default().without_inference();
    for (name, file) in files() {
        let whole = analyse(&file, &name, &options).expect(&name);
        assert_eq!(whole.drops.len(), 1, "{name}");
        assert!(!is_warned(&whole), "{name}: {:?}", whole.diagnostics);
        for (damage, percent) in Damage::ALL.into_iter().zip([22, 45, 37, 81]) {
            let damaged = analyse(&damage.at(percent, &file), &name, &options);
            let verdict = judge(&whole, damaged.as_ref().ok());
            let numbers = words(&damaged);
            assert_ne!(
                verdict,
                Verdict::Wrong,
                "{name}, {damage:?} at {percent} %: {numbers}"
            );
        }
    }
}
