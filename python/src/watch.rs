//! Work on a thread of its own, so that Python goes on: other threads run, a progress callback is told how
//! far it is, and Ctrl-C is heard. What is over in a moment is done at once, without a thread.
//!
//! A process that is forked has none of the threads of the one it came from: there, work for threads is an
//! error.

use std::{
    panic::{AssertUnwindSafe, catch_unwind},
    process,
    sync::{
        Arc, Condvar, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

use grazing_scenes::{Error, Monitor, Result};
use pyo3::{
    exceptions::{PyRuntimeError, PyValueError},
    prelude::*,
};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::failure::{forked, panicked, raise};

/// Between two looks at Ctrl-C and at the progress.
const PAUSE: Duration = Duration::from_millis(50);

/// How long work that is to end has to do so by itself, as on the command line.
const GRACE: Duration = Duration::from_millis(700);

/// As a main thread has on most systems.
const STACK: usize = 8 << 20;

/// How far the work is, and whether it should end.
#[derive(Default)]
pub struct Watch {
    stop: AtomicBool,
    done: AtomicU64,
    total: AtomicU64,
    told: Mutex<Told>,
}

#[derive(Default)]
struct Told {
    unit: &'static str,
    notes: Vec<String>,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Watch {
    /// Whether the work should end.
    pub fn is_over(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

impl Monitor for Watch {
    fn begin(&self, units: u64, unit: &'static str) {
        lock(&self.told).unit = unit;
        self.done.store(0, Ordering::Relaxed);
        self.total.store(units, Ordering::Relaxed);
    }

    fn note(&self, what: &str) {
        lock(&self.told).notes.push(what.to_string());
    }

    fn advance(&self, units: u64) -> Result<()> {
        self.done.fetch_add(units, Ordering::Relaxed);
        if self.is_over() { Err(Error::interrupted("interrupted")) } else { Ok(()) }
    }
}

/// What a thread came to, once it has: the cause of a panic, an error, or the result.
struct Slot<T> {
    found: Mutex<Option<thread::Result<Result<T>>>>,
    filled: Condvar,
}

impl<T> Slot<T> {
    fn new() -> Slot<T> {
        Slot { found: Mutex::new(None), filled: Condvar::new() }
    }

    /// Does the work and keeps what it came to.
    fn fill(&self, watch: &Watch, work: impl FnOnce(&Watch) -> Result<T>) {
        let found = catch_unwind(AssertUnwindSafe(|| work(watch)));
        *lock(&self.found) = Some(found);
        self.filled.notify_all();
    }

    /// Waits a moment; whether it is filled.
    fn wait(&self) -> bool {
        let waited = self.filled.wait_timeout_while(lock(&self.found), PAUSE, |found| found.is_none());
        waited.unwrap_or_else(PoisonError::into_inner).0.is_some()
    }
}

/// Does work of some microseconds on this thread, without the interpreter's lock: a thread would cost more,
/// and Ctrl-C is heard after it.
pub fn at_once<T: Send>(py: Python<'_>, work: impl FnOnce() -> Result<T> + Send) -> PyResult<T> {
    let found = py.detach(|| catch_unwind(AssertUnwindSafe(work)));
    let found = found.map_err(|cause| panicked(py, &*cause))?;
    found.map_err(|error| raise(py, &error))
}

/// Does the work on another thread, without the interpreter's lock. `progress` is called with (done, total,
/// unit) some times a second, and once at the end; whatever it raises, KeyboardInterrupt included, ends the
/// work and is raised. Work that does not listen is left behind after a moment: it ends when it next looks.
pub fn watched<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> Result<T> + Send + 'static,
) -> PyResult<T> {
    let (watch, slot) = (Arc::new(Watch::default()), Arc::new(Slot::new()));
    let (listener, result) = (watch.clone(), slot.clone());
    let pool = pool(py)?;
    let workers = pool.clone();
    let spawned = builder().spawn(move || result.fill(&listener, |watch| workers.install(|| work(watch))));
    spawned.map_err(|error| no_thread(&error))?;
    attend(py, progress, &watch, &slot, Some((GRACE, &pool)))
}

/// The same for work on borrowed arrays, which is waited for whatever it takes.
pub fn watched_here<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> Result<T> + Send,
) -> PyResult<T> {
    let (watch, slot) = (Watch::default(), Slot::new());
    let pool = pool(py)?;
    thread::scope(|scope| {
        let thread = || slot.fill(&watch, |watch| pool.install(|| work(watch)));
        let spawned = builder().spawn_scoped(scope, thread);
        spawned.map_err(|error| no_thread(&error))?;
        attend(py, progress, &watch, &slot, None)
    })
}

fn builder() -> thread::Builder {
    thread::Builder::new().name("grazing".into()).stack_size(STACK)
}

fn no_thread(error: &std::io::Error) -> PyErr {
    PyRuntimeError::new_err(format!("cannot start a thread: {error}"))
}

/// The threads that share the work.
static POOL: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

/// The process that has them; 0 before there are any. It is set before the lock is taken, which a fork may
/// leave taken for ever.
static HOME: AtomicU32 = AtomicU32::new(0);

/// Whether this process was forked from one that had threads.
pub fn is_forked() -> bool {
    let home = HOME.load(Ordering::Relaxed);
    home != 0 && home != process::id()
}

/// The threads of the next work: as many as there are cores, or as RAYON_NUM_THREADS says.
fn pool(py: Python<'_>) -> PyResult<Arc<ThreadPool>> {
    let _ = HOME.compare_exchange(0, process::id(), Ordering::Relaxed, Ordering::Relaxed);
    if is_forked() {
        return Err(forked(py));
    }
    let mut pool = lock(&POOL);
    if let Some(pool) = &*pool {
        return Ok(pool.clone());
    }
    let count =
        grazing_scenes::internals::threads(0).map_err(|error| PyValueError::new_err(error.to_string()))?;
    let made = ThreadPoolBuilder::new()
        .num_threads(count)
        .stack_size(STACK)
        .thread_name(|i| format!("grazing-{i}"))
        .build();
    let made = made.map_err(|error| PyRuntimeError::new_err(format!("cannot start threads: {error}")))?;
    Ok(pool.insert(Arc::new(made)).clone())
}

/// Leaves threads to the work that does not listen: what comes next has threads of its own.
fn leave(pool: &Arc<ThreadPool>) {
    let mut shared = lock(&POOL);
    if shared.as_ref().is_some_and(|shared| Arc::ptr_eq(shared, pool)) {
        *shared = None;
    }
}

/// Waits for the work, telling of its progress and listening for Ctrl-C; once it is to end, no longer than
/// the grace, if there is one.
fn attend<T: Send>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    watch: &Watch,
    slot: &Slot<T>,
    grace: Option<(Duration, &Arc<ThreadPool>)>,
) -> PyResult<T> {
    let tell = || -> PyResult<()> {
        let Some(progress) = progress else { return Ok(()) };
        let (done, total) = (watch.done.load(Ordering::Relaxed), watch.total.load(Ordering::Relaxed));
        let unit = lock(&watch.told).unit;
        progress.call1((done, total, unit)).map(drop)
    };
    let mut raised: Option<(PyErr, Instant)> = None;
    while !py.detach(|| slot.wait()) {
        match (&raised, grace) {
            (None, _) => {
                let heard = py.check_signals().and_then(|()| tell());
                // The callback may have forked, and gone on in the child, where nothing fills the slot.
                if grace.is_some() && is_forked() {
                    return Err(forked(py));
                }
                if let Err(error) = heard {
                    watch.stop.store(true, Ordering::Relaxed);
                    raised = Some((error, Instant::now()));
                }
            }
            (Some((_, since)), Some((grace, pool))) if since.elapsed() > grace => {
                leave(pool);
                break;
            }
            (Some(_), _) => {}
        }
    }
    if let Some((error, _)) = raised {
        return Err(error);
    }
    // It is filled, or the loop would go on.
    let found = lock(&slot.found).take();
    let found = found.unwrap_or_else(|| Ok(Err(Error::interrupted("interrupted"))));
    let found = found.map_err(|cause| panicked(py, &*cause))?;
    let found = found.map_err(|error| raise(py, &error))?;
    py.check_signals()?;
    tell()?;
    let notes = std::mem::take(&mut lock(&watch.told).notes);
    if !notes.is_empty() {
        let warn = py.import("grazing._errors")?.getattr("warn")?;
        for note in notes {
            warn.call1((note,))?;
        }
    }
    Ok(found)
}
