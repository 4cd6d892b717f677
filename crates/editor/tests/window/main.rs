//! The whole window, driven by the names that a screen reader says, without a display and without a graphics card: each row
//! of the course work's interface as a story.
#![allow(clippy::unwrap_used, reason = "a story that cannot go on fails")]

#[path = "../support/mod.rs"]
mod support;

mod course_work;
mod editing;
mod everywhere;
mod files;
mod looks;
mod person;
mod picture;
