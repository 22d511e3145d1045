//! Lesson sheets: two pages of A4 each, the first for pupils, the second for the teacher, with what to expect, computed.
//!
//! The page makes them, with its own address; `docs/lessons` has them in every language with a blank in its place.
//!
//! ```
//! use bouncelab_report::messages::Translator;
//! use bouncelab_report::sheets::Sheet;
//!
//! let html = Sheet::Gravity.html(None, &Translator::english())?;
//! assert!(html.contains("Measure g with a ball"));
//! # Ok::<(), bouncelab::Error>(())
//! ```

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use bouncelab::Result;
use bouncelab::drop::{self, Bounce, Start, Stop};
use bouncelab::gravity::STANDARD_M_S2;
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::settings::Settings;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::digits::with_minus;
use crate::link::DropLink;
use crate::mark::{COMMENT, MARK};
use crate::messages::{Translator, Value};
use crate::report::html::{POLICY, STYLE};
use crate::report::markdown::{escaped, of_table};
use crate::table::{Align, Table};

/// Besides the style of reports.
const SHEET_STYLE: &str = include_str!("sheets.css");

/// Where pupils write an address by hand.
const BLANK: &str = "__________________________________________";

/// The ball of most sheets.
const LIGHT: &str = "table-tennis-40";
/// One that stays long on the floor at each bounce.
const SOFT: &str = "tennis";
/// One that hardly feels the air.
const HEAVY: &str = "steel:0.02";
/// The balls that are compared.
const BALLS: [&str; 4] = [LIGHT, SOFT, "golf", HEAVY];
/// What the compared balls keep of their speed.
const SHARED: f64 = 0.85;
/// What one of the examples keeps.
const EXAMPLE: f64 = 0.9;
/// Scatter of restitution from bounce to bounce, which is usual for good balls, relative.
const SCATTER: f64 = 0.005;
/// How often the ball is dropped to measure gravity.
const DROPS: f64 = 5.0;

/// A lesson sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sheet {
    /// How bouncy is a ball?
    Bounciness,
    /// How much does air take?
    Air,
    /// Measure g with a ball.
    Gravity,
}

