//! The built program, run as a person or a script runs it.

mod bad_input;
mod bench;
mod denoise;
mod help;
mod inspect;
mod interrupt;
mod render;
mod resume;
mod support;
mod sweep;
mod templates;
