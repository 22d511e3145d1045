//! Meanings of colours, and sizes.
//!
//! The colours are those of Okabe and Ito (2008), which people with any kind of colour
//! vision can distinguish. Each has one meaning, the same in every figure, on the command
//! line and in the browser. Colour is never the only sign: the legend also shows the shape or
//! the dashes.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// An opaque colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour {
    /// Red, green and blue, 0 to 255.
    pub rgb: [u8; 3],
}

impl Colour {
    const fn new(red: u8, green: u8, blue: u8) -> Self {
        Self {
            rgb: [red, green, blue],
        }
    }

    /// The same hue at 20 % on white: the colour of an uncertainty.
    ///
    /// Mixed rather than transparent, so that overlapping uncertainties do not look denser.
    #[must_use]
    pub fn tint(self) -> Self {
        self.mixed(0.2)
    }

    /// The same hue, a share of it from 0 (white) to 1, on white.
    #[must_use]
    pub fn mixed(self, share: f64) -> Self {
        let share = share.clamp(0.0, 1.0);
        Self {
            rgb: self
                .rgb
                .map(|part| (share * f64::from(part) + (1.0 - share) * 255.0).round() as u8),
        }
    }
}

/// As in a style sheet: `#0072b2`.
impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [red, green, blue] = self.rgb;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

/// What is shown, which decides its colour. In JSON it is the name of a colour of the page:
/// `measured`, `drag`, ..., `group-0`, `group-1`, ...
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Meaning {
    /// Measured, or computed from measurements with everything taken into account.
    Measured,
    /// A model with air drag.
    Drag,
    /// The log-linear fit, or anything that leaves drag out.
    Plain,
    /// Something to be careful with.
    Warning,
    /// What a rule accepts.
    Accepted,
    /// A given value to compare with.
    Ink,
    /// Something less important.
    Soft,
    /// Where values are expected.
    Expected,
    /// A group by its index, which means nothing but "this group".
    Group(usize),
}

impl Meaning {
    /// Its colour.
    ///
    /// ```
    /// use bouncelab_report::theme::Meaning;
    /// assert_eq!(Meaning::Measured.colour().to_string(), "#0072b2");
    /// ```
    pub const fn colour(self) -> Colour {
        match self {
            Self::Measured => Colour::new(0x00, 0x72, 0xb2),
            Self::Drag => Colour::new(0xd5, 0x5e, 0x00),
            Self::Plain => Colour::new(0x76, 0x76, 0x76),
            Self::Warning => Colour::new(0xe6, 0x9f, 0x00),
            Self::Accepted => GROUPS[2],
            Self::Ink => INK,
            Self::Soft => SOFT_INK,
            Self::Expected => BASE_LINE,
            Self::Group(index) => GROUPS[index % GROUPS.len()],
        }
    }
}

impl fmt::Display for Meaning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Self::Measured => "measured",
            Self::Drag => "drag",
            Self::Plain => "plain",
            Self::Warning => "warning",
            Self::Accepted => "accepted",
            Self::Ink => "ink",
            Self::Soft => "soft",
            Self::Expected => "expected",
            Self::Group(index) => return write!(f, "group-{}", index % GROUPS.len()),
        };
        f.write_str(name)
    }
}

/// From its name in JSON.
///
/// ```
/// use bouncelab_report::theme::Meaning;
///
/// assert_eq!("drag".parse(), Ok(Meaning::Drag));
/// assert_eq!("group-3".parse(), Ok(Meaning::Group(3)));
/// assert!("blue".parse::<Meaning>().is_err());
/// ```
impl FromStr for Meaning {
    type Err = bouncelab::Error;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let groups = (0..GROUPS.len()).map(Self::Group);
        let all: Vec<Self> = NAMED.into_iter().chain(groups).collect();
        let names: Vec<String> = all.iter().map(ToString::to_string).collect();
        let index = names.iter().position(|known| known == name);
        index.map(|index| all[index]).ok_or_else(|| {
            let known: Vec<&str> = names.iter().map(String::as_str).collect();
            bouncelab::Error::unknown_name("meaning", name, &known)
        })
    }
}

/// Every meaning but those of groups.
const NAMED: [Meaning; 8] = [
    Meaning::Measured,
    Meaning::Drag,
    Meaning::Plain,
    Meaning::Warning,
    Meaning::Accepted,
    Meaning::Ink,
    Meaning::Soft,
    Meaning::Expected,
];

impl Serialize for Meaning {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Meaning {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        name.parse().map_err(de::Error::custom)
    }
}

/// The colours of groups, which mean nothing but "this group"; each differs from all others for any
/// kind of colour vision, and groups differ in the shape of their points too.
const GROUPS: [Colour; 7] = [
    Colour::new(0x00, 0x72, 0xb2),
    Colour::new(0xd5, 0x5e, 0x00),
    Colour::new(0x00, 0x9e, 0x73),
    Colour::new(0xcc, 0x79, 0xa7),
    Colour::new(0xe6, 0x9f, 0x00),
    Colour::new(0x56, 0xb4, 0xe9),
    Colour::new(0x40, 0x40, 0x40),
];

/// Titles and labels.
pub const INK: Colour = Colour::new(0x22, 0x22, 0x22);
/// Numbers along the axes and names of the axes.
pub const SOFT_INK: Colour = Colour::new(0x59, 0x59, 0x59);
/// The line at the bottom of a panel.
pub(crate) const BASE_LINE: Colour = Colour::new(0x99, 0x99, 0x99);
/// Grid lines.
pub(crate) const GRID: Colour = Colour::new(0xe8, 0xe8, 0xe8);
/// The page.
pub const PAPER: Colour = Colour::new(0xff, 0xff, 0xff);

/// The fonts of whatever system shows the figure.
pub(crate) const FONT_FAMILY: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";

/// Size of the title, in figure pixels. A figure is [`WIDTH`] figure pixels wide.
pub(crate) const TITLE_SIZE: u32 = 17;
/// Size of labels and names of axes, in figure pixels.
pub(crate) const LABEL_SIZE: u32 = 14;
/// Size of the numbers along the axes, in figure pixels; still legible when the figure is
/// shown 480 pixels wide.
pub(crate) const TICK_SIZE: u32 = 13;

/// Width of every figure, in figure pixels.
pub const WIDTH: f64 = 640.0;
