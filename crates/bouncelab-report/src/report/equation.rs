//! The formulas of the method, as `MathML` for browsers and as LaTeX for notebooks.

use maud::{Markup, html};
use serde::{Deserialize, Serialize};

/// A formula of the method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub enum Equation {
    /// Height of a flight from its time, without air (paper, Eq. 5).
    PlainHeight,
    /// The log-linear fit: the straight line through the logarithms of the flight times (paper, Eqs. 4 and 6).
    StraightLine,
    /// A ball in the air.
    Motion,
    /// Restitution of one impact.
    Restitution,
    /// The noise of the residuals: scatter of the impacts and errors of the times.
    Noise,
    /// What the data leave of what was possible.
    Posterior,
}

impl Equation {
    /// Its content in LaTeX, without the signs that begin and end it.
    pub const fn latex(self) -> &'static str {
        match self {
            Self::PlainHeight => r"h_n = \frac{g\,T_n^2}{8}",
            Self::StraightLine => {
                r"\log_{10} T_n = n \log_{10} e + b, \qquad h_0 = \frac{g}{8}\left(10^b\right)^2"
            }
            Self::Motion => {
                r"\left(m + \tfrac{1}{2}\rho V\right)\frac{dv}{dt} = -(m - \rho V)\,g - \tfrac{1}{2}\rho A\,C_D(\mathrm{Re})\,v\,|v|"
            }
            Self::Restitution => r"e_n = \frac{v_n}{v'_n}",
            Self::Noise => {
                r"\mathrm{cov}\left[\ln e_n - \ln e(v'_n)\right] = \sigma_e^2 I + \sigma_t^2 J J^{\mathsf T}"
            }
            Self::Posterior => {
                r"p(\theta, M \mid t) \propto p(t \mid \theta, M)\,p(\theta \mid M)\,p(M)"
            }
        }
    }

    /// Its content in `MathML`, without the element `math` around it.
    pub(super) fn mathml(self) -> Markup {
        match self {
            Self::PlainHeight => html! {
                (sub("h", "n")) mo { "=" }
                mfrac { mrow { mi { "g" } msubsup { mi { "T" } mi { "n" } mn { "2" } } } mn { "8" } }
            },
            Self::StraightLine => html! {
                (log10()) (sub("T", "n")) mo { "=" } mi { "n" } (log10()) mi { "e" }
                mo { "+" } mi { "b" } mo separator="true" { "," } mspace width="2em" {}
                (sub("h", "0")) mo { "=" } mfrac { mi { "g" } mn { "8" } }
                msup { mrow { mo { "(" } msup { mn { "10" } mi { "b" } } mo { ")" } } mn { "2" } }
            },
            Self::Motion => html! {
                mrow { mo { "(" } mi { "m" } mo { "+" } (half()) mi { "ρ" } mi { "V" } mo { ")" } }
                mfrac { mrow { mi { "d" } mi { "v" } } mrow { mi { "d" } mi { "t" } } }
                mo { "=" } mo { "−" }
                mrow { mo { "(" } mi { "m" } mo { "−" } mi { "ρ" } mi { "V" } mo { ")" } } mi { "g" }
                mo { "−" } (half()) mi { "ρ" } mi { "A" } (sub("C", "D"))
                mrow { mo { "(" } mi { "Re" } mo { ")" } } mi { "v" }
                mrow { mo { "|" } mi { "v" } mo { "|" } }
            },
            Self::Restitution => html! {
                (sub("e", "n")) mo { "=" } mfrac { (sub("v", "n")) (primed("v", "n")) }
            },
            Self::Noise => html! {
                mi { "cov" } mrow {
                    mo { "[" } mi { "ln" } (sub("e", "n")) mo { "−" } mi { "ln" } mi { "e" }
                    mo { "(" } (primed("v", "n")) mo { ")" } mo { "]" }
                }
                mo { "=" } msubsup { mi { "σ" } mi { "e" } mn { "2" } } mi { "I" } mo { "+" }
                msubsup { mi { "σ" } mi { "t" } mn { "2" } } mi { "J" }
                msup { mi { "J" } mi mathvariant="normal" { "T" } }
            },
            Self::Posterior => html! {
                mi { "p" } (of(&html! { mi { "θ" } mo { "," } mi { "M" } mo { "|" } mi { "t" } }))
                mo { "∝" }
                mi { "p" } (of(&html! { mi { "t" } mo { "|" } mi { "θ" } mo { "," } mi { "M" } }))
                mi { "p" } (of(&html! { mi { "θ" } mo { "|" } mi { "M" } }))
                mi { "p" } (of(&html! { mi { "M" } }))
            },
        }
    }
}

fn sub(letter: &str, index: &str) -> Markup {
    let is_number = index.chars().all(|c| c.is_ascii_digit());
    html! { msub { mi { (letter) } @if is_number { mn { (index) } } @else { mi { (index) } } } }
}

fn primed(letter: &str, index: &str) -> Markup {
    html! { msubsup { mi { (letter) } mi { (index) } mo { "′" } } }
}

fn log10() -> Markup {
    html! { msub { mi { "log" } mn { "10" } } }
}

fn half() -> Markup {
    html! { mfrac { mn { "1" } mn { "2" } } }
}

fn of(inside: &Markup) -> Markup {
    html! { mrow { mo { "(" } (inside) mo { ")" } } }
}
