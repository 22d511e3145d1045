//! One flight: launch speed to time, apex and impact speed, and back.
