//! Nothing to see, or the camera where it sees nothing.

use super::{Brightness, Diagnosis};
use crate::document::{
    CameraMove, Document, EditCommand, Message, Thing, bounds_of, bounds_of_all, new_thing, object_bounds,
    plane_level,
};
use vitrine::math::{Bounds3, Vec3};
use vitrine::scene::{Geometry, GroupPlaces, ListName, Object, TriangleMesh};

/// So large a part of the distance to the middle of everything is its radius at least, when it can be made out.
const TOO_FAR: f32 = 0.004;
/// Nearer than this part of a thing's radius the camera sees a speck of its skin.
const TOO_NEAR: f32 = 0.02;
/// From this transparency on a camera inside a thing may be meant so.
const SEEN_THROUGH: f32 = 0.3;

/// What is wrong with what there is to see.
pub(super) fn diagnose(document: &Document, picture: Option<Brightness>) -> Vec<Diagnosis> {
    let scene = document.scene();
    if scene.objects.is_empty() {
        return vec![Diagnosis {
            message: Message::new("doctor-no-object"),
            things: Vec::new(),
            mend_label: Message::new("doctor-mend-add-ball"),
            mend: EditCommand::Add(new_thing(scene, document.assets(), ListName::Object, "sphere")),
        }];
    }
    let places = scene.group_places();
    if !scene.objects.iter().any(|object| places.is_seen(object)) {
        return vec![all_hidden(document)];
    }
    let look = Look { document, places, bounds: bounds_of_all(scene, document.assets()) };
    let first = look.inside().or_else(|| look.under_ground(picture));
    let aimed = first.or_else(|| look.nothing_in_view(picture)).or_else(|| look.wrong_distance());
    aimed.into_iter().collect()
}

fn all_hidden(document: &Document) -> Diagnosis {
    let scene = document.scene();
    let objects: Vec<Thing> = scene.objects.iter().map(|o| Thing::object(&o.name)).collect();
    let groups = scene.groups.iter().map(|g| Thing::group(&g.name));
    let things = objects.iter().cloned().chain(groups).collect();
    Diagnosis {
        message: Message::new("doctor-all-hidden"),
        things: objects,
        mend_label: Message::new("doctor-mend-show-all"),
        mend: EditCommand::Show { things, visible: true },
    }
}

/// A look at the scene from its camera.
struct Look<'a> {
    document: &'a Document,
    places: GroupPlaces<'a>,
    /// Around all that is seen, planes apart.
    bounds: Bounds3,
}

