//! Balls that one can name.

use super::{Ball, CALLIPERED_REL_SD, KnownBall, WEIGHED_REL_SD};
use crate::error::{Error, Result, nearest};

/// A ball one can name.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Preset {
    /// The name by which it is looked up and stored, as in "table-tennis-40".
    pub name: &'static str,
    /// The name for people.
    pub label: &'static str,
    /// Other words by which it is found, in the languages of the project.
    pub words: &'static [&'static str],
    /// Mass, diameter and contact time, and how well they and its drag are known.
    ///
    /// Contact times are an order of magnitude from the sports literature, on a hard surface. Measure it where it
    /// matters (it is 2 % of a late flight of a table-tennis ball).
    pub known: KnownBall,
    /// The material of a solid ball, by which mass and diameter determine one another: such balls come in any size.
    pub density: Option<Density>,
    /// Where mass and diameter come from.
    pub source: &'static str,
}

/// The density of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Density {
    /// In kilograms per cubic metre.
    pub kg_m3: f64,
    /// Relative standard uncertainty: how much balls of this material differ.
    pub rel_sd: f64,
}

/// Every preset: balls whose mass and size the rules of their sport fix, and solid balls of a usual size.
///
/// ```
/// let names: Vec<_> = bouncelab::ball::presets().iter().map(|preset| preset.name).collect();
/// assert!(names.contains(&"tennis") && names.contains(&"marble"));
/// ```
pub fn presets() -> &'static [Preset] {
    &PRESETS
}

/// The ball that is assumed where nobody says which: the first of the list.
pub(crate) fn usual() -> &'static Preset {
    &PRESETS[0]
}

/// The preset with a name, in any case, or with one of its other [words](Preset::words). "Ball" may follow, and spaces
/// and hyphens may be left out or added.
///
/// # Errors
/// [`Error::UnknownName`], with the nearest name, if no preset has this one.
///
/// ```
/// use bouncelab::ball::preset;
///
/// for words in ["tennis", "Tennis ball", "balle de tennis"] {
///     assert_eq!(preset(words)?.name, "tennis");
/// }
/// assert_eq!(preset("Ping-Pong")?.name, "table-tennis-40");
/// let error = preset("table-tenis").unwrap_err();
/// assert!(error.to_string().contains("the nearest is \"table-tennis-"));
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn preset(name: &str) -> Result<&'static Preset> {
    let sought = key(name);
    let found = PRESETS
        .iter()
        .find(|preset| preset.all_words().any(|word| means(&sought, &key(word))));
    found.ok_or_else(|| unknown(name))
}

fn unknown(name: &str) -> Error {
    let words = || PRESETS.iter().flat_map(Preset::all_words);
    let lowercase = name.to_lowercase();
    let word = nearest(&lowercase, words());
    let of_word = |preset: &&Preset| preset.all_words().any(|own| own == word);
    let names: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
    Error::UnknownName {
        kind: "ball",
        name: name.to_owned(),
        nearest: PRESETS
            .iter()
            .find(of_word)
            .unwrap_or(usual())
            .name
            .to_owned(),
        known: names.join(", "),
    }
}

