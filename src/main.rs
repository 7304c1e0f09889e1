//! The `grazing` command.

fn main() {}
