//! From a parsed file to the scene, with everything that is wrong on the way.

use super::finding::{Finding, Findings};
use super::outline::{Entry, Outline};
use super::section::{ABOUT_KEY, FORMAT, FORMAT_KEY, NAME_KEY, Section};
use super::value::{read_value, type_words};
use super::wording::{self, StrayKey, title};
use std::ops::Range;
use toml_edit::{Item as TomlItem, Table};
use vitrine_scene::{Cause, Item, Owner, ParamSpec, Params, Problem, Scene, Severity, Value, params};

/// Reads a document whose text is `source`. The scene means something only if no finding is an error.
pub(super) fn read_scene(root: &Table, source: &str) -> (Scene, Findings) {
    let mut reader = Reader { source, findings: Findings::default() };
    if !reader.check_format(root) {
        return (Scene::default(), reader.findings);
    }
    let outline = Outline::read(root, &mut reader.findings);
    reader.check_sections(root);
    let mut scene = Scene { about: reader.about(root), ..Scene::default() };
    if let Some(entry) = &outline.settings {
        reader.section(entry, Section::SETTINGS, &mut scene.settings);
    }
    if let Some(entry) = &outline.camera {
        reader.section(entry, Section::CAMERA, &mut scene.camera);
    }
    scene.lights = reader.list(&outline);
    scene.textures = reader.list(&outline);
    scene.materials = reader.list(&outline);
    scene.groups = reader.list(&outline);
    scene.objects = reader.list(&outline);
    reader.whole_scene(&scene, &outline);
    (scene, reader.findings)
}

struct Reader<'d> {
    source: &'d str,
    findings: Findings,
}

