//! What has been done, step by step: each step keeps only the entries that it changed, so hundreds of steps in a scene of
//! thousands of objects take little memory, and undoing needs no code of its own for any command.

use super::Selection;
use super::patch::Patch;
use std::collections::VecDeque;
use vitrine::scene::Scene;

/// A gesture that goes on: all that is done during one drag, or while one field is being typed in, is one step.
pub type Gesture = u64;

/// One step.
#[derive(Clone, Debug)]
struct Step {
    patch: Patch,
    /// What was selected before and after.
    selection: [Selection; 2],
    gesture: Option<Gesture>,
}

/// The steps that can be undone and redone.
#[derive(Debug, Default)]
pub struct History {
    steps: VecDeque<Step>,
    /// How many of the steps are done.
    done: usize,
    /// How many entries all steps hold together.
    entries: usize,
}

impl History {
    /// The most steps that are kept.
    pub const MOST: usize = 1000;
    /// So many steps are kept however large they are.
    pub const LEAST: usize = 250;
    /// Beyond so many entries in all steps together the oldest steps are forgotten.
    const MOST_ENTRIES: usize = 500_000;

    /// Notes a step from one state of the scene to another. What was undone before is forgotten.
    pub fn note(&mut self, scenes: [&Scene; 2], selection: [Selection; 2], gesture: Option<Gesture>) {
        let undone = self.steps.drain(self.done..);
        self.entries -= undone.map(|step| step.patch.len()).sum::<usize>();
        let [before, after] = scenes;
        let [mut selected_before, selected_after] = selection;
        let mut patch = Patch::between(before, after);
        if let Some(last) = self.steps.pop_back_if(|s| gesture.is_some() && s.gesture == gesture) {
            // The step grows: from where the gesture began to here.
            let mut start = before.clone();
            last.patch.undo(&mut start);
            patch = Patch::between(&start, after);
            [selected_before, _] = last.selection;
            self.entries -= last.patch.len();
        }
        self.entries += patch.len();
        self.steps.push_back(Step { patch, selection: [selected_before, selected_after], gesture });
        self.forget();
        self.done = self.steps.len();
    }

    /// Forgets the oldest steps when there are too many.
    fn forget(&mut self) {
        while self.steps.len() > Self::MOST
            || (self.steps.len() > Self::LEAST && self.entries > Self::MOST_ENTRIES)
        {
            self.entries -= self.steps.pop_front().map_or(0, |step| step.patch.len());
        }
    }

    /// Takes the last step back; gives what was selected before it. None when there is nothing to undo.
    pub fn undo(&mut self, scene: &mut Scene) -> Option<Selection> {
        let step = self.steps.get(self.done.checked_sub(1)?)?;
        step.patch.undo(scene);
        self.done -= 1;
        Some(step.selection[0].clone())
    }

    /// Does the last undone step again; gives what was selected after it. None when there is nothing to redo.
    pub fn redo(&mut self, scene: &mut Scene) -> Option<Selection> {
        let step = self.steps.get(self.done)?;
        step.patch.redo(scene);
        self.done += 1;
        Some(step.selection[1].clone())
    }

    /// How many steps can be undone.
    #[must_use]
    pub const fn undoable(&self) -> usize {
        self.done
    }

    /// How many steps can be redone.
    #[must_use]
    pub fn redoable(&self) -> usize {
        self.steps.len() - self.done
    }

    /// How many entries of lists all steps hold together: what the history costs.
    #[must_use]
    pub const fn entries(&self) -> usize {
        self.entries
    }
}