/// A table: its headings, and its rows.
type Rows = (Vec<&'static str>, Vec<Vec<String>>);

/// Values of the messages of a sheet, by name.
type Values = Vec<(&'static str, Value<'static>)>;

/// What differs from sheet to sheet.
struct Contents {
    values: Values,
    /// Headings and number of rows of the table to fill in.
    to_fill: (Vec<&'static str>, usize),
    expected: Rows,
}

impl Sheet {
    /// All sheets.
    pub const ALL: [Self; 3] = [Self::Bounciness, Self::Air, Self::Gravity];

    /// Its name in files and messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bounciness => "bounciness",
            Self::Air => "air",
            Self::Gravity => "gravity",
        }
    }

    /// The drop height, m.
    const fn height_m(self) -> f64 {
        match self {
            Self::Bounciness | Self::Gravity => 0.5,
            Self::Air => 1.0,
        }
    }

    /// The sheet with this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|sheet| sheet.name() == name)
    }

    /// The sheet as HTML, which prints on two pages; with the address of the page that pupils use, if it is known.
    ///
    /// # Errors
    ///
    /// None: all numbers of the sheets are within their ranges.
    pub fn html(self, page: Option<&DropLink>, translator: &Translator) -> Result<String> {
        let [pupils, teacher] = self.pages(page, translator)?;
        let title = translator.text(&self.id("title"));
        let page = html! {
            (DOCTYPE)
            html lang=(translator.language()) {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(POLICY);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta name="generator" content=(MARK);
                    title { (title) }
                    link rel="icon" href="data:,";
                    style { (PreEscaped(STYLE)) (PreEscaped(SHEET_STYLE)) }
                }
                body {
                    main {
                        section { h1 { (title) } @for piece in &pupils { (piece.html()) } }
                        section .second { @for piece in &teacher { (piece.html()) } }
                    }
                }
            }
        };
        Ok(page.into_string())
    }

    /// The sheet as Markdown, to be edited; its pictures are part of it.
    ///
    /// # Errors
    ///
    /// None: all numbers of the sheets are within their ranges.
    pub fn markdown(self, page: Option<&DropLink>, translator: &Translator) -> Result<String> {
        let title = format!("# {}", escaped(&translator.text(&self.id("title"))));
        let pieces = self.pages(page, translator)?.into_iter().flatten();
        let mut pictures = Vec::new();
        let mut blocks = vec![title];
        for piece in pieces {
            if let Piece::Picture { svg, words } = &piece {
                let data = STANDARD.encode(svg.0.as_bytes());
                pictures.push(format!("[{words}]: data:image/svg+xml;base64,{data}"));
            }
            blocks.push(piece.markdown());
        }
        // Their long lines disturb least at the end.
        blocks.extend(pictures);
        blocks.push(COMMENT.to_owned());
        Ok(blocks.join("\n\n") + "\n")
    }

    /// The id of a message of this sheet.
    fn id(self, part: &str) -> String {
        format!("sheet-{}-{part}", self.name())
    }

    /// What stands on the page of the pupils, and on that of the teacher.
    fn pages(self, page: Option<&DropLink>, translator: &Translator) -> Result<[Vec<Piece>; 2]> {
        let contents = self.contents(translator)?;
        let text = |part: &str| translator.text_with(&self.id(part), &contents.values);
        let all = |part: &str| -> Vec<String> {
            let ids = (1..).map(|number| self.id(&format!("{part}-{number}")));
            let known = ids.take_while(|id| translator.has(id));
            known
                .map(|id| translator.text_with(&id, &contents.values))
                .collect()
        };
        let heading = |id: &str| Piece::Heading(translator.text(id));
        let (headings, count) = &contents.to_fill;
        let blank = vec![Vec::new(); *count];
        let address = page.map_or(BLANK, |page| &page.address);
        let mut pupils = vec![
            Piece::Text(translator.text("sheet-fields")),
            Piece::Text(translator.text_with("sheet-page", &[("address", address.into())])),
            Piece::Picture {
                svg: set_up(),
                words: translator.text("sheet-set-up"),
            },
        ];
        pupils.extend(page.map(|page| Piece::Picture {
            svg: qr_code(page),
            words: translator.text("sheet-qr-code"),
        }));
        pupils.extend([
            Piece::Lead(text("aim")),
            heading("sheet-need"),
            Piece::Bullets(all("need")),
            heading("sheet-do"),
            Piece::Steps(all("do")),
            heading("sheet-write"),
            Piece::Table(table(translator, headings, blank)),
            heading("sheet-work"),
            Piece::Steps(all("work")),
            heading("sheet-talk"),
            Piece::Steps(all("talk")),
        ]);
        let mut hints = all("teacher");
        hints
            .extend(["quiet", "collect"].map(|id| translator.text(&format!("sheet-teacher-{id}"))));
        let (headings, rows) = contents.expected;
        let teacher = vec![
            heading("sheet-teacher"),
            Piece::Bullets(hints),
            heading("sheet-expected"),
            Piece::Text(text("see")),
            Piece::Table(table(translator, &headings, rows)),
            Piece::Text(translator.text("sheet-expected-made")),
        ];
        Ok([pupils, teacher])
    }

    fn contents(self, translator: &Translator) -> Result<Contents> {
        let height = ("height", Value::fixed(100.0 * self.height_m(), 0));
        let mut contents = match self {
            Self::Bounciness => self.bounciness(translator),
            Self::Air => self.air(translator),
            Self::Gravity => self.gravity(translator),
        }?;
        contents.values.push(height);
        Ok(contents)
    }

    fn bounciness(self, translator: &Translator) -> Result<Contents> {
        let row = |&restitution: &f64| {
            let flights = self.flights(LIGHT, restitution, true)?;
            let height_cm = 100.0 * flights.bounces[0].flight.apex_m;
            let fixed = |value, digits| translator.fixed(value, digits);
            Ok(vec![
                fixed(restitution, 2),
                fixed(flights.time_s(0), 4),
                fixed(flights.time_s(1), 4),
                fixed(flights.ratio(), 4),
                fixed(height_cm, 1),
            ])
        };
        let rows = [0.95, EXAMPLE, 0.85, 0.8, 0.7].iter().map(row);
        let ratio = self.flights(LIGHT, EXAMPLE, true)?.ratio();
        Ok(Contents {
            values: vec![
                ("ball", ball_name(LIGHT, translator).into()),
                ("off", Value::fixed(100.0 * (1.0 - ratio / EXAMPLE), 1)),
            ],
            to_fill: (
                vec!["ball", "drop", "first", "second", "ratio", "restitution"],
                9,
            ),
            expected: (
                vec!["restitution", "first", "second", "ratio", "height"],
                rows.collect::<Result<_>>()?,
            ),
        })
    }

    fn air(self, translator: &Translator) -> Result<Contents> {
        let fixed = |value, digits| translator.fixed(value, digits);
        let row = |ball: &str, air: bool| {
            let flights = self.flights(ball, SHARED, air)?;
            let terminal = flights.terminal_speed_m_s.filter(|_| air);
            let share = flights.drag_share();
            Ok(vec![
                if air {
                    ball_name(ball, translator)
                } else {
                    translator.text("sheet-no-air")
                },
                terminal.map_or_else(String::new, |speed| fixed(speed, 1)),
                fixed(flights.bounces[0].impact_speed_m_s, 3),
                if air {
                    fixed(100.0 * share, 1)
                } else {
                    fixed(0.0, 0)
                },
                fixed(flights.time_s(0), 4),
                fixed(flights.ratio(), 4),
            ])
        };
        let rows = BALLS.iter().map(|ball| row(ball, true));
        let light = self.flights(LIGHT, SHARED, true)?;
        Ok(Contents {
            values: vec![
                ("restitution", Value::fixed(SHARED, 2)),
                ("share", Value::fixed(100.0 * light.drag_share(), 0)),
                (
                    "off",
                    Value::fixed(100.0 * (1.0 - light.ratio() / SHARED), 1),
                ),
            ],
            to_fill: (
                vec!["ball", "first", "second", "third", "ratio", "restitution"],
                9,
            ),
            expected: (
                vec!["ball", "terminal", "speed", "share", "first", "ratio"],
                rows.chain([row(LIGHT, false)]).collect::<Result<_>>()?,
            ),
        })
    }

    fn gravity(self, translator: &Translator) -> Result<Contents> {
        let fixed = |value, digits| translator.fixed(value, digits);
        let row = |ball: &str, air: bool| {
            let flights = self.flights(ball, SHARED, air)?;
            let (first_s, second_s) = (flights.time_s(0), flights.time_s(1));
            let gravity = self.gravity_of(&flights);
            Ok(vec![
                if air {
                    ball_name(ball, translator)
                } else {
                    translator.text("sheet-no-air")
                },
                fixed(first_s, 4),
                fixed(second_s, 4),
                fixed(gravity, 2),
                with_minus(&fixed(percent_off(gravity), 1)),
            ])
        };
        let rows = BALLS.iter().rev().map(|ball| row(ball, true));
        let soft = self.flights(SOFT, SHARED, true)?;
        // g goes with the square of the restitution of the second bounce over that of the first.
        let scatter = 2.0 * 2.0_f64.sqrt() * SCATTER;
        Ok(Contents {
            values: vec![
                ("restitution", Value::fixed(SHARED, 2)),
                ("gravity", Value::fixed(STANDARD_M_S2, 2)),
                ("share", Value::fixed(0.1 / self.height_m(), 1)),
                ("contact", Value::fixed(1e3 * soft.contact_s, 0)),
                (
                    "soft",
                    Value::fixed(-percent_off(self.gravity_of(&soft)), 1),
                ),
                ("scatter", Value::fixed(100.0 * scatter, 1)),
                ("mean", Value::fixed(100.0 * scatter / DROPS.sqrt(), 1)),
            ],
            to_fill: (vec!["drop", "first", "second", "ratio", "gravity"], 6),
            expected: (
                vec!["ball", "first", "second", "gravity", "off"],
                [row(HEAVY, false)]
                    .into_iter()
                    .chain(rows)
                    .collect::<Result<_>>()?,
            ),
        })
    }

    /// The acceleration of gravity by the height and two flights, as if there were no air and no contact, m/s².
    fn gravity_of(self, flights: &Flights) -> f64 {
        8.0 * self.height_m() * flights.time_s(1).powi(2) / flights.time_s(0).powi(4)
    }

    /// The first flights of a ball from the height of the sheet.
    fn flights(self, ball: &str, restitution: f64, air: bool) -> Result<Flights> {
        let mut settings = Settings::of_ball(ball);
        settings.air.drag = (!air).then(|| "none".to_owned());
        let options = settings.resolve()?.options;
        let contact = Contact::new(Restitution::constant(restitution)?, options.contact_time_s)?;
        let model = options.model()?;
        let start = Start::Height(self.height_m());
        let history = drop::simulate(&model, &contact, start, Stop::after(3))?;
        Ok(Flights {
            terminal_speed_m_s: model.terminal_speed_m_s(),
            bounces: history.bounces().to_vec(),
            contact_s: options.contact_time_s,
        })
    }
}

