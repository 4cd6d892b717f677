//! The guided tour.

use crate::support;
use crate::world::*;
use eframe::egui::accesskit::Role;
use eframe::egui::{Ui, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use vitrine::math::Vec3;
use vitrine::scene::{Material, Object};
use vitrine_editor::action::Action;
use vitrine_editor::dialogs::*;
use vitrine_editor::document::{Addition, Document, EditCommand, Paint, Thing};
use vitrine_editor::files::Config;
use vitrine_editor::text::tr;
use vitrine_editor::theme;

fn sphere() -> Object {
    Object { name: "Ball".into(), ..Object::default() }
}

#[test]
fn the_tour_goes_on_when_a_step_has_really_been_done() {
    use vitrine_editor::dialogs::tour::{Tour, TourFacts};
    let mut document = Document::default();
    let mut tour = Tour::begin(&document);
    let look = |tour: &mut Tour, document: &Document, is_rendered, is_saved| {
        tour.look(&TourFacts { document, is_rendered, is_saved });
        tour.step().map(|s| s.word)
    };
    assert_eq!(look(&mut tour, &document, true, true), Some("add"), "later steps wait for the first");
    document.apply(EditCommand::Add(Addition { objects: vec![sphere()], ..Addition::default() })).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("paint"));
    let red = Material {
        name: "Red glass".into(),
        color: Some(vitrine::math::Rgb::new(0.8, 0.05, 0.05)),
        transparency: Some(0.8),
        ..Material::default()
    };
    let blue = Material { color: Some(vitrine::math::Rgb::new(0.05, 0.05, 0.8)), ..red.clone() };
    let paint = |material| EditCommand::Paint {
        things: vec![Thing::object("Ball")],
        material: Box::new(Paint { material, texture: None }),
    };
    document.apply(paint(blue)).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("paint"), "blue glass is not red");
    document.apply(paint(red)).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("move"));
    document.apply(EditCommand::Move { things: vec![Thing::object("Ball")], by: Vec3::X }).unwrap();
    assert_eq!(look(&mut tour, &document, false, false), Some("render"));
    assert_eq!(look(&mut tour, &document, true, false), Some("save"));
    assert_eq!(look(&mut tour, &document, true, true), None);
}

#[test]
fn the_card_of_the_tour_is_whole_in_both_languages_and_can_be_closed() {
    use vitrine_editor::dialogs::tour::{self, Tour, TourFacts};
    both(|language| {
        let world = World::new(language);
        let tour = Some(Tour::begin(&world.document));
        let builder =
            Harness::builder().with_size(vec2(1280.0, 800.0)).renderer(support::CpuRenderer::default());
        let mut is_dressed = false;
        let draw = move |ui: &mut Ui, (world, tour): &mut (World, Option<Tour>)| {
            if !std::mem::replace(&mut is_dressed, true) {
                theme::apply(ui, &world.config);
                return;
            }
            let response = ui.button("Sphere");
            tour::mark(ui, "add-sphere", response.rect);
            let facts = TourFacts { document: &world.document, is_rendered: false, is_saved: false };
            tour_ui(ui, tour, &facts, &world.config, &mut world.actions);
        };
        let mut harness = builder.build_ui_state(draw, (world, tour));
        harness.run();
        harness.get_by_label(&tr!("tour-add"));
        if std::env::var_os("VITRINE_PICTURES").is_some() {
            support::picture(&mut harness, &format!("tour-{}", language.tag()));
        }
        assert_eq!(support::labels_clipped(&harness), [""; 0]);
        for _ in tour::STEPS {
            harness.get_by_role_and_label(Role::Button, &tr!("tour-skip")).click();
            harness.run();
            assert_eq!(support::labels_clipped(&harness), [""; 0]);
        }
        harness.get_by_role_and_label(Role::Button, &tr!("tour-finish")).click();
        harness.run();
        let config = Config { language, tour_seen: true, ..Config::default() };
        assert_eq!(harness.state().0.actions, [Action::Configure(Box::new(config))]);
        assert!(harness.state().1.is_none());
    });
}
