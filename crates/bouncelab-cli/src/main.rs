//! The command `bouncelab`.

fn main() {}