/// The first flights of a drop.
struct Flights {
    terminal_speed_m_s: Option<f64>,
    bounces: Vec<Bounce>,
    contact_s: f64,
}

impl Flights {
    /// From one impact to the next, as they are detected.
    fn time_s(&self, flight: usize) -> f64 {
        self.bounces[flight].flight.time_s() + self.contact_s
    }

    fn ratio(&self) -> f64 {
        self.time_s(1) / self.time_s(0)
    }

    /// Drag at the first impact over the weight.
    fn drag_share(&self) -> f64 {
        let terminal = self.terminal_speed_m_s.unwrap_or(f64::INFINITY);
        (self.bounces[0].impact_speed_m_s / terminal).powi(2)
    }
}

/// How far an acceleration of gravity is off, in per cent to one digit.
fn percent_off(gravity_m_s2: f64) -> f64 {
    // Adding zero makes of a negative zero a plain one.
    (1000.0 * (gravity_m_s2 / STANDARD_M_S2 - 1.0)).round() / 10.0 + 0.0
}

fn ball_name(ball: &str, translator: &Translator) -> String {
    let kind = ball.split(':').next().unwrap_or(ball);
    translator.text(&format!("sheet-ball-{kind}"))
}

/// A piece of a sheet.
enum Piece {
    Heading(String),
    Lead(String),
    Text(String),
    Bullets(Vec<String>),
    Steps(Vec<String>),
    Table(Table),
    /// A drawing, and what it shows.
    Picture {
        svg: PreEscaped<String>,
        words: String,
    },
}

