//! Every key of the window, once: the menu writes them beside its entries, the help lists them, and [`asked_for`] turns
//! pressed keys into actions.

use crate::action::{Action, Actions, Screen};
use crate::document::{Document, EditCommand, Thing};
use eframe::egui::{Context, Event, Key, KeyboardShortcut, Modifiers};
use vitrine::scene::{ListName, Value};

/// A part of the list of keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// Scenes and files.
    File,
    /// Changes of the scene.
    Edit,
    /// What is seen, and the handles.
    View,
    /// The finished picture.
    Render,
}

impl Section {
    /// The key of its text.
    #[must_use]
    pub const fn text_key(self) -> &'static str {
        match self {
            Self::File => "shortcut-section-file",
            Self::Edit => "shortcut-section-edit",
            Self::View => "shortcut-section-view",
            Self::Render => "shortcut-section-render",
        }
    }
}

/// Keys that do something.
#[derive(Clone, Copy, Debug)]
pub struct Shortcut {
    /// Its word: "save-as". Its text has the key `shortcut-save-as`.
    pub id: &'static str,
    /// Where it is listed.
    pub section: Section,
    /// The keys.
    pub keys: KeyboardShortcut,
    /// What they ask for; None when whoever has the focus answers them itself (renaming, handles).
    pub action: Option<fn(&Document) -> Option<Action>>,
}

impl Shortcut {
    /// The key of its text.
    #[must_use]
    pub fn text_key(&self) -> String {
        format!("shortcut-{}", self.id)
    }

    /// Its keys for people: "Ctrl+Shift+S".
    #[must_use]
    pub fn keys_text(&self, ctx: &Context) -> String {
        ctx.format_shortcut(&self.keys).replace("Comma", ",")
    }
}

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

const fn bare(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const fn ctrl(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn ctrl_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(CTRL_SHIFT, key)
}

macro_rules! shortcuts {
    ($($section:ident { $($id:literal: $keys:expr $(=> $action:expr)?;)* })*) => {
        &[$($(Shortcut {
            id: $id,
            section: Section::$section,
            keys: $keys,
            action: shortcuts!(@action $($action)?),
        },)*)*]
    };
    (@action $action:expr) => { Some($action) };
    (@action) => { None };
}

/// Every key, section by section.
pub const SHORTCUTS: &[Shortcut] = shortcuts! {
    File {
        "new": ctrl(Key::N) => |_| Some(Action::New);
        "open": ctrl(Key::O) => |_| Some(Action::Open);
        "save": ctrl(Key::S) => |_| Some(Action::Save);
        "save-as": ctrl_shift(Key::S) => |_| Some(Action::SaveAs);
        "settings": ctrl(Key::Comma) => |_| Some(Action::Show(Screen::Settings));
        "help": bare(Key::F1) => |_| Some(Action::Show(Screen::Shortcuts));
        "quit": ctrl(Key::Q) => |_| Some(Action::Quit);
    }
    Edit {
        "undo": ctrl(Key::Z) => |_| Some(Action::Undo);
        "redo": ctrl_shift(Key::Z) => |_| Some(Action::Redo);
        "cut": ctrl(Key::X) => |d| selected(d).map(|_| Action::Cut);
        "copy": ctrl(Key::C) => |d| selected(d).map(|_| Action::Copy);
        "paste": ctrl(Key::V) => |_| Some(Action::Paste);
        "duplicate": ctrl(Key::D) => |d| selected(d).map(EditCommand::Duplicate).map(Action::Edit);
        "delete": bare(Key::Delete) => |d| selected(d).map(EditCommand::Delete).map(Action::Edit);
        "rename": bare(Key::F2);
        "select-all": ctrl(Key::A) => |_| Some(Action::SelectAll);
        "group": ctrl(Key::G) => |d| selected(d).map(EditCommand::Group).map(Action::Edit);
        "ungroup": ctrl_shift(Key::G) => |d| selected(d).map(EditCommand::Ungroup).map(Action::Edit);
        "hide": bare(Key::H) => show_or_hide;
        "drop": bare(Key::End) => |d| selected(d).map(EditCommand::DropToFloor).map(Action::Edit);
    }
    View {
        "frame": bare(Key::F) => |d| Some(Action::Frame(d.selection().things().to_vec()));
        "frame-all": bare(Key::Home) => |_| Some(Action::Frame(Vec::new()));
        "move": bare(Key::W);
        "turn": bare(Key::E);
        "size": bare(Key::R);
        "escape": bare(Key::Escape);
    }
    Render {
        "start": bare(Key::F5) => |_| Some(Action::StartRender);
        "stop": KeyboardShortcut::new(Modifiers::SHIFT, Key::F5) => |_| Some(Action::StopRender);
        "save-picture": ctrl(Key::P) => |_| Some(Action::SavePicture);
    }
};

/// The shortcut of that word.
#[must_use]
pub fn shortcut(id: &str) -> Option<&'static Shortcut> {
    SHORTCUTS.iter().find(|s| s.id == id)
}

