//! The passes of the live picture: soon a coarse one, then ever finer ones.

use std::time::Duration;
use vitrine::scene::{LightSource, Renderer, Scene, Settings};
use vitrine::without_display;

/// The first picture should be there by then.
const SOON: Duration = Duration::from_millis(35);
/// How many times coarser each way the first picture may be.
const SHRINKS: [u32; 4] = [1, 2, 4, 8];
/// Points of a disc lamp that a quick pass tries: the fewest that the renderer tries at all.
const QUICK_SHADOW_POINTS: u32 = 16;
/// Samples after each fine pass.
const FINE: [u32; 3] = [4, 16, 64];
/// A photoreal picture gets so many samples, and more where the scene asks for more: it shows less noise for as long as one
/// looks at it.
const PHOTOREAL: u32 = 256;

/// A pass over the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// With its own size, samples and quality.
    pub settings: Settings,
    /// Whether it counts for how fast pictures are: one sample a pixel, few shadow points.
    pub is_quick: bool,
}

impl Pass {
    /// Whether it can go on from the film of an earlier pass, however that was shown.
    #[must_use]
    pub fn goes_on_from(&self, earlier: &Settings) -> bool {
        let samples = self.settings.samples;
        let earlier_light = Settings { samples, ..without_display(earlier) };
        earlier.samples <= samples && earlier_light == without_display(&self.settings)
    }
}

/// How long the pixels of quick passes took lately.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pace {
    /// And which renderer made them: of another it says nothing.
    seconds_a_pixel: Option<(Renderer, f64)>,
}

impl Pace {
    /// How many times coarser a quick picture of so many pixels must be to be there soon.
    #[must_use]
    pub fn shrink(&self, size: [u32; 2], renderer: Renderer) -> u32 {
        let [.., coarsest] = SHRINKS;
        let known = self.seconds_a_pixel.filter(|(of, _)| *of == renderer);
        let Some((_, seconds)) = known else { return coarsest };
        let all = seconds * f64::from(size[0]) * f64::from(size[1]);
        let is_soon = |shrink: &u32| all / f64::from(shrink * shrink) <= SOON.as_secs_f64();
        SHRINKS.into_iter().find(is_soon).unwrap_or(coarsest)
    }

    /// Learns from so many pixels of a quick pass.
    pub fn learn(&mut self, renderer: Renderer, pixels: u64, took: Duration) {
        if pixels > 0 {
            self.seconds_a_pixel = Some((renderer, took.as_secs_f64() / pixels as f64));
        }
    }
}

/// What is drawn for a view of a scene.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Pixels.
    pub size: [u32; 2],
    /// While things are dragged the picture gets no finer than quick.
    pub is_dragging: bool,
    /// How many times coarser the first pass is.
    pub shrink: u32,
}

/// The passes for a view, the coarsest first.
#[must_use]
pub fn passes(view: &View) -> Vec<Pass> {
    let full = Settings {
        size: view.size.map(|v| v.max(1)),
        samples: 1,
        // What ends a finished picture early would leave the one that is looked at as it is.
        noise: 0.0,
        time_limit: 0.0,
        ..view.scene.settings.clone()
    };
    let quick = quick(&full, view.scene);
    let mut all = Vec::new();
    if view.shrink > 1 {
        let size = full.size.map(|v| v.div_ceil(view.shrink));
        all.push(Pass { settings: Settings { size, ..quick.clone() }, is_quick: true });
    }
    all.push(Pass { settings: quick, is_quick: true });
    if !view.is_dragging {
        let fine = fine(&view.scene.settings).into_iter();
        let settings = fine.map(|samples| Settings { samples, ..full.clone() });
        all.extend(settings.map(|settings| Pass { settings, is_quick: false }));
    }
    all
}

/// Samples after each fine pass. A photoreal picture has twice as many after each, and so three tenths less noise.
fn fine(settings: &Settings) -> Vec<u32> {
    if settings.renderer != Renderer::Photoreal {
        return FINE.to_vec();
    }
    let most = settings.samples.max(PHOTOREAL);
    let next = |samples: &u32| (*samples < most).then(|| samples.saturating_mul(2).min(most));
    std::iter::successors(Some(2), next).collect()
}

/// The settings of a quick pass at full size.
fn quick(full: &Settings, scene: &Scene) -> Settings {
    // It chooses a point of a lamp for each sample, however large the lamp.
    if full.renderer == Renderer::Photoreal {
        return full.clone();
    }
    let is_soft = |l: &vitrine::scene::Light| {
        l.visible && matches!(l.source, LightSource::Disc(_) | LightSource::Sphere(_))
    };
    if full.shadow_points > QUICK_SHADOW_POINTS && scene.lights.iter().any(is_soft) {
        return Settings { shadow_points: QUICK_SHADOW_POINTS, ..full.clone() };
    }
    full.clone()
}

