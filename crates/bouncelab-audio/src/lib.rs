//! Files to samples for bouncelab.
