//! Work that is done on another thread while the window goes on.

use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;

/// Called from another thread when there is something new, so that the window looks.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// How far a task is.
#[derive(Debug, PartialEq, Eq)]
pub enum TaskState<T> {
    /// It goes on.
    Running,
    /// It has ended with this. Given once.
    Done(T),
    /// Its answer has been given, or its thread is gone without one.
    Over,
}

/// A task on a thread of its own.
#[derive(Debug)]
pub struct Task<T> {
    /// None once it has been given.
    answer: Option<Receiver<T>>,
}

impl<T: Send + 'static> Task<T> {
    /// Starts it; `wake` is called when it has ended.
    pub fn spawn(wake: Wake, work: impl FnOnce() -> T + Send + 'static) -> Self {
        let (sender, answer) = mpsc::channel();
        // A system that gives no thread is told by `poll`: the sender is gone.
        let _ = thread::Builder::new().name("file".into()).spawn(move || {
            // Nobody may want the answer any more.
            let _ = sender.send(work());
            wake();
        });
        Self { answer: Some(answer) }
    }

    /// Looks how far it is, without waiting.
    #[must_use]
    pub fn poll(&mut self) -> TaskState<T> {
        let Some(inbox) = &self.answer else { return TaskState::Over };
        match inbox.try_recv() {
            Ok(answer) => {
                self.answer = None;
                TaskState::Done(answer)
            }
            Err(TryRecvError::Empty) => TaskState::Running,
            Err(TryRecvError::Disconnected) => TaskState::Over,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    #[test]
    fn it_runs_beside_the_caller_wakes_and_answers_once() {
        let (go, gate) = mpsc::channel::<()>();
        let (wake, woken) = mpsc::channel();
        let wake = Mutex::new(wake);
        let wake: Wake = Arc::new(move || wake.lock().unwrap().send(()).unwrap());
        let mut task = Task::spawn(wake, move || gate.recv().map(|()| 42).unwrap());
        assert_eq!(task.poll(), TaskState::Running);
        go.send(()).unwrap();
        woken.recv().unwrap();
        assert_eq!(task.poll(), TaskState::Done(42));
        assert_eq!(task.poll(), TaskState::Over);
    }

    #[test]
    fn a_thread_that_is_gone_is_told() {
        let mut task: Task<i32> = Task::spawn(Arc::new(|| ()), || panic!("a panic on purpose"));
        while task.poll() == TaskState::Running {
            thread::yield_now();
        }
        assert_eq!(task.poll(), TaskState::Over);
    }
}
