//! The project's own chores: `cargo xtask check`, `layers`, `docs`.
fn main() {}
