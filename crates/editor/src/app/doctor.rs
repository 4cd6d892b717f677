//! What may be wrong with the scene and with its picture, looked for when either has changed.

use super::notices::words;
use crate::dialogs::{Mend, ProblemLine};
use crate::doctor::{self, Brightness};
use crate::document::Document;
use crate::live::Picture;
use std::sync::Arc;
use vitrine::scene::{Renderer, Severity};

/// What has been found.
#[derive(Default)]
pub struct Doctor {
    /// What is wrong, the gravest first, in the current language.
    pub lines: Vec<ProblemLine>,
    /// For which state of the scene and which picture that was found.
    looked_at: Option<(u64, Option<[u64; 2]>, crate::text::Language)>,
}

impl Doctor {
    /// Looks again if the scene or its picture is another.
    pub fn look(&mut self, document: &Document, picture: Option<&Arc<Picture>>) {
        let is_photoreal = document.scene().settings.renderer == Renderer::Photoreal;
        // A coarse picture is as bright as a fine one: the first of each scene is enough. A photoreal one may be black at first
        // where light comes seldom.
        let seen = picture.map(|p| [p.generation, if is_photoreal { p.pass.into() } else { 0 }]);
        let now = (document.revision(), seen, crate::text::language());
        if self.looked_at == Some(now) {
            return;
        }
        self.looked_at = Some(now);
        let brightness = picture.map(|p| Brightness::of(&p.rgba, &document.scene().settings));
        let diagnoses = doctor::diagnose(document, brightness).into_iter().map(|d| ProblemLine {
            severity: Severity::Warning,
            text: words(&d.message),
            help: String::new(),
            thing: d.things.into_iter().next(),
            mend: Some(Mend { text: words(&d.mend_label), command: d.mend }),
        });
        let mut lines: Vec<_> = diagnoses.collect();
        for problem in doctor::problems(document) {
            let text = words(&problem.message);
            let mend = problem.mend.map(|(label, command)| Mend { text: words(&label), command });
            let thing = problem.things.into_iter().next();
            // What the doctor says with a mend need not be said twice.
            if !lines.iter().any(|line| line.text == text) {
                lines.push(ProblemLine {
                    severity: problem.severity,
                    text,
                    help: String::new(),
                    thing,
                    mend,
                });
            }
        }
        self.lines = lines;
    }
}
