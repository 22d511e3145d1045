//! How the numbers were found, with formulas and references.

use super::equation::Equation;
use super::page::{Block, Section};

/// The method in short: the same for every page.
pub fn method() -> Section {
    let blocks = vec![
        Block::text(
            "A ball is heard only when it hits. The silence between two impacts is a flight, and \
             its length T tells the height h of the flight, nearly independently of the air:",
        ),
        Block::Equation(Equation::PlainHeight),
        Block::text(
            "If each impact kept the same share e of the speed and there were no air, the \
             logarithms of the flight times would lie on a straight line against the number n of \
             the impact. Its slope gives the restitution e and its intercept b the drop height \
             (Nagurka, Eqs. 4 and 6):",
        ),
        Block::Equation(Equation::StraightLine),
        Block::text(
            "The air takes speed as well, and pushes and carries the ball a little. With mass m, \
             volume V and cross-section A of the ball, density ρ of the air, and a drag coefficient \
             that follows the Reynolds number, the velocity v changes as",
        ),
        Block::Equation(Equation::Motion),
        Block::text(
            "From each flight time follows the speed v at which the ball left the surface and the \
             speed v′ at which it came back, and from two neighbouring flights the restitution of \
             the impact between them:",
        ),
        Block::Equation(Equation::Restitution),
        Block::text(
            "Two kinds of noise are kept apart: impacts scatter by a share σₑ of their restitution, \
             and times have errors σₜ, which neighbouring impacts share through the derivatives J. \
             Odd impacts count less (Student's t).",
        ),
        Block::Equation(Equation::Noise),
        Block::text(
            "The inference weighs all values θ of what is unknown, under every restitution law and \
             drag law M, by how well they explain the times t and by what was known before. Each \
             quantity is stated as the median of that, ± its standard deviation; an interval of \
             95 % holds the truth with that probability if the assumptions hold.",
        ),
        Block::Equation(Equation::Posterior),
        Block::text("References:"),
        Block::List(
            [
                "M. Nagurka, Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment, \
                 International Journal of Engineering Education 19 (2003).",
                "R. Clift, J. R. Grace, M. E. Weber, Bubbles, Drops, and Particles, Academic Press \
                 (1978): the standard drag curve.",
                "A. Picard, R. S. Davis, M. Gläser, K. Fujii, Revised formula for the density of \
                 moist air (CIPM-2007), Metrologia 45 (2008).",
                "M. Montaine, M. Heckel, C. Kruelle, T. Schwager, T. Pöschel, Coefficient of \
                 restitution as a fluctuating quantity, Physical Review E 84 (2011): the scatter of \
                 impacts.",
                "A. Vehtari, D. Simpson, A. Gelman, Y. Yao, J. Gabry, Pareto smoothed importance \
                 sampling, Journal of Machine Learning Research 25 (2024).",
                "JCGM 100:2008, Guide to the expression of uncertainty in measurement.",
            ]
            .map(str::to_owned)
            .to_vec(),
        ),
    ];
    Section::new("Method", blocks)
}