/// Asks for what the pressed keys mean. While a text is being typed, or a dialog is open, keys belong to it. Call it
/// before anything is drawn.
pub fn asked_for(ctx: &Context, document: &Document, actions: &mut Actions) {
    let is_dialog_open = ctx.memory(|m| m.top_modal_layer().is_some());
    if is_dialog_open || ctx.text_edit_focused() {
        return;
    }
    // Keys with more modifiers first: Ctrl+S must not take what Ctrl+Shift+S means.
    let by_modifiers =
        |with_shift: bool| SHORTCUTS.iter().filter(move |s| s.keys.modifiers.shift == with_shift);
    for shortcut in by_modifiers(true).chain(by_modifiers(false)) {
        let Some(action) = shortcut.action else { continue };
        if ctx.input_mut(|i| i.consume_shortcut(&shortcut.keys)) {
            actions.extend(action(document));
        }
    }
    // The system turns these keys into events of their own.
    let clipboard = ctx.input(|i| {
        let id = |event: &Event| match event {
            Event::Cut => Some("cut"),
            Event::Copy => Some("copy"),
            Event::Paste(_) => Some("paste"),
            _ => None,
        };
        i.events.iter().filter_map(id).collect::<Vec<_>>()
    });
    let asked = clipboard.into_iter().filter_map(shortcut).filter_map(|s| s.action);
    actions.extend(asked.filter_map(|action| action(document)));
}

/// What is selected and can be copied, deleted and grouped; None when nothing is.
fn selected(document: &Document) -> Option<Vec<Thing>> {
    let things = document.selection().things().iter().filter(|t| t.list().is_some());
    let things: Vec<_> = things.cloned().collect();
    (!things.is_empty()).then_some(things)
}

/// Hides what is selected, or shows it when all of it is hidden.
fn show_or_hide(document: &Document) -> Option<Action> {
    let can_hide = |t: &Thing| matches!(t.list(), Some(ListName::Object | ListName::Light | ListName::Group));
    let things: Vec<_> = selected(document)?.into_iter().filter(can_hide).collect();
    let scene = document.scene();
    let is_seen =
        |t: &Thing| t.owner(scene).and_then(|o| scene.value(o, "visible")) == Some(Value::Flag(true));
    let visible = !things.iter().any(is_seen);
    (!things.is_empty()).then_some(Action::Edit(EditCommand::Show { things, visible }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::RawInput;

    fn pressed(events: Vec<Event>) -> Actions {
        let ctx = Context::default();
        let mut actions = Actions::new();
        let input = RawInput { events, ..RawInput::default() };
        let mut output = ctx.run_ui(input, |ui| asked_for(ui.ctx(), &Document::default(), &mut actions));
        output.textures_delta.clear();
        actions
    }

    fn key(key: Key, modifiers: Modifiers) -> Vec<Event> {
        vec![Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers }]
    }

    #[test]
    fn no_keys_mean_two_things_and_no_word_stands_twice() {
        for (i, a) in SHORTCUTS.iter().enumerate() {
            for b in &SHORTCUTS[i + 1..] {
                assert_ne!(a.id, b.id);
                assert_ne!(a.keys, b.keys, "{} and {}", a.id, b.id);
            }
        }
    }

    #[test]
    fn keys_ask_for_what_the_list_says() {
        assert_eq!(pressed(key(Key::S, Modifiers::COMMAND)), [Action::Save]);
        assert_eq!(pressed(key(Key::S, CTRL_SHIFT)), [Action::SaveAs]);
        assert_eq!(pressed(key(Key::Home, Modifiers::NONE)), [Action::Frame(Vec::new())]);
        assert_eq!(pressed(vec![Event::Paste("x".into())]), [Action::Paste]);
    }

    #[test]
    fn nothing_selected_means_nothing_to_delete() {
        assert_eq!(pressed(key(Key::Delete, Modifiers::NONE)), []);
        assert_eq!(pressed(key(Key::H, Modifiers::NONE)), []);
    }
}
