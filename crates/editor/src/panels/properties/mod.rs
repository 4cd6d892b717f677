//! The panel of properties: what is selected, with a control for each of its parameters. With nothing selected it shows the
//! scene and its picture.

mod ask;
mod camera;
mod material;
mod object;
mod scene;

use crate::action::Actions;
use crate::document::{Document, EditCommand, Thing};
use crate::text::{kind_name_in, tr};
use crate::theme::{self, icon_font, icons};
use crate::widgets::{Edit, Field, Shown, icon_toggle, text_field};
use ask::Ask;
use eframe::egui::{Align, Label, Layout, RichText, ScrollArea, Ui};
use vitrine::math::Axis;
use vitrine::scene::{ListName, Owner, Scene, Value};

/// What the panel remembers between frames.
#[derive(Clone, Debug, PartialEq)]
pub struct PropertiesState {
    /// Whether one factor of a size changes the others alike.
    pub keep_shape: bool,
    /// The axis about which the camera is turned.
    pub turn_axis: Axis,
    /// By how many degrees.
    pub turn_angle_deg: f32,
}

impl Default for PropertiesState {
    fn default() -> Self {
        Self { keep_shape: true, turn_axis: Axis::Y, turn_angle_deg: 15.0 }
    }
}

/// Draws the panel.
pub fn properties_ui(ui: &mut Ui, document: &Document, state: &mut PropertiesState, actions: &mut Actions) {
    let scene = document.scene();
    let things = document.selection().things();
    let mut ask = Ask { scene, actions };
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
        let sizes = &theme::of(ui).sizes;
        ui.spacing_mut().item_spacing.y = sizes.gap_m;
        // Room for the bar that scrolls.
        ui.set_max_width(ui.available_width() - sizes.gap_s);
        match things {
            [] | [Thing::Settings] => scene::scene_ui(ui, &mut ask),
            [Thing::Camera] => camera::camera_ui(ui, &mut ask, state),
            [thing] => ui.push_id(thing.name(), |ui| item_ui(ui, &mut ask, thing, state)).inner,
            many => object::several_ui(ui, &mut ask, many),
        }
    });
}

fn item_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing, state: &mut PropertiesState) {
    let Thing::Item(list, name) = thing else { return };
    header_ui(ui, ask, thing);
    match list {
        ListName::Object => object::object_ui(ui, ask, name, state),
        ListName::Light => object::light_ui(ui, ask, name),
        ListName::Group => object::group_ui(ui, ask, name, state),
        ListName::Material => material::parameters_ui(ui, ask, name),
        ListName::Texture => material::texture_ui(ui, ask, name),
    }
}

/// What it is, its name, and whether it is shown.
fn header_ui(ui: &mut Ui, ask: &mut Ask<'_>, thing: &Thing) {
    let Some(owner) = thing.owner(ask.scene) else { return };
    let (list, word) = (thing.list().unwrap_or(ListName::Object), kind_word(ask.scene, owner));
    ui.horizontal(|ui| {
        title_ui(ui, icons::of_item(list, word), &kind_name_in(list, word));
        let visible = ask.scene.value(owner, "visible");
        if let Some(Value::Flag(visible)) = visible {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let icon = if visible { icons::SHOWN } else { icons::HIDDEN };
                let tooltip = tr!("properties-show.tooltip");
                if icon_toggle(ui, icon, visible, &tr!("properties-show"), &tooltip).clicked() {
                    let things = vec![thing.clone()];
                    ask.edit(EditCommand::Show { things, visible: !visible });
                }
            });
        }
    });
    let (label, tooltip) = (tr!("properties-name"), tr!("properties-name.tooltip"));
    let field = Field { label: &label, tooltip: &tooltip, shown: Shown::Stated };
    if let Some(Edit { value: name, .. }) = text_field(ui, &field, thing.name().unwrap_or_default()) {
        ask.edit(EditCommand::Rename { thing: thing.clone(), name });
    }
}

/// The title of the panel: an icon and what is shown.
fn title_ui(ui: &mut Ui, icon: &str, title: &str) {
    let theme = theme::of(ui);
    ui.label(RichText::new(icon).font(icon_font(theme.sizes.icon_tool)).color(theme.accent));
    let text = RichText::new(title).color(theme.text_strong).size(theme.sizes.text_section);
    ui.add(Label::new(text).wrap());
}

/// The word of a thing's kind, or of its list when there are no kinds.
fn kind_word(scene: &Scene, owner: Owner) -> &'static str {
    use vitrine::scene::Item;
    let kind = match owner {
        Owner::Settings => return "settings",
        Owner::Camera => return "camera",
        Owner::Item(ListName::Object, i) => scene.objects.get(i).and_then(Item::kind),
        Owner::Item(ListName::Light, i) => scene.lights.get(i).and_then(Item::kind),
        Owner::Item(ListName::Texture, i) => scene.textures.get(i).and_then(Item::kind),
        Owner::Item(list, _) => return list.key(),
    };
    kind.map_or("object", |(_, word)| word)
}

/// A muted remark below a control.
fn remark_ui(ui: &mut Ui, text: &str) {
    let theme = theme::of(ui);
    ui.add(Label::new(RichText::new(text).size(theme.sizes.text_small).color(theme.text_muted)).wrap());
}