impl Piece {
    fn html(&self) -> Markup {
        let items = |items: &[String]| html! { @for item in items { li { (item) } } };
        match self {
            Self::Heading(words) => html! { h2 { (words) } },
            Self::Lead(words) => html! { p .first { (words) } },
            Self::Text(words) => html! { p { (words) } },
            Self::Bullets(words) => html! { ul { (items(words)) } },
            Self::Steps(words) => html! { ol { (items(words)) } },
            Self::Table(table) => html! {
                div .table {
                    table {
                        thead { tr { @for (name, _) in table.columns() { th scope="col" { (name) } } } }
                        tbody { @for row in table.rows() { tr { @for cell in row { td { (cell) } } } } }
                    }
                }
            },
            Self::Picture { svg, words } => {
                html! { span .picture role="img" aria-label=(words) { (svg) } }
            }
        }
    }

    fn markdown(&self) -> String {
        let lines = |mark: &str, words: &[String]| {
            let lines = words
                .iter()
                .map(|words| format!("{mark} {}", escaped(words)));
            lines.collect::<Vec<_>>().join("\n")
        };
        match self {
            Self::Heading(words) => format!("## {}", escaped(words)),
            Self::Lead(words) => format!("**{}**", escaped(words)),
            Self::Text(words) => escaped(words),
            Self::Bullets(words) => lines("-", words),
            // Markdown counts them.
            Self::Steps(words) => lines("1.", words),
            Self::Table(table) => of_table(table),
            Self::Picture { words, .. } => format!("![{words}]"),
        }
    }
}

/// The set-up: a ball above a floor, its height from the lowest point of the ball, and a phone beside where it lands.
fn set_up() -> Markup {
    html! {
        svg xmlns=(SVG) viewBox="0 0 120 90" {
            g fill="none" stroke="currentColor" stroke-width="1.2" {
                path d="M4 80H116" {}
                circle cx="60" cy="14" r="7" {}
                path d="M60 25V76" stroke-dasharray="2 3" {}
                path d="M34 21V80M31 25l3-4 3 4M31 76l3 4 3-4M30 21H52" {}
                path d="M86 76h22v4H86z" {}
                path d="M80 74a6 6 0 0 0-4-4M82 69a11 11 0 0 0-6-4" {}
            }
            text x="24" y="54" font-size="9" fill="currentColor" { "h" }
        }
    }
}

const SVG: &str = "http://www.w3.org/2000/svg";

/// Black on white, with the margin that readers of codes want.
fn qr_code(DropLink { modules, path, .. }: &DropLink) -> Markup {
    const MARGIN: u32 = 4;
    let side = modules + 2 * MARGIN;
    html! {
        svg xmlns=(SVG) viewBox={ "0 0 " (side) " " (side) } shape-rendering="crispEdges" {
            rect width=(side) height=(side) fill="white" {}
            path transform={ "translate(" (MARGIN) " " (MARGIN) ")" } d=(path) fill="black" {}
        }
    }
}

fn table(translator: &Translator, headings: &[&str], rows: Vec<Vec<String>>) -> Table {
    let named = |id: &&str| (translator.text(&format!("sheet-column-{id}")), Align::Left);
    let mut table = Table::new(headings.iter().map(named));
    for row in rows {
        table.row(row);
    }
    table
}
