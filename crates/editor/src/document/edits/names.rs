//! Names that nobody has yet: "ball", "ball 2", "ball 3".

use std::collections::{HashMap, HashSet};
use vitrine::scene::{ListName, Scene};

/// The names of a list that are taken.
#[derive(Debug)]
pub(in crate::document) struct Names {
    taken: HashSet<String>,
    /// Below it all numbers after a word are taken.
    next: HashMap<String, u64>,
}

impl Names {
    pub(in crate::document) fn of(scene: &Scene, list: ListName) -> Self {
        Self::among(scene.names(list))
    }

    /// Of a list that is not in a scene yet.
    pub(in crate::document) fn among<'a>(taken: impl Iterator<Item = &'a str>) -> Self {
        Self { taken: taken.map(str::to_owned).collect(), next: HashMap::new() }
    }

    /// The name itself, or with the next free number when it is taken. It is taken from now on.
    pub(in crate::document) fn take(&mut self, name: &str) -> String {
        // An empty name is refused later, with all else that makes a scene mean nothing.
        if name.trim().is_empty() || self.taken.insert(name.to_owned()) {
            return name.to_owned();
        }
        let word = word_of(name);
        let next = self.next.entry(word.to_owned()).or_insert(2);
        loop {
            let numbered = format!("{word} {next}");
            *next += 1;
            if self.taken.insert(numbered.clone()) {
                return numbered;
            }
        }
    }
}

/// A name without the number at its end: "ball" of "ball 2".
pub(in crate::document) fn word_of(name: &str) -> &str {
    match name.rsplit_once(' ') {
        Some((word, number)) if !word.trim().is_empty() && number.parse::<u64>().is_ok() => word,
        _ => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::Object;

    #[test]
    fn a_taken_name_gets_the_next_free_number() {
        let object = |name: &str| Object { name: name.into(), ..Object::default() };
        let scene = Scene { objects: ["ball", "ball 3", "2"].map(object).to_vec(), ..Scene::default() };
        let mut names = Names::of(&scene, ListName::Object);
        let taken: Vec<_> = ["box", "ball", "ball 3", "ball", "2"].map(|n| names.take(n)).into();
        assert_eq!(taken, ["box", "ball 2", "ball 4", "ball 5", "2 2"]);
    }
}
