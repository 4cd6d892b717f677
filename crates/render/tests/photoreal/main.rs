//! The photoreal renderer seen from outside: a scene goes in, and what comes out is what theory says. The formulas are those of
//! geometrical optics and radiometry; each test states its own.
//!
//! Light that is found on purpose through glass is proved by light that is found by chance alone ([`chance`]).

mod chance;
mod common;
mod furnace;
mod goldens;
mod job;
mod lamps;
mod panes;
mod shells;
#[path = "../classic/common.rs"]
#[expect(dead_code, reason = "the classic renderer's tests use the rest")]
mod shots;
mod sides;
mod touching;