impl Reader<'_> {
    /// Whether the file is of the format that this program knows. A missing version is reported and passes.
    fn check_format(&mut self, root: &Table) -> bool {
        let Some(item) = root.get(FORMAT_KEY) else {
            self.findings.add(0..0, wording::missing_format);
            return true;
        };
        if item.as_integer() == Some(FORMAT) {
            return true;
        }
        let is_newer = item.as_integer().is_some_and(|v| v > FORMAT);
        let span = item.span().or_else(|| root.key(FORMAT_KEY)?.span()).unwrap_or_default();
        self.findings.add(span, |span| wording::other_format(span, is_newer));
        false
    }

    /// Reports what stands at the top and belongs elsewhere or nowhere.
    fn check_sections(&mut self, root: &Table) {
        let words: Vec<_> =
            [FORMAT_KEY, ABOUT_KEY].into_iter().chain(Section::all().map(|s| s.word)).collect();
        for (key, item) in root {
            if words.contains(&key) {
                continue;
            }
            let key_span = root.key(key).and_then(toml_edit::Key::span);
            let span = if item.is_value() { key_span } else { item.span().or(key_span) };
            self.findings
                .add(span.unwrap_or_default(), |span| wording::stray_top_key(span, key, item, &words));
        }
    }

    fn about(&mut self, root: &Table) -> String {
        let Some(item) = root.get(ABOUT_KEY) else { return String::new() };
        let text = item.as_str();
        if text.is_none() {
            let found = item.as_value().map_or("a section", type_words);
            self.findings.add(item.span().unwrap_or_default(), |span| {
                let message = format!("`{ABOUT_KEY}` takes a text in quotes, not {found}");
                Finding::error(span, message, found, "write one line on what the scene shows")
            });
        }
        text.unwrap_or_default().to_owned()
    }

    /// Reads a section that stands once.
    fn section(&mut self, entry: &Entry, section: Section, target: &mut dyn Params) {
        for (key, item) in entry.table.iter() {
            match section.specs.iter().find(|s| s.name == key) {
                Some(spec) => {
                    self.param(entry, spec, item, &mut |value| params::set(target, spec.name, value).is_ok());
                }
                None => self.stray_key(entry, key, section, None),
            }
        }
    }

    fn list<T: Item + Default>(&mut self, outline: &Outline) -> Vec<T> {
        outline.list(T::LIST).iter().map(|entry| self.entry(entry)).collect()
    }

    /// Reads one entry of a list.
    fn entry<T: Item + Default>(&mut self, entry: &Entry) -> T {
        let section = Section::of::<T>();
        let mut item = T::default();
        item.rename(self.name(entry, section));
        let kind_is_known = self.kind(entry, section, &mut item);
        let kind_specs = item.kind_params().map_or(&[][..], Params::specs);
        for (key, value) in entry.table.iter() {
            if key == NAME_KEY || section.kinds.is_some_and(|k| k.key == key) {
                continue;
            }
            let own = T::OWN_SPECS.iter().find(|s| s.name == key);
            let of_kind = kind_specs.iter().find(|s| s.name == key && kind_is_known);
            match (own, of_kind) {
                (Some(spec), _) => {
                    self.param(entry, spec, value, &mut |v| params::set(&mut item, spec.name, v).is_ok());
                }
                (None, Some(spec)) => self.param(entry, spec, value, &mut |v| {
                    item.kind_params_mut().is_some_and(|p| params::set(p, spec.name, v).is_ok())
                }),
                // Before the kind is mended nobody can say which keys it has.
                (None, None) if !kind_is_known && section.knows(key) => {}
                (None, None) => self.stray_key(entry, key, section, item.kind().map(|k| k.1)),
            }
        }
        let required = T::OWN_SPECS.iter().chain(kind_specs.iter().filter(|_| kind_is_known));
        for spec in required.filter(|s| s.required && !entry.table.contains_key(s.name)) {
            let title = title(section, item.name());
            self.findings.add(entry.span.clone(), |span| wording::missing_key(span, spec, &title));
        }
        item
    }

    /// The entry's name; empty, and reported, when there is none.
    fn name(&mut self, entry: &Entry, section: Section) -> String {
        let item = entry.table.get(NAME_KEY);
        if let Some(name) = item.and_then(TomlItem::as_str) {
            return name.to_owned();
        }
        let found = item.map(|i| i.as_value().map_or("a section", type_words));
        self.findings.add(entry.value_span(NAME_KEY), |span| wording::bad_name(span, section, found));
        String::new()
    }

    /// Gives the item its kind; false, and reported, when the file does not say which.
    fn kind<T: Item>(&mut self, entry: &Entry, section: Section, item: &mut T) -> bool {
        let Some(kinds) = section.kinds else { return true };
        let word = entry.table.get(kinds.key);
        if word.and_then(TomlItem::as_str).is_some_and(|w| item.set_kind(w)) {
            return true;
        }
        let title = title(section, item.name());
        self.findings.add(entry.value_span(kinds.key), |span| match word {
            None => wording::missing_kind(span, kinds, &title),
            Some(word) => wording::unknown_kind(span, kinds, word),
        });
        false
    }

    /// Reads one parameter and stores it.
    fn param(
        &mut self,
        entry: &Entry,
        spec: &ParamSpec,
        item: &TomlItem,
        store: &mut dyn FnMut(Value) -> bool,
    ) {
        let whole = entry.value_span(spec.name);
        let Some(value) = item.as_value() else {
            let help = format!("`{}` takes {}", spec.name, spec.allowed());
            let message = format!("`{}` takes a value, and this is a section", spec.name);
            return self.findings.add(whole, |span| Finding::error(span, message, "a section", help));
        };
        match read_value(spec, value, self.source) {
            Ok(value) => {
                let is_stored = store(value);
                debug_assert!(is_stored, "`{}` was checked", spec.name);
            }
            Err(bad) => {
                let span = bad.span.unwrap_or(whole);
                self.findings.add(span, |span| Finding::error(span, bad.message, bad.label, bad.help));
            }
        }
    }

    fn stray_key(&mut self, entry: &Entry, key: &str, section: Section, kind: Option<&str>) {
        let name = entry.table.get(NAME_KEY).and_then(TomlItem::as_str).unwrap_or_default();
        self.findings.add(entry.key_span(key), |span| {
            StrayKey { key, section, kind, title: title(section, name) }.finding(span)
        });
    }

    /// Reports what is wrong with the scene as a whole.
    fn whole_scene(&mut self, scene: &Scene, outline: &Outline) {
        let has_errors = !self.findings.is_empty();
        for problem in scene.problems() {
            let is_nameless = |owner| {
                let name = outline.entry(owner).and_then(|e| e.table.get(NAME_KEY));
                name.and_then(TomlItem::as_str).is_none()
            };
            let said_already =
                problem.cause == Cause::EmptyName && problem.place.owner.is_some_and(is_nameless);
            // What has been read in part gives warnings that mean nothing.
            if said_already || (has_errors && problem.severity == Severity::Warning) {
                continue;
            }
            let span = place_span(&problem, outline);
            self.findings.add(span, |span| Finding {
                severity: problem.severity,
                message: problem.cause.to_string(),
                label: wording::problem_label(&problem.cause).to_owned(),
                help: problem.cause.help(),
                span,
            });
        }
    }
}

/// Where the text says what the problem is about; the start of the text when it is about the whole scene.
fn place_span(problem: &Problem, outline: &Outline) -> Range<usize> {
    let owner = problem.place.owner;
    let Some(entry) = owner.and_then(|o| outline.entry(o)) else { return 0..0 };
    let of_list = matches!(owner, Some(Owner::Item(..)));
    match problem.place.key.or(of_list.then_some(NAME_KEY)) {
        Some(key) => entry.value_span(key),
        None => entry.span.clone(),
    }
}
