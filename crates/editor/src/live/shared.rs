//! What the window and the worker share: the newest wish, the newest picture, the final render.

use super::final_render::{FinalImage, FinalRender, FinalState};
use super::picture::{ObjectMap, Picture};
use super::{LiveError, Ready, Request, Status};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use vitrine::Cancel;
use vitrine::scene::Scene;

/// So long the first picture of a drag may take before a newer wish stops it. Without it a fast drag of a slow scene would
/// show nothing at all.
const PATIENCE: Duration = Duration::from_millis(120);

/// Called when there is something new to show.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// What the window and the worker share.
pub struct Shared {
    state: Mutex<State>,
    changed: Condvar,
    wake: Wake,
}

/// What is shown.
#[derive(Clone, Default)]
pub enum Showing {
    /// The live picture.
    #[default]
    Live,
    /// The final render, until the scene is another than this.
    Final(Arc<Scene>),
}

/// What the worker is doing.
#[derive(Clone)]
pub struct Running {
    /// Stops it.
    pub cancel: Cancel,
    since: Instant,
    /// Whether it belongs to a drag and has shown nothing yet.
    is_first_of_drag: bool,
}

/// The state of both.
#[derive(Default)]
pub struct State {
    /// The newest wish and its number; numbers grow with every call.
    pub request: Option<(u64, Arc<Request>)>,
    /// The number of the wish that the worker took last.
    pub taken: u64,
    /// What the worker is doing.
    pub running: Option<Running>,
    /// The newest live picture.
    pub picture: Option<Arc<Picture>>,
    /// The map of objects that belongs to it.
    pub objects: Option<Arc<ObjectMap>>,
    /// The last scene that could be compiled.
    pub ready: Option<Arc<Ready>>,
    /// How far it is.
    pub status: Status,
    /// The final render.
    pub last: FinalRender,
    /// What is shown.
    pub showing: Showing,
    /// Whether the window has gone.
    pub is_over: bool,
}

/// What there is to do.
pub enum Task {
    /// A live picture.
    Live(LiveTask),
    /// The final render, or what is left of it.
    Final(FinalTask),
}

/// A live picture to be made.
#[derive(Clone)]
pub struct LiveTask {
    /// The number of the wish.
    pub number: u64,
    /// The wish.
    pub request: Arc<Request>,
    /// Stops it.
    pub cancel: Cancel,
    /// When it was taken.
    pub start: Instant,
}

/// A final render to be begun or gone on with.
pub struct FinalTask {
    /// Which of the final renders.
    pub number: u64,
    /// Its scene.
    pub request: Arc<Request>,
    /// Its scene made ready, when it has been begun.
    pub ready: Option<Arc<Ready>>,
    /// What there is of it.
    pub so_far: Option<vitrine::Rendered>,
    /// Threads.
    pub threads: usize,
    /// Stops it.
    pub cancel: Cancel,
    /// What is shown until it has something to show.
    pub before: Option<Arc<Picture>>,
}

impl Shared {
    /// Nothing yet.
    pub fn new(wake: Wake) -> Self {
        Self { state: Mutex::default(), changed: Condvar::new(), wake }
    }

    /// The state. Whoever panicked with it in hand has left it whole: nothing is changed in several steps that could fail.
    pub fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Changes the state and tells the worker.
    pub fn change<T>(&self, change: impl FnOnce(&mut State) -> T) -> T {
        let result = change(&mut self.state());
        self.changed.notify_all();
        result
    }

    /// Changes the state and tells the window.
    pub fn publish<T>(&self, change: impl FnOnce(&mut State) -> T) -> T {
        let result = change(&mut self.state());
        self.changed.notify_all();
        (self.wake)();
        result
    }