#[cfg(test)]
mod tests {
    use super::*;
    use vitrine::scene::lights::Disc;
    use vitrine::scene::{Light, LightSource};

    fn view(scene: &Scene) -> View<'_> {
        View { scene, size: [640, 480], is_dragging: false, shrink: 4 }
    }

    #[test]
    fn passes_get_finer_and_end_with_64_samples() {
        let disc = Light { source: LightSource::Disc(Disc::default()), ..Light::default() };
        let scene = Scene { lights: vec![disc], ..Scene::default() };
        let all = passes(&view(&scene));
        let short: Vec<_> =
            all.iter().map(|p| (p.settings.size, p.settings.samples, p.settings.shadow_points)).collect();
        let full = [640, 480];
        assert_eq!(
            short,
            [([160, 120], 1, 16), (full, 1, 16), (full, 4, 64), (full, 16, 64), (full, 64, 64)]
        );
        assert!(!all[2].goes_on_from(&all[1].settings) && all[3].goes_on_from(&all[2].settings));
        let dragged = passes(&View { is_dragging: true, shrink: 1, ..view(&scene) });
        assert_eq!(dragged, all[1..2]);
    }

    #[test]
    fn without_soft_shadows_the_quick_pass_is_the_first_sample_of_the_fine_ones() {
        let scene = Scene::default();
        let all = passes(&view(&scene));
        assert!(all[2].goes_on_from(&all[1].settings) && !all[1].goes_on_from(&all[0].settings));
    }

    #[test]
    fn a_photoreal_picture_doubles_its_samples_and_never_begins_again() {
        let samples = |samples| {
            let disc = Light { source: LightSource::Disc(Disc::default()), ..Light::default() };
            let settings = Settings { renderer: Renderer::Photoreal, samples, ..Settings::default() };
            let scene = Scene { lights: vec![disc], settings, ..Scene::default() };
            let all = passes(&view(&scene));
            assert_eq!((all[0].settings.size, all[0].settings.samples), ([160, 120], 1));
            let full = &all[1..];
            assert!(full.iter().all(|pass| pass.settings.size == [640, 480]));
            assert!(full.windows(2).all(|w| w[1].goes_on_from(&w[0].settings)));
            full.iter().map(|pass| pass.settings.samples).collect::<Vec<_>>()
        };
        assert_eq!(samples(1), [1, 2, 4, 8, 16, 32, 64, 128, 256]);
        assert_eq!(samples(700)[8..], [256, 512, 700]);
        assert_eq!(samples(65_536).last(), Some(&65_536));
    }

    #[test]
    fn what_ends_a_finished_picture_early_does_not_end_the_live_one() {
        for renderer in [Renderer::Classic, Renderer::Photoreal] {
            let settings = Settings { renderer, noise: 0.5, time_limit: 0.001, ..Settings::default() };
            let scene = Scene { settings, ..Scene::default() };
            let is_free = |s: &Settings| s.noise == 0.0 && s.time_limit == 0.0;
            assert!(passes(&view(&scene)).iter().all(|pass| is_free(&pass.settings)));
        }
    }

    #[test]
    fn how_fast_one_renderer_is_says_nothing_of_another() {
        let mut pace = Pace::default();
        pace.learn(Renderer::Classic, 640 * 480, Duration::from_millis(1));
        assert_eq!(pace.shrink([640, 480], Renderer::Classic), 1);
        assert_eq!(pace.shrink([640, 480], Renderer::Photoreal), 8);
    }

    #[test]
    fn the_first_picture_is_coarser_the_slower_pixels_are() {
        let (mut pace, renderer) = (Pace::default(), Renderer::Classic);
        assert_eq!(pace.shrink([640, 480], renderer), 8, "as long as nothing is known");
        let mut last = 0;
        for milliseconds in [1, 100, 500, 10_000] {
            pace.learn(renderer, 640 * 480, Duration::from_millis(milliseconds));
            assert!(pace.shrink([640, 480], renderer) > last);
            last = pace.shrink([640, 480], renderer);
        }
        assert_eq!(last, 8);
        pace.learn(renderer, 0, Duration::from_secs(9));
        assert_eq!(pace.shrink([10, 10], renderer), 1, "nothing is learned from nothing");
    }
}
