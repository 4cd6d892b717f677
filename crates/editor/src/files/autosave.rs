//! Autosave: what is being edited is written beside the program's state every few seconds, on a thread of its own, and removed
//! when there is nothing to lose any more.
//!
//! Each window has three files of one name: the scene with what belongs to it, a small picture, and a lock that the system
//! holds for the window as long as it lives, however it ends. So what nobody holds can be recovered.

use super::open::Seen;
use super::places::Places;
use super::recovery::{Recovery, Stored, paths};
use crate::library::ThumbnailImage;
use std::fs::{self, File};
use std::io;
use std::path::PathBuf;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant, SystemTime};
use vitrine::formats::scene_file::print_new;
use vitrine::formats::{FormatError, SceneFile};
use vitrine::scene::Scene;

/// The least time between two writings.
pub const AUTOSAVE_EVERY: Duration = Duration::from_secs(10);

/// A scene as it is at some moment.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// The document's revision, so that one is not written twice.
    pub revision: u64,
    /// What the window calls it.
    pub title: String,
    /// The scene.
    pub scene: Arc<Scene>,
    /// The file that it was read from, for its remarks.
    pub base: Option<SceneFile>,
    /// The scene's file; None when it has none yet.
    pub path: Option<PathBuf>,
    /// The folder that its paths count from.
    pub folder: Option<PathBuf>,
    /// What the scene's file said last.
    pub seen: Option<Seen>,
    /// The picture so far, small.
    pub thumbnail: Option<ThumbnailImage>,
}

/// Which revision was written last, or why that failed.
type Progress = Result<Option<u64>, String>;

enum Message {
    Offer(Box<Snapshot>),
    Forget,
    Replace(Box<Recovery>),
    Finish,
}

/// Autosave of one window.
#[derive(Debug)]
pub struct Autosave {
    messages: Sender<Message>,
    progress: Arc<Mutex<Progress>>,
    thread: Option<JoinHandle<()>>,
    last_offer: Option<u64>,
}

impl Autosave {
    /// Starts it, with the least time between two writings; see [`AUTOSAVE_EVERY`].
    ///
    /// # Errors
    /// When the folder cannot be made or written, or the system gives no thread.
    pub fn start(places: &Places, every: Duration) -> Result<Self, io::Error> {
        let folder = places.autosave_folder();
        fs::create_dir_all(&folder)?;
        let (stem, lock) = claim(&folder)?;
        let (messages, inbox) = mpsc::channel();
        let progress = Arc::new(Mutex::new(Ok(None)));
        let mut writer = Writer {
            stem,
            _lock: lock,
            every,
            progress: Arc::clone(&progress),
            pending: None,
            last: None,
            replaced: None,
        };
        let thread = thread::Builder::new().name("autosave".into()).spawn(move || writer.run(&inbox))?;
        Ok(Self { messages, progress, thread: Some(thread), last_offer: None })
    }

    /// Gives it what there is now. The newest is written, not too often; a revision that it had already is left out. Cheap
    /// enough for every frame, but for the thumbnail, which [`Autosave::wants`] says whether to make.
    pub fn offer(&mut self, snapshot: Snapshot) {
        if self.wants(snapshot.revision) {
            self.last_offer = Some(snapshot.revision);
            self.send(Message::Offer(Box::new(snapshot)));
        }
    }

    /// Whether that revision would be new to it.
    #[must_use]
    pub fn wants(&self, revision: u64) -> bool {
        self.last_offer != Some(revision)
    }

    /// There is nothing to lose: the scene has been saved, or is as it was read.
    pub fn forget(&mut self) {
        self.last_offer = None;
        self.send(Message::Forget);
    }

    /// A recovered scene is being edited in this window now: what it was recovered from is removed as soon as this window has
    /// written it itself, or has nothing to lose any more.
    pub fn replace(&mut self, recovery: Recovery) {
        self.send(Message::Replace(Box::new(recovery)));
    }