    /// Waits until there is something to do; None when the window has gone.
    pub fn wait_for_task(&self) -> Option<Task> {
        let mut state = self.state();
        loop {
            if state.is_over {
                return None;
            }
            if let Some(task) = state.take_task() {
                return Some(task);
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Whether a newer wish makes this one pointless. The first picture of a drag is waited for a while.
    pub fn is_stale(&self, task: &LiveTask) -> bool {
        self.state().is_stale(task)
    }

    /// Notes that the worker has shown the first picture of what it is doing.
    pub fn has_shown(&self) {
        if let Some(running) = &mut self.state().running {
            running.is_first_of_drag = false;
        }
    }
}

impl State {
    /// The next thing to do.
    pub fn take_task(&mut self) -> Option<Task> {
        self.running = None;
        let cancel = Cancel::default();
        let task = if self.last.state == FinalState::Running {
            let mut task = self.last.task(cancel.clone())?;
            task.before = self.picture.clone();
            Task::Final(task)
        } else {
            let (number, request) = self.request.clone().filter(|(number, _)| *number > self.taken)?;
            if matches!(self.showing, Showing::Final(_)) {
                return None;
            }
            self.taken = number;
            Task::Live(LiveTask { number, request, cancel: cancel.clone(), start: Instant::now() })
        };
        let is_first_of_drag = matches!(&task, Task::Live(live) if live.request.is_dragging);
        self.running = Some(Running { cancel, since: Instant::now(), is_first_of_drag });
        Some(task)
    }

    /// Asks for a live picture.
    pub fn show(&mut self, request: Request) {
        let request = Arc::new(request);
        if let Showing::Final(beside) = &self.showing {
            if Arc::ptr_eq(beside, &request.scene) {
                if self.last.use_threads(request.threads) {
                    self.stop_running();
                }
            } else {
                self.showing = Showing::Live;
                self.stop_final();
            }
        }
        let number = self.request.as_ref().map_or(0, |(number, _)| *number) + 1;
        let is_dragging = request.is_dragging;
        self.request = Some((number, request));
        if matches!(self.showing, Showing::Live) && !self.may_finish_first(is_dragging) {
            self.stop_running();
        }
    }

    /// Whether what is running should show its first picture before a newer wish is taken.
    fn may_finish_first(&self, is_dragging: bool) -> bool {
        let first = |r: &Running| r.is_first_of_drag && r.since.elapsed() < PATIENCE;
        is_dragging && self.running.as_ref().is_some_and(first)
    }

    fn is_stale(&self, task: &LiveTask) -> bool {
        let newest = self.request.as_ref();
        let is_newer = |(number, request): &(u64, Arc<Request>)| {
            *number > task.number && !self.may_finish_first(request.is_dragging)
        };
        newest.is_some_and(is_newer) || task.cancel.is_cancelled()
    }

    /// Stops whatever is running.
    pub fn stop_running(&mut self) {
        if let Some(running) = &self.running {
            running.cancel.cancel();
        }
    }

    /// Stops the final render, if it runs.
    pub fn stop_final(&mut self) {
        if self.last.state == FinalState::Running {
            self.last.state = FinalState::Stopped;
            self.last.clock.stop();
            self.stop_running();
        }
    }

    /// Begins a final render; an earlier one is forgotten.
    pub fn start_final(&mut self, request: Request) {
        self.showing = Showing::Final(request.scene.clone());
        self.last.start(request);
        self.stop_running();
    }

    /// Goes on with the final render, if it was stopped.
    pub fn continue_final(&mut self) {
        if self.last.state == FinalState::Stopped {
            let newest = self.request.as_ref().map(|(_, request)| request.scene.clone());
            if let Some(scene) = newest.or_else(|| self.last.scene()) {
                self.showing = Showing::Final(scene);
            }
            self.last.state = FinalState::Running;
            self.last.clock.start();
            self.stop_running();
        }
    }

    /// The picture to be shown.
    pub fn newest_picture(&self) -> Option<Arc<Picture>> {
        match self.showing {
            Showing::Live => self.picture.clone(),
            Showing::Final(_) => self.last.picture.clone().or_else(|| self.picture.clone()),
        }
    }

    /// How far what is shown is.
    pub fn newest_status(&self) -> Status {
        let mut status = match self.showing {
            Showing::Live => self.status.clone(),
            Showing::Final(_) => self.last.status(),
        };
        status.is_busy = self.running.is_some() || self.request.as_ref().is_some_and(|r| r.0 > self.taken);
        if matches!(self.showing, Showing::Final(_)) {
            status.is_busy = self.last.state == FinalState::Running;
        }
        status
    }

    /// Notes why there is no picture.
    pub fn fail(&mut self, task: &Task, error: LiveError) {
        match task {
            Task::Live(_) => self.status.error = Some(error),
            Task::Final(task) if task.number == self.last.number => self.last.fail(error),
            Task::Final(_) => {}
        }
    }

    /// The final picture so far.
    pub fn final_image(&self) -> Option<Arc<FinalImage>> {
        self.last.image.clone()
    }
}
