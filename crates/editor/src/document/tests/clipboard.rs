//! Copying and pasting as text.

use super::*;
use vitrine::scene::ListName;

#[test]
fn a_group_with_its_texture_comes_whole_into_another_scene() {
    let document = shelf();
    let text = copy(document.scene(), &[Thing::group("shelf")]);
    let mut other = Document::default();
    edit(&mut other, EditCommand::Paste(text));
    assert_eq!(other.selection().things(), [Thing::group("shelf")]);
    let scene = other.scene();
    assert_eq!(scene.names(ListName::Object).collect::<Vec<_>>(), ["ball", "box"]);
    assert_eq!(scene.names(ListName::Material).collect::<Vec<_>>(), ["tiled"]);
    assert_eq!(scene.names(ListName::Texture).collect::<Vec<_>>(), ["tiles"]);
    assert_eq!(scene.group("shelf"), document.scene().group("shelf"));
    assert_eq!(scene.object("ball"), document.scene().object("ball"));
    assert_near(point(&other, "ball", Vec3::ZERO), point(&document, "ball", Vec3::ZERO));
}

#[test]
fn pasted_beside_the_original_it_has_another_name_and_shares_the_material() {
    let mut document = shelf();
    let text = copy(document.scene(), &[Thing::group("shelf")]);
    edit(&mut document, EditCommand::Paste(text.clone()));
    edit(&mut document, EditCommand::Paste(text));
    let scene = document.scene();
    assert_eq!(scene.names(ListName::Group).collect::<Vec<_>>(), ["shelf", "shelf 2", "shelf 3"]);
    assert_eq!(scene.materials.len(), 2);
    assert_eq!(object(&document, "ball 2").group.as_deref(), Some("shelf 2"));
    assert_eq!(object(&document, "box 3").group.as_deref(), Some("shelf 3"));
    // None of the three stands where another does.
    let places: Vec<_> = scene.groups.iter().map(|g| g.position).collect();
    assert!(places[0] != places[1] && places[1] != places[2] && places[0] != places[2], "{places:?}");
}

#[test]
fn cut_and_pasted_everything_is_where_it_was() {
    let mut document = shelf();
    let before = point(&document, "pane", Vec3::ZERO);
    let text = copy(document.scene(), &objects(["pane"]));
    edit(&mut document, EditCommand::Delete(objects(["pane"])));
    edit(&mut document, EditCommand::Paste(text));
    assert_near(point(&document, "pane", Vec3::ZERO), before);
    assert_eq!(object(&document, "pane").material.as_deref(), Some("glass"));
    assert_eq!(document.scene().materials.len(), 2);
}

#[test]
fn without_its_group_a_member_stands_where_it_stood() {
    let document = shelf();
    let text = copy(document.scene(), &objects(["box"]));
    assert!(!text.contains("[[group]]"), "{text}");
    let mut other = Document::default();
    edit(&mut other, EditCommand::Paste(text));
    for corner in [Vec3::ZERO, Vec3::ONE, Vec3::NEG_X] {
        assert_near(point(&other, "box", corner), point(&document, "box", corner));
    }
}

#[test]
fn a_member_that_is_askew_brings_its_group() {
    let mut document = shelf();
    let by = Vec3::new(1.0, 3.0, 0.5);
    edit(&mut document, EditCommand::Resize { things: vec![Thing::group("shelf")], by });
    let text = copy(document.scene(), &objects(["box"]));
    let mut other = Document::default();
    edit(&mut other, EditCommand::Paste(text));
    assert_near(point(&other, "box", Vec3::ONE), point(&document, "box", Vec3::ONE));
    assert_eq!(other.scene().objects.len(), 1, "the other member stays at home");
}

#[test]
fn a_piece_of_a_scene_file_can_be_pasted() {
    let mut document = shelf();
    edit(&mut document, EditCommand::Paste("[[object]]\nname = \"moon\"\nshape = \"sphere\"\n".into()));
    assert_eq!(document.selection().things(), objects(["moon"]));
}

#[test]
fn what_is_no_scene_is_refused_with_its_line() {
    let mut document = shelf();
    for (text, wanted) in [
        ("format = 1\n\n[[object]]\nname = \"moon\"\nshape = \"sphere\"\nradius = -1\n", 6),
        ("[[object]]\nname = \"moon\"\nshape = \"spere\"\n", 3),
        ("Hello there, this is a letter", 1),
    ] {
        let EditError::NotAScene { line, reason, help } =
            refused(&mut document, EditCommand::Paste(text.into()))
        else {
            panic!("{text}")
        };
        assert_eq!(line, wanted, "{text}: {reason}");
        assert!(!reason.is_empty() && !help.is_empty());
    }
    assert_eq!(refused(&mut document, EditCommand::Paste(" \n".into())), EditError::NothingToAdd);
    assert_eq!(copy(document.scene(), &[Thing::Camera]), "");
}