/// The letters and digits of a name, in lower case: "Ping-Pong" is "pingpong". Accents that are characters of their own,
/// as file systems write them, are left out.
fn key(name: &str) -> String {
    let letters = name.chars().filter(|letter| letter.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}

/// Whether a name is a word, alone or with the words for a ball of the four languages.
fn means(sought: &str, word: &str) -> bool {
    /// Before the name: French and Spanish.
    const BALL_OF: [&str; 7] = [
        "ballede", "ballonde", "billede", "billed", "pelotade", "balónde", "bolade",
    ];
    /// After the name: English and German.
    const BALL: &str = "ball";
    let without = BALL_OF.iter().find_map(|of| sought.strip_prefix(of));
    sought == word || without == Some(word) || sought.strip_suffix(BALL) == Some(word)
}

impl Preset {
    /// The name, then the other words.
    fn all_words(&self) -> impl Iterator<Item = &'static str> {
        [self.name].into_iter().chain(self.words.iter().copied())
    }

    /// The same kind of ball with another mass, another diameter or both, as by a scale and a calliper.
    ///
    /// Drag and contact time stay those of the kind. Mass and diameter of a solid ball follow from one another if one
    /// is left out, and its contact time goes as its diameter (Hertz).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are from 1e-20 to 1e20.
    ///
    /// ```
    /// use bouncelab::ball::preset;
    ///
    /// // A bearing ball of 20 mm weighs 32.7 g.
    /// let steel = preset("steel")?.measured(None, Some(0.02))?;
    /// assert_eq!(format!("{:.1} g", 1e3 * steel.ball.mass_kg()), "32.7 g");
    /// let tennis = preset("tennis")?.measured(Some(0.058), None)?;
    /// assert_eq!(tennis.drag_rel_sd, preset("tennis")?.known.drag_rel_sd);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn measured(&self, mass_kg: Option<f64>, diameter_m: Option<f64>) -> Result<KnownBall> {
        let mut known = self.known;
        let (mass, diameter) = (known.ball.mass_kg(), known.ball.diameter_m());
        known.ball = Ball::new(mass_kg.unwrap_or(mass), diameter_m.unwrap_or(diameter))?;
        if mass_kg.is_some() {
            known.mass_rel_sd = WEIGHED_REL_SD;
        }
        if diameter_m.is_some() {
            known.diameter_rel_sd = CALLIPERED_REL_SD;
        }
        let Some(density) = self.density else {
            return Ok(known);
        };
        match (mass_kg, diameter_m) {
            (None, Some(diameter_m)) => {
                known.ball = Ball::solid(density.kg_m3, diameter_m)?;
                known.mass_rel_sd = density.rel_sd;
            }
            (Some(mass_kg), None) => {
                let ratio = mass_kg / (density.kg_m3 * self.known.ball.volume_m3());
                known.ball = Ball::new(mass_kg, diameter * ratio.cbrt())?;
                known.diameter_rel_sd = density.rel_sd / 3.0;
            }
            _ => {}
        }
        known.contact_time_s *= known.ball.diameter_m() / diameter;
        Ok(known)
    }
}

/// Relative standard uncertainty of a contact time of which the literature gives the order of magnitude.
const ORDER_OF_MAGNITUDE: f64 = 0.5;
/// Of a contact time that was measured on hard surfaces (R. Cross, Am. J. Phys. 67, 222, 1999), for other makes and
/// surfaces.
const MEASURED_BY_OTHERS: f64 = 0.3;
/// Of an inflated ball: the pressures that the rules allow differ by half, and contact times go as p^(-1/2).
const INFLATED: f64 = 0.3;
/// Of glass and steel: floors from wood to stone, by Hertz's law.
const HARD: f64 = 0.7;
/// Of a rubber ball, by Hertz's law with a modulus E* of 2 to 8 `MPa`.
const RUBBER: f64 = 0.4;

