//! What a bounce keeps: restitution laws and contact time.

/// One impact as a sound source: when the ball touched the surface, and how fast it came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// Time of first contact in seconds, on the clock of the drop it belongs to.
    pub time_s: f64,
    /// Speed of the ball just before the contact, in metres per second; positive.
    pub speed_m_s: f64,
}
