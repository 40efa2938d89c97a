//! The command line `regge-verify`.

fn main() {}