static PRESETS: [Preset; 14] = [
    Preset {
        name: "table-tennis-40",
        label: "table tennis 40+",
        words: &[
            "table tennis",
            "ping pong",
            "Tischtennis",
            "tenis de mesa",
            "tennis de table",
        ],
        known: KnownBall {
            ball: Ball::nominal(2.7, 40.0),
            contact_time_s: 1e-3,
            mass_rel_sd: 0.011,
            diameter_rel_sd: 0.004,
            contact_time_rel_sd: ORDER_OF_MAGNITUDE,
            drag_rel_sd: 0.04,
        },
        density: None,
        source: "ITTF: 2.67-2.77 g, 40.00-40.60 mm; the nominal 2.7 g and 40.0 mm",
    },
    Preset {
        name: "table-tennis-38",
        label: "table tennis 38 mm",
        words: &[],
        known: KnownBall {
            ball: Ball::nominal(2.5, 38.0),
            contact_time_s: 1e-3,
            mass_rel_sd: 0.012,
            diameter_rel_sd: 0.004,
            contact_time_rel_sd: ORDER_OF_MAGNITUDE,
            drag_rel_sd: 0.04,
        },
        density: None,
        source: "ITTF rules until September 2000: 2.5 g, 38 mm",
    },
    Preset {
        name: "tennis",
        label: "tennis",
        words: &["tenis"],
        known: KnownBall {
            ball: Ball::nominal(57.7, 66.0),
            contact_time_s: 5e-3,
            mass_rel_sd: 0.017,
            diameter_rel_sd: 0.014,
            contact_time_rel_sd: MEASURED_BY_OTHERS,
            drag_rel_sd: 0.3,
        },
        density: None,
        source: "ITF: 56.0-59.4 g, 65.4-68.6 mm; the middle mass, 66 mm",
    },
    Preset {
        name: "football",
        label: "football",
        words: &[
            "soccer",
            "Fußball",
            "Fussball",
            "fútbol",
            "futbol",
            "ballon de foot",
        ],
        known: KnownBall {
            ball: Ball::nominal(430.0, 220.0),
            contact_time_s: 1e-2,
            mass_rel_sd: 0.027,
            diameter_rel_sd: 0.008,
            contact_time_rel_sd: INFLATED,
            drag_rel_sd: 0.15,
        },
        density: None,
        source: "IFAB law 2, size 5: 410-450 g, circumference 68-70 cm; the middle",
    },
    Preset {
        name: "futsal",
        label: "futsal",
        words: &["fútsal", "fútbol sala", "futbol sala"],
        known: KnownBall {
            ball: Ball::nominal(420.0, 200.5),
            contact_time_s: 1e-2,
            mass_rel_sd: 0.027,
            diameter_rel_sd: 0.009,
            contact_time_rel_sd: INFLATED,
            drag_rel_sd: 0.15,
        },
        density: None,
        source: "FIFA futsal law 2, size 4: 400-440 g, circumference 62-64 cm; the middle",
    },
    Preset {
        name: "basketball",
        label: "basketball",
        words: &["basket", "baloncesto", "básquetbol"],
        known: KnownBall {
            ball: Ball::nominal(600.0, 243.0),
            contact_time_s: 1.5e-2,
            mass_rel_sd: 0.019,
            diameter_rel_sd: 0.008,
            contact_time_rel_sd: INFLATED,
            drag_rel_sd: 0.15,
        },
        density: None,
        source: "FIBA, size 7: 580-620 g, circumference 75-77 cm; the middle mass, 76.3 cm",
    },
    Preset {
        name: "golf",
        label: "golf",
        words: &[],
        known: KnownBall {
            ball: Ball::nominal(45.93, 42.67),
            contact_time_s: 5e-4,
            mass_rel_sd: 0.005,
            diameter_rel_sd: 0.002,
            contact_time_rel_sd: ORDER_OF_MAGNITUDE,
            drag_rel_sd: 0.15,
        },
        density: None,
        source: "R&A: at most 45.93 g, at least 42.67 mm; both limits, as balls are made",
    },
    Preset {
        name: "squash",
        label: "squash",
        words: &[],
        known: KnownBall {
            ball: Ball::nominal(24.0, 40.0),
            contact_time_s: 4e-3,
            mass_rel_sd: 0.024,
            diameter_rel_sd: 0.007,
            contact_time_rel_sd: ORDER_OF_MAGNITUDE,
            drag_rel_sd: 0.06,
        },
        density: None,
        source: "World Squash: 23-25 g, 39.5-40.5 mm; the middle",
    },
    Preset {
        name: "racquetball",
        label: "racquetball",
        words: &[],
        known: KnownBall {
            ball: Ball::nominal(39.7, 57.15),
            contact_time_s: 4e-3,
            mass_rel_sd: 0.01,
            diameter_rel_sd: 0.006,
            contact_time_rel_sd: ORDER_OF_MAGNITUDE,
            drag_rel_sd: 0.06,
        },
        density: None,
        source: "USA Racquetball: 1.4 oz, 2 1/4 in",
    },
    Preset {
        name: "pickleball",
        label: "pickleball",
        words: &[],
        known: KnownBall {
            ball: Ball::nominal(24.3, 74.2),
            contact_time_s: 2e-3,
            mass_rel_sd: 0.052,
            diameter_rel_sd: 0.007,
            contact_time_rel_sd: ORDER_OF_MAGNITUDE,
            drag_rel_sd: 0.3,
        },
        density: None,
        source: "USA Pickleball: 0.78-0.935 oz, 2.87-2.97 in; the middle",
    },
    Preset {
        name: "padel",
        label: "padel",
        words: &["pádel"],
        known: KnownBall {
            ball: Ball::nominal(57.7, 65.6),
            contact_time_s: 5e-3,
            mass_rel_sd: 0.017,
            diameter_rel_sd: 0.019,
            contact_time_rel_sd: MEASURED_BY_OTHERS,
            drag_rel_sd: 0.3,
        },
        density: None,
        source: "FIP: 56.0-59.4 g, 63.5-67.7 mm; the middle",
    },
    Preset {
        name: "marble",
        label: "glass marble",
        words: &[
            "glass",
            "glass marble",
            "Murmel",
            "Glas",
            "Glasmurmel",
            "canica",
            "vidrio",
            "bille",
            "verre",
        ],
        known: KnownBall {
            ball: Ball::nominal(5.36, 16.0),
            contact_time_s: 9e-5,
            mass_rel_sd: 0.12,
            diameter_rel_sd: 0.04,
            contact_time_rel_sd: HARD,
            drag_rel_sd: 0.04,
        },
        density: Some(Density {
            kg_m3: 2500.0,
            rel_sd: 0.02,
        }),
        source: "National Marbles Tournament: 5/8 in; soda-lime glass of 2500 kg/m3 (EN 572-1), and other sizes are sold",
    },
    Preset {
        name: "steel",
        label: "steel ball",
        words: &[
            "steel bearing",
            "bearing",
            "ball bearing",
            "Stahl",
            "Kugellagerkugel",
            "Stahlkugel",
            "acero",
            "acier",
        ],
        known: KnownBall {
            ball: Ball::nominal(4.09, 10.0),
            contact_time_s: 9e-5,
            mass_rel_sd: 0.3,
            diameter_rel_sd: 0.15,
            contact_time_rel_sd: HARD,
            drag_rel_sd: 0.04,
        },
        density: Some(Density {
            kg_m3: 7810.0,
            rel_sd: 0.01,
        }),
        source: "ISO 3290-1: 10 mm, one of many sizes; bearing steel of 7810 kg/m3 (100Cr6, ISO 683-17)",
    },
    Preset {
        name: "rubber",
        label: "rubber ball",
        words: &[
            "superball",
            "bouncy",
            "Flummi",
            "Gummi",
            "goma",
            "pelota saltarina",
            "caoutchouc",
            "balle rebondissante",
        ],
        known: KnownBall {
            ball: Ball::nominal(44.9, 45.0),
            contact_time_s: 3.5e-3,
            mass_rel_sd: 0.2,
            diameter_rel_sd: 0.1,
            contact_time_rel_sd: RUBBER,
            drag_rel_sd: 0.06,
        },
        density: Some(Density {
            kg_m3: 940.0,
            rel_sd: 0.05,
        }),
        source: "solid polybutadiene (N. H. Stingley, US patent 3241834), 910 kg/m3 (Polymer Data Handbook, 1999) and more with fillers; 20-50 mm are sold",
    },
];

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use super::*;
    use crate::Options;

    #[test]
    fn presets_have_unique_words_and_valid_balls() {
        let mut words = HashMap::new();
        for preset in presets() {
            for word in preset.all_words() {
                let other = words.insert(key(word), preset.name);
                assert!(other.is_none(), "{word} is also {other:?}");
                assert_eq!(super::preset(word).unwrap().name, preset.name, "{word}");
            }
            let KnownBall { ball, .. } = preset.known;
            assert_eq!(Ball::new(ball.mass_kg(), ball.diameter_m()), Ok(ball));
            let options = Options::new(preset);
            assert!(options.priors.check().is_ok() && options.model().is_ok());
        }
    }

    #[test]
    fn usual_words_in_any_case_find_the_ball() {
        for (words, name) in [
            ("TABLE-TENNIS-40", "table-tennis-40"),
            ("table_tennis_38", "table-tennis-38"),
            ("ping pong", "table-tennis-40"),
            ("Ping-Pong-Ball", "table-tennis-40"),
            ("Tischtennisball", "table-tennis-40"),
            ("pelota de ping-pong", "table-tennis-40"),
            ("balle de tennis de table", "table-tennis-40"),
            ("Tennisball", "tennis"),
            ("golf ball", "golf"),
            ("Soccer ball", "football"),
            ("FUẞBALL", "football"),
            ("balón de fu\u{301}tbol", "football"),
            ("ballon de basket", "basketball"),
            ("Murmel", "marble"),
            ("bille", "marble"),
            ("bille d'acier", "steel"),
            ("bola de acero", "steel"),
            ("Stahlkugel", "steel"),
            ("Superball", "rubber"),
            ("bouncy ball", "rubber"),
        ] {
            assert_eq!(preset(words).map(|ball| ball.name), Ok(name), "{words}");
        }
        // Words for a ball in general, or for a part of a name, name no preset.
        for words in ["", "ball", "super", "foot", "table", "red", "balle de"] {
            assert!(preset(words).is_err(), "{words}");
        }
    }

    #[test]
    fn an_unknown_preset_offers_the_nearest_and_the_list() {
        for (name, nearest) in [("golfbal", "golf"), ("Flumi", "rubber"), ("steal", "steel")] {
            let message = preset(name).unwrap_err().to_string();
            let offer = format!("nearest is \"{nearest}\"");
            assert!(message.contains(&offer), "{message}");
            assert!(
                message.contains("table-tennis-40, table-tennis-38, tennis"),
                "{message}"
            );
        }
    }

    /// A 10 mm bearing ball weighs 4.09 g, a marble of 16 mm 5.36 g.
    #[test]
    fn solid_balls_follow_from_their_diameter_or_mass() {
        for (name, diameter_m, mass_kg) in [("steel", 0.01, 4.09e-3), ("marble", 0.016, 5.36e-3)] {
            let preset = preset(name).unwrap();
            let by_size = preset.measured(None, Some(diameter_m)).unwrap();
            assert!((by_size.ball.mass_kg() - mass_kg).abs() < 5e-6);
            let by_mass = preset.measured(Some(mass_kg), None).unwrap();
            assert!((by_mass.ball.diameter_m() - diameter_m).abs() < 1e-5);
        }
        for preset in presets() {
            if let Some(density) = preset.density {
                let usual = preset.known.ball.density_kg_m3();
                assert!(
                    (usual / density.kg_m3 - 1.0).abs() < 2e-3,
                    "{}",
                    preset.name
                );
            }
        }
        let steel = preset("steel").unwrap();
        assert!(steel.measured(None, Some(-0.01)).is_err());
        assert!(steel.measured(Some(f64::NAN), None).is_err());
    }

    /// Twice the size, twice the contact time; what was measured is known well.
    #[test]
    fn a_measured_ball_keeps_what_its_kind_says() {
        let steel = preset("steel").unwrap();
        let larger = steel.measured(None, Some(0.02)).unwrap();
        assert!((larger.contact_time_s / steel.known.contact_time_s - 2.0).abs() < 1e-12);
        assert!(larger.mass_rel_sd < 0.1 && larger.diameter_rel_sd < 0.01);
        let tennis = preset("tennis").unwrap();
        let weighed = tennis.measured(Some(0.058), None).unwrap();
        let expected = KnownBall {
            ball: Ball::new(0.058, 0.066).unwrap(),
            mass_rel_sd: WEIGHED_REL_SD,
            ..tennis.known
        };
        assert_eq!(weighed, expected);
        assert_eq!(tennis.measured(None, None), Ok(tennis.known));
    }
}
