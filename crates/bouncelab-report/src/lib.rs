//! Figures and tables for bouncelab.
