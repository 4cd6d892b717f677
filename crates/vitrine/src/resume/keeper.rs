//! Keeps how far a render is, now and then, while it goes on.

use super::StateFile;
use crate::Error;
use crate::render::{Glance, Rendered};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Writing takes no more than one part in so many of the time, however large the picture.
const SHARE: u32 = 20;

/// Writes the state file on a thread of its own, so that those that render do not wait for the disc.
#[derive(Debug)]
pub struct StateKeeper {
    every: Duration,
    last: Instant,
    has_written: bool,
    writer: Option<Writer>,
}

#[derive(Debug)]
struct Writer {
    jobs: SyncSender<Rendered>,
    /// How long the last writing took, once it is over.
    done: Receiver<Duration>,
    is_busy: bool,
    thread: JoinHandle<Result<(), Error>>,
}

impl StateKeeper {
    /// Keeps a render in the file, so often.
    #[must_use]
    pub fn new(file: StateFile, every: Duration) -> Self {
        let (jobs, inbox) = sync_channel::<Rendered>(1);
        let (tell, done) = sync_channel(1);
        let thread = std::thread::spawn(move || {
            let mut result = Ok(());
            for rendered in inbox {
                let start = Instant::now();
                result = file.save(rendered);
                // The keeper may have gone; then nobody asks.
                let _ = tell.try_send(start.elapsed());
            }
            result
        });
        let writer = Some(Writer { jobs, done, is_busy: false, thread });
        Self { every, last: Instant::now(), has_written: false, writer }
    }

    /// Has a look at the job, and keeps how far it is when it is time to.
    pub fn look(&mut self, glance: &Glance) {
        let Some(writer) = &mut self.writer else { return };
        if let Ok(took) = writer.done.try_recv() {
            writer.is_busy = false;
            self.every = self.every.max(took * SHARE);
        }
        if writer.is_busy || self.last.elapsed() < self.every {
            return;
        }
        self.last = Instant::now();
        self.has_written = true;
        match writer.jobs.try_send(glance.so_far()) {
            Ok(()) | Err(TrySendError::Full(_)) => writer.is_busy = true,
            Err(TrySendError::Disconnected(_)) => self.writer = None,
        }
    }

    /// Waits until what is being written is on the disc. Whether anything was.
    ///
    /// # Errors
    /// Why the file could not be written the last time.
    pub fn finish(self) -> Result<bool, Error> {
        let Some(Writer { jobs, thread, .. }) = self.writer else { return Ok(self.has_written) };
        drop(jobs);
        // A writer that panicked has said so itself.
        thread.join().unwrap_or(Ok(())).map(|()| self.has_written)
    }
}
