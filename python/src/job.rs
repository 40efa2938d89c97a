//! Floor 2. Work that gives the interpreter back: in threads of our own, stopped by Ctrl-C, with its progress told.
//!
//! The work runs in a pool. The thread that called waits for it without the interpreter's lock, wakes up to look for signals
//! and to tell the progress, and runs for the work what must be run in Python: functions of the user are called in the
//! thread that they came from.

use crate::failure::Failure;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// How often signals are looked for and the progress is told.
const TICK: Duration = Duration::from_millis(50);

/// What is thrown through the work to end it.
struct Stopped;

/// What the work asks of the thread that called.
enum Message {
    /// To run this in Python.
    Call(Box<dyn FnOnce(Python<'_>) + Send>),
    /// Nothing more: it is done.
    Done,
}

/// The work's end of the line to the thread that called.
pub struct Watch {
    stop: AtomicBool,
    /// Does anybody want to know how far it is?
    counts: bool,
    done: AtomicUsize,
    expected: AtomicUsize,
    messages: Sender<Message>,
}

impl Watch {
    /// This many steps will be made, as far as is known.
    pub fn expect(&self, steps: usize) {
        self.expected.fetch_add(steps, Ordering::Relaxed);
    }

    /// A step is made; does not return if the work is no longer wanted.
    #[inline]
    pub fn step(&self) {
        if self.stop.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Stopped));
        }
        if self.counts {
            self.done.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Runs a piece of Python in the thread that called. What it raises ends the work.
    pub fn in_python<R: Send + 'static>(
        &self,
        call: impl FnOnce(Python<'_>) -> PyResult<R> + Send + 'static,
    ) -> R {
        let (reply, answer) = channel();
        let run = move |py: Python<'_>| {
            // Nobody waits for the answer of work that was stopped.
            let _ = reply.send(call(py));
        };
        if self.messages.send(Message::Call(Box::new(run))).is_err() {
            resume_unwind(Box::new(Stopped));
        }
        match answer.recv() {
            Ok(Ok(value)) => value,
            Ok(Err(error)) => resume_unwind(Box::new(Failure::Python(error))),
            Err(_) => resume_unwind(Box::new(Stopped)),
        }
    }

    fn fraction(&self) -> f64 {
        let (done, expected) = (&self.done, &self.expected);
        let expected = expected.load(Ordering::Relaxed).max(1) as f64;
        (done.load(Ordering::Relaxed) as f64 / expected).min(1.0)
    }
}

/// Runs a piece of work and waits for it. `progress`, if there is one, is called with the fraction that is done, an
/// estimate, every 50 ms, and with 1 at the end.
pub fn run<R: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> Result<R, Failure> + Send + 'static,
) -> PyResult<R> {
    let (sender, messages) = channel();
    // A receiver may not be shared between threads, and a piece of code without the lock counts as one.
    let messages = Mutex::new(messages);
    let watch = Arc::new(Watch {
        stop: AtomicBool::new(false),
        counts: progress.is_some(),
        done: AtomicUsize::new(0),
        expected: AtomicUsize::new(0),
        messages: sender,
    });
    let slot = Arc::new(Mutex::new(None));
    let (theirs, result) = (Arc::clone(&watch), Arc::clone(&slot));
    pool(None)?.spawn(move || {
        let outcome = catch_unwind(AssertUnwindSafe(|| work(&theirs)));
        *lock(&result) = Some(outcome);
        let _ = theirs.messages.send(Message::Done);
    });
    let next = || lock(&messages).recv_timeout(TICK);
    let tell = |fraction: f64| progress.map_or(Ok(()), |p| p.call1((fraction,)).map(|_| ()));
    loop {
        match py.detach(next) {
            Ok(Message::Call(call)) => call(py),
            Ok(Message::Done) | Err(RecvTimeoutError::Disconnected) => break,
            Err(RecvTimeoutError::Timeout) => {
                let heard = py.check_signals().and_then(|()| tell(watch.fraction()));
                if let Err(error) = heard {
                    // The work sees it at its next cell, and nobody waits for it.
                    watch.stop.store(true, Ordering::Relaxed);
                    return Err(error);
                }
            }
        }
    }
    let outcome = lock(&slot).take();
    let value = match outcome.expect("the work leaves its outcome before it says that it is done") {
        Ok(outcome) => outcome?,
        Err(thrown) => return Err(caught(thrown)),
    };
    tell(1.0)?;
    Ok(value)
}

/// What was thrown through the work.
fn caught(thrown: Box<dyn Any + Send>) -> PyErr {
    let thrown = match thrown.downcast::<Failure>() {
        Ok(failure) => return (*failure).into(),
        Err(thrown) => thrown,
    };
    let text = thrown.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| thrown.downcast_ref::<&str>().copied());
    let reason = text.unwrap_or("no reason was given");
    PyRuntimeError::new_err(format!(
        "regge: an error of the library, please report it: {reason}"
    ))
}

/// The pool of this process. Threads do not survive a fork: the child makes a pool of its own.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The pool; a new one if there is none in this process, or another number of threads is wanted.
fn pool(threads: Option<usize>) -> PyResult<Arc<ThreadPool>> {
    let process = std::process::id();
    let mut pool = lock(&POOL);
    if let (Some((id, pool)), None) = (&*pool, threads)
        && *id == process
    {
        return Ok(Arc::clone(pool));
    }
    let builder = ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
    let new = Arc::new(builder.build().map_err(|error| {
        PyRuntimeError::new_err(format!("the threads cannot be started: {error}"))
    })?);
    match pool.replace((process, Arc::clone(&new))) {
        // Its threads are not here, and must not be waited for.
        Some((id, old)) if id != process => std::mem::forget(old),
        _ => {}
    }
    Ok(new)
}

/// How many threads compute. Results do not depend on it.
#[pyfunction]
pub fn num_threads() -> PyResult<usize> {
    Ok(pool(None)?.current_num_threads())
}

/// Computes with so many threads from now on.
#[pyfunction]
pub fn set_num_threads(threads: usize) -> PyResult<()> {
    if !(1..=1024).contains(&threads) {
        return Err(PyValueError::new_err(format!(
            "the number of threads is to be in 1..=1024, not {threads}"
        )));
    }
    pool(Some(threads)).map(|_| ())
}
