//! Controls. Each has a label, a tooltip and an accessible name, shows its unit, and gives back what a person has asked
//! for; none of them changes anything itself. [`param_ui`] draws the right one for a parameter from its description.

mod buttons;
mod choice;
mod color;
mod field;
mod number;
mod number_text;
mod param;
mod picker;
mod section;
mod slider;
mod text_fields;
mod texture;
mod vector;

pub use buttons::{icon_button, icon_toggle, link_button, primary_button, text_button, toggle, tool_button};
pub use choice::choice_field;
pub use color::{color_field, swatch};
pub use field::{Edit, Field, Shown, describe, new_gesture};
pub use number::{Number, number_field};
pub use param::{ParamEdit, ParamField, param_ui};
pub use section::{empty_hint, section, subsection};
pub use slider::slider_with_value;
pub use text_fields::{FileAnswer, file_field, search_field, text_field};
pub use texture::{TextureAnswer, texture_chooser};
pub use vector::vector_field;