    /// Why the last writing failed, once for each failure.
    #[must_use]
    pub fn take_error(&self) -> Option<String> {
        let mut progress = lock(&self.progress);
        if progress.is_ok() { None } else { std::mem::replace(&mut *progress, Ok(None)).err() }
    }

    #[cfg(test)]
    fn revision(&self) -> Option<u64> {
        lock(&self.progress).as_ref().ok().copied().flatten()
    }

    /// The window ends as it should: its files are removed.
    pub fn finish(mut self) {
        self.send(Message::Finish);
        self.join();
    }

    fn send(&self, message: Message) {
        // The thread ends with this value and no sooner.
        let _ = self.messages.send(message);
    }

    fn join(&mut self) {
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Drop for Autosave {
    /// Not finished: something has gone wrong, so what is pending is written and stays.
    fn drop(&mut self) {
        let (nobody, _) = mpsc::channel();
        self.messages = nobody;
        self.join();
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A name that no other window has, and the lock on it.
fn claim(folder: &std::path::Path) -> io::Result<(PathBuf, File)> {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    let mut number = now.as_millis();
    loop {
        let stem = folder.join(format!("{}-{number}", std::process::id()));
        match File::create_new(paths(&stem).lock) {
            Ok(file) => return file.lock().map(|()| (stem, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => number += 1,
            Err(error) => return Err(error),
        }
    }
}

/// The thread's own.
struct Writer {
    stem: PathBuf,
    /// Held as long as the thread lives.
    _lock: File,
    every: Duration,
    progress: Arc<Mutex<Progress>>,
    pending: Option<Box<Snapshot>>,
    last: Option<Instant>,
    replaced: Option<Box<Recovery>>,
}

impl Writer {
    fn run(&mut self, inbox: &Receiver<Message>) {
        loop {
            let due = self.last.map_or(Duration::ZERO, |last| self.every.saturating_sub(last.elapsed()));
            let message = match self.pending {
                Some(_) => inbox.recv_timeout(due),
                None => inbox.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match message {
                Ok(Message::Offer(snapshot)) => self.pending = Some(snapshot),
                Ok(Message::Replace(recovery)) => self.replaced = Some(recovery),
                Ok(Message::Forget) => self.forget(),
                Ok(Message::Finish) => {
                    self.forget();
                    let _ = fs::remove_file(paths(&self.stem).lock);
                    return;
                }
                Err(RecvTimeoutError::Timeout) => self.write(),
                Err(RecvTimeoutError::Disconnected) => return self.write(),
            }
        }
    }

    fn write(&mut self) {
        let Some(snapshot) = self.pending.take() else { return };
        let result = store(&self.stem, &snapshot);
        self.last = Some(Instant::now());
        let mut progress = lock(&self.progress);
        match result {
            Ok(()) => {
                *progress = Ok(Some(snapshot.revision));
                if let Some(old) = self.replaced.take() {
                    old.discard();
                }
            }
            Err(error) => *progress = Err(error.to_string()),
        }
    }

    fn forget(&mut self) {
        self.pending = None;
        if let Some(old) = self.replaced.take() {
            old.discard();
        }
        let own = paths(&self.stem);
        let _ = fs::remove_file(own.scene);
        let _ = fs::remove_file(own.picture);
        *lock(&self.progress) = Ok(None);
    }
}

fn store(stem: &std::path::Path, snapshot: &Snapshot) -> Result<(), FormatError> {
    let scene = &snapshot.scene;
    let stored = Stored {
        title: snapshot.title.clone(),
        path: snapshot.path.clone(),
        folder: snapshot.folder.clone(),
        seen: snapshot.seen.as_ref().map(|s| s.as_text().to_owned()),
        seconds: SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs()),
        text: snapshot.base.as_ref().map_or_else(|| print_new(scene), |base| base.print(scene)),
    };
    stored.write(stem, snapshot.thumbnail.as_ref())
}

#[cfg(test)]
#[path = "autosave_tests.rs"]
mod tests;
