//! The icons, by what they mean.

use vitrine::scene::ListName;

pub use egui_phosphor::regular::{
    ARROW_CLOCKWISE as REDO, ARROW_COUNTER_CLOCKWISE as UNDO, ARROW_LINE_DOWN as DROP_TO_FLOOR,
    ARROWS_CLOCKWISE as TURN, ARROWS_OUT_CARDINAL as MOVE, BOOK_OPEN as GLOSSARY, CAMERA,
    CARET_DOWN as OPEN_DOWN, CARET_LEFT as BACK, CARET_RIGHT as OPEN_RIGHT, CHECK, CHECKERBOARD as PATTERN,
    CIRCLE as DISC, CLIPBOARD as PASTE, CLOCK as TIME, CLOUD_SUN as SKY, COPY, CORNERS_OUT as FRAME,
    CPU as THREADS, CROSSHAIR as FOCUS, CUBE as BOX, CUBE_FOCUS as MODEL, DOTS_THREE as MORE,
    DOWNLOAD_SIMPLE as SAVE_PICTURE, EYE as SHOWN, EYE_SLASH as HIDDEN, FILE_PLUS as NEW,
    FLOPPY_DISK as SAVE, FOLDER as GROUP, FOLDER_OPEN as OPEN, GEAR as SETTINGS, GRADUATION_CAP as TOUR,
    HEARTBEAT as DOCTOR, IMAGE as PICTURE, INFO, KEYBOARD as SHORTCUTS, LAMP_PENDANT as DISC_LAMP,
    LIGHTBULB as POINT, LIGHTBULB_FILAMENT as ROUND_BULB, LOCK, LOCK_OPEN as UNLOCK,
    MAGNIFYING_GLASS as SEARCH, PAINT_BUCKET as PAINT, PALETTE as MATERIAL, PANORAMA, PARALLELOGRAM as PLANE,
    PENCIL_SIMPLE as RENAME, PLAY as START, PLUS as ADD, QUESTION as HELP, RESIZE as SIZE, SCISSORS as CUT,
    SLIDERS_HORIZONTAL as EDIT, SPHERE, STACK as DUPLICATE, STOP, SUN as DIRECTIONAL, SUN_DIM as AMBIENT,
    TRANSLATE as LANGUAGE, TRASH as DELETE, TRIANGLE, WARNING, X as CLOSE,
};

/// The icon of a kind of a list's entries: a "disc" among the lights is a lamp, among
/// the objects it is not.
#[must_use]
pub fn of_item(list: ListName, word: &str) -> &'static str {
    match (list, word) {
        (ListName::Light, "disc") => DISC_LAMP,
        (ListName::Light, "sphere") => ROUND_BULB,
        _ => of_kind(word),
    }
}

/// The icon of a kind of object, light or texture, or of a part of the scene, by its word.
#[must_use]
pub fn of_kind(word: &str) -> &'static str {
    match word {
        "sphere" => SPHERE,
        "box" => BOX,
        "plane" => PLANE,
        "triangle" => TRIANGLE,
        "mesh" => MODEL,
        "ambient" => AMBIENT,
        "point" => POINT,
        "directional" => DIRECTIONAL,
        "disc" => DISC,
        "environment" => PANORAMA,
        "sky" => SKY,
        "camera" => CAMERA,
        "group" => GROUP,
        "material" => MATERIAL,
        "texture" | "checker" => PATTERN,
        "picture" => PICTURE,
        "settings" => EDIT,
        _ => MODEL,
    }
}
