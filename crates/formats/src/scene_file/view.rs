//! What a file should say of a section or entry.

use super::section::{ABOUT_KEY, NAME_KEY, Section};
use super::text::{Style, ValueText};
use vitrine_scene::{Item, ListName, ParamKind, ParamSpec, Params, Scene, Value};

/// One key with its value.
#[derive(Clone, Debug)]
pub(super) struct Statement {
    /// The key.
    pub key: &'static str,
    /// The value; nothing where the file must not have the key.
    pub value: Value,
    /// The parameter's description; None for the name and the kind.
    pub spec: Option<&'static ParamSpec>,
}

impl Statement {
    fn text(key: &'static str, text: &str) -> Self {
        Self { key, value: Value::Text(text.to_owned()), spec: None }
    }

    /// Whether a file without the key would say something else.
    pub fn is_needed(&self) -> bool {
        self.value != Value::Nothing && self.spec.is_none_or(|s| s.required || (s.default)() != self.value)
    }

    /// The value as a file writes it.
    pub fn value_text(&self, style: Style) -> Option<ValueText> {
        ValueText::of(&self.value, self.spec.map_or(ParamKind::Text, |s| s.kind), style)
    }
}

/// A section or entry with all that can be said of it, in the order of a file.
#[derive(Clone, Debug)]
pub(super) struct View {
    /// Where it belongs.
    pub section: Section,
    /// All of its keys.
    pub statements: Vec<Statement>,
}

impl View {
    /// A section that stands once.
    pub fn single(section: Section, params: &dyn Params) -> Self {
        Self { section, statements: statements(params).collect() }
    }

    /// The line on what the scene shows.
    pub fn about(scene: &Scene) -> Statement {
        let statement = Statement::text(ABOUT_KEY, &scene.about);
        if scene.about.is_empty() { Statement { value: Value::Nothing, ..statement } } else { statement }
    }

    /// The entries of a list.
    pub fn list(scene: &Scene, list: ListName) -> Vec<Self> {
        fn views<T: Item>(items: &[T]) -> Vec<View> {
            items.iter().map(View::item).collect()
        }
        match list {
            ListName::Object => views(&scene.objects),
            ListName::Light => views(&scene.lights),
            ListName::Material => views(&scene.materials),
            ListName::Texture => views(&scene.textures),
            ListName::Group => views(&scene.groups),
        }
    }

    fn item<T: Item>(item: &T) -> Self {
        let name = Statement::text(NAME_KEY, item.name());
        let kind = item.kind().map(|(key, word)| Statement::text(key, word));
        let of_kind = item.kind_params().into_iter().flat_map(statements);
        let statements = std::iter::once(name).chain(kind).chain(of_kind).chain(statements(item)).collect();
        Self { section: Section::of::<T>(), statements }
    }

    /// Its name; empty when it has none.
    pub fn name(&self) -> &str {
        match self.statements.first() {
            Some(Statement { key: NAME_KEY, value: Value::Text(name), .. }) => name,
            _ => "",
        }
    }

    /// Whether nothing needs to be said.
    pub fn is_default(&self) -> bool {
        !self.statements.iter().any(Statement::is_needed)
    }

    /// The lines of a new section or entry: all that is needed.
    pub fn block(&self, newline: &str) -> String {
        format!("{}{newline}{}", self.section.header(), lines(&self.statements, newline))
    }

    /// What two entries have in common that differ in nothing but their name.
    pub fn nameless_block(&self) -> String {
        lines(self.statements.get(1..).unwrap_or_default(), "\n")
    }
}

fn statements(params: &dyn Params) -> impl Iterator<Item = Statement> {
    let statement = |spec: &'static ParamSpec| {
        let value = params.get(spec.name).unwrap_or(Value::Nothing);
        Statement { key: spec.name, value, spec: Some(spec) }
    };
    params.specs().iter().map(statement)
}

fn lines(statements: &[Statement], newline: &str) -> String {
    let needed = statements.iter().filter(|s| s.is_needed());
    let line = |s: &Statement| s.value_text(Style::Short).map(|text| format!("{} = {text}{newline}", s.key));
    needed.filter_map(line).collect()
}