impl Look<'_> {
    fn eye(&self) -> Vec3 {
        self.document.scene().camera.position
    }

    fn forward(&self) -> Vec3 {
        self.document.scene().camera.rotation() * Vec3::NEG_Z
    }

    fn seen(&self) -> impl Iterator<Item = &Object> {
        self.document.scene().objects.iter().filter(|object| self.places.is_seen(object))
    }

    fn box_of(&self, object: &Object) -> Bounds3 {
        object_bounds(object, &self.places.world_from_object(object), self.document.assets())
    }

    /// The camera is in a thing through which one does not see.
    fn inside(&self) -> Option<Diagnosis> {
        let around = self.seen().filter(|object| self.is_opaque(object) && self.holds(object, self.eye()));
        let things: Vec<Thing> = around.map(|object| Thing::object(&object.name)).collect();
        let name = things.first()?.name()?.to_owned();
        let bounds = bounds_of(self.document.scene(), self.document.assets(), &things);
        Some(Diagnosis {
            message: Message::new("doctor-camera-inside").with("name", &name),
            things,
            mend_label: Message::new("doctor-mend-step-out"),
            mend: step_back(&bounds),
        })
    }

    fn is_opaque(&self, object: &Object) -> bool {
        let material = object.material.as_deref().and_then(|name| self.document.scene().material(name));
        material.is_none_or(|material| material.classic().transparency < SEEN_THROUGH)
    }

    fn holds(&self, object: &Object, point: Vec3) -> bool {
        let place = self.places.world_from_object(object);
        let p = place.object_from_world.transform_point3(point);
        match object.shape.as_kind().geometry(self.document.assets()) {
            Some(Geometry::Sphere { radius }) => p.length() < radius,
            Some(Geometry::Box { half }) => (half - p.abs()).cmpgt(Vec3::ZERO).all(),
            Some(Geometry::Mesh(mesh) | Geometry::Facets(mesh)) => {
                mesh.bounds().contains(p) && crossings_are_odd(&mesh, p)
            }
            Some(Geometry::Plane | Geometry::Disc { .. } | Geometry::Triangle { .. }) | None => false,
        }
    }

    /// The camera is under a level plane on which everything stands.
    fn under_ground(&self, picture: Option<Brightness>) -> Option<Diagnosis> {
        let level = |o| plane_level(o, &self.places.world_from_object(o)).filter(|y| *y > self.eye().y);
        let mut grounds = self.seen().filter(|o| self.is_opaque(o));
        let (level, ground) = grounds.find_map(|o| Some((level(o)?, o)))?;
        let stands_above = !self.bounds.is_empty() && self.bounds.center().y > level;
        // Without anything above it a plane may be a ceiling.
        let is_dark = picture.is_some_and(|p| p.black > Brightness::WHOLE);
        if !(stands_above || is_dark) {
            return None;
        }
        let height = if stands_above { self.bounds.size().max_element() } else { 1.0 };
        let by = Vec3::Y * (level + height.max(1e-3) - self.eye().y);
        let target = if stands_above { self.bounds.center() } else { self.eye() + by + self.forward() };
        Some(Diagnosis {
            message: Message::new("doctor-camera-under").with("name", &ground.name),
            things: vec![Thing::object(&ground.name)],
            mend_label: Message::new("doctor-mend-step-up"),
            mend: EditCommand::Several(vec![
                EditCommand::Move { things: vec![Thing::Camera], by },
                EditCommand::Camera(CameraMove::LookAt(target)),
            ]),
        })
    }

    /// No thing is in the picture: all are behind the camera or beside the picture.
    fn nothing_in_view(&self, picture: Option<Brightness>) -> Option<Diagnosis> {
        if self.bounds.is_empty() {
            // Planes alone: whether one sees them only the picture tells.
            let is_empty = picture.is_some_and(|p| p.background > Brightness::WHOLE);
            let plane = self.seen().next().filter(|_| is_empty)?;
            let foot = self.places.world_from_object(plane).point(Vec3::ZERO);
            let target = if foot.distance(self.eye()) > 1e-3 { foot } else { self.eye() - Vec3::Y };
            return Some(Diagnosis {
                message: Message::new("doctor-nothing-in-view"),
                things: vec![Thing::object(&plane.name)],
                mend_label: Message::new("doctor-mend-frame-all"),
                mend: EditCommand::Camera(CameraMove::LookAt(target)),
            });
        }
        let mut boxes = self.seen().map(|object| self.box_of(object)).filter(|b| !b.is_empty());
        if boxes.any(|b| self.may_see(&b)) {
            return None;
        }
        let is_behind = (self.bounds.center() - self.eye()).dot(self.forward()) < 0.0;
        let message = if is_behind { "doctor-all-behind" } else { "doctor-nothing-in-view" };
        Some(self.to_frame_all(message))
    }

    /// Whether a part of the ball around a box can be in the picture.
    fn may_see(&self, bounds: &Bounds3) -> bool {
        let scene = self.document.scene();
        let [width, height] = scene.settings.size.map(|v| v as f32);
        let tan = (scene.camera.view_angle_deg / 2.0).to_radians().tan();
        let p = scene.camera.rotation().transpose() * (bounds.center() - self.eye());
        let radius = bounds.size().length() / 2.0;
        // How far beyond each side of the picture's pyramid the middle is.
        let beyond = |aside: f32, tan: f32| (aside.abs() + p.z * tan) / (1.0 + tan * tan).sqrt();
        -p.z > -radius && beyond(p.x, tan * width / height) < radius && beyond(p.y, tan) < radius
    }

    /// The camera is so far away that all is a dot, or so near that it sees nothing but one spot.
    fn wrong_distance(&self) -> Option<Diagnosis> {
        if self.bounds.is_empty() {
            return None;
        }
        let has_plane = self.seen().any(|object| self.box_of(object).is_empty());
        let (radius, distance) =
            (self.bounds.size().length() / 2.0, self.bounds.center().distance(self.eye()));
        if radius < TOO_FAR * distance && !has_plane {
            return Some(self.to_frame_all("doctor-camera-too-far"));
        }
        let eye = self.eye();
        let near = self.seen().find(|object| {
            let bounds = self.box_of(object);
            let nearest = eye.clamp(bounds.min, bounds.max);
            let in_front = (bounds.center() - eye).dot(self.forward()) > 0.0;
            // In the box of a thing and not in the thing itself is no sign of anything.
            !bounds.is_empty()
                && in_front
                && self.may_see(&bounds)
                && nearest != eye
                && nearest.distance(eye) < TOO_NEAR * bounds.size().min_element() / 2.0
        })?;
        let bounds = self.box_of(near);
        Some(Diagnosis {
            message: Message::new("doctor-camera-too-near").with("name", &near.name),
            things: vec![Thing::object(&near.name)],
            mend_label: Message::new("doctor-mend-step-back"),
            mend: step_back(&bounds),
        })
    }

    fn to_frame_all(&self, message: &'static str) -> Diagnosis {
        let center = self.bounds.center();
        let aim = EditCommand::Camera(CameraMove::LookAt(center));
        // From the point itself there is no direction to it.
        let aim = (center != self.eye()).then_some(aim);
        Diagnosis {
            message: Message::new(message),
            things: vec![Thing::Camera],
            mend_label: Message::new("doctor-mend-frame-all"),
            mend: EditCommand::Several(aim.into_iter().chain([step_back(&self.bounds)]).collect()),
        }
    }
}

/// The camera steps back until the box is in the picture as a whole.
fn step_back(bounds: &Bounds3) -> EditCommand {
    let radius = (bounds.size().length() / 2.0).max(1e-3);
    EditCommand::Camera(CameraMove::Frame { center: bounds.center(), radius })
}

/// Whether a ray from the point leaves the model more often than it enters it.
fn crossings_are_odd(mesh: &TriangleMesh, point: Vec3) -> bool {
    // Not along an axis: models like to have edges there.
    let direction = Vec3::new(0.218_7, 0.943_1, 0.250_3);
    let crosses = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
        let (ab, ac) = (b - a, c - a);
        // Möller and Trumbore 1997.
        let across = direction.cross(ac);
        let (det, from_a) = (ab.dot(across), point - a);
        let u = from_a.dot(across) / det;
        let along = from_a.cross(ab);
        let v = direction.dot(along) / det;
        det != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ac.dot(along) / det > 0.0
    };
    mesh.triangles.iter().filter(crosses).count() % 2 == 1
}
