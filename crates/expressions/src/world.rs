//! What expressions may ask and do outside the model: the clock, chance, the environment, files,
//! the log. A session owns one [`World`] and lends it to each [`crate::Scope`]; without one,
//! expressions may look but change nothing.

use std::{
    cell::{Cell, RefCell},
    collections::BTreeMap,
    fmt,
    time::{Duration, SystemTime, UNIX_EPOCH},
};

use schema::Class;

/// A source of time: since 1970 in universal time.
type Clock = Box<dyn Fn() -> Duration + Send>;

/// The surroundings of a session.
pub struct World {
    /// Whether functions may change files, folders, the environment and the session.
    pub allows_changes: bool,
    /// Every class of the session, for functions that ask about types no object has yet.
    pub classes: Vec<&'static Class>,
    clock: Clock,
    processor: Clock,
    random: Cell<u64>,
    timers: [Cell<Option<Duration>>; 2],
    environment: RefCell<BTreeMap<String, String>>,
    printed: RefCell<Vec<String>>,
    commands: RefCell<Vec<String>>,
}

impl fmt::Debug for World {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("World").field("allows_changes", &self.allows_changes).finish_non_exhaustive()
    }
}

impl Default for World {
    fn default() -> World {
        World::new(false)
    }
}

impl World {
    /// Surroundings with the clock of the machine. Random numbers start anew, always the same.
    pub fn new(allows_changes: bool) -> World {
        World {
            allows_changes,
            classes: Vec::new(),
            clock: Box::new(|| SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default()),
            processor: Box::new(processor_time),
            random: Cell::new(0),
            timers: [Cell::new(None), Cell::new(None)],
            environment: RefCell::default(),
            printed: RefCell::default(),
            commands: RefCell::default(),
        }
    }

    /// The same with another clock, also for processor time, so that what depends on time can be
    /// repeated.
    #[must_use]
    pub fn with_clock(self, clock: impl Fn() -> Duration + Clone + Send + 'static) -> World {
        World { clock: Box::new(clock.clone()), processor: Box::new(clock), ..self }
    }

    /// Knows all classes of a session.
    #[must_use]
    pub fn with_classes(self, classes: Vec<&'static Class>) -> World {
        World { classes, ..self }
    }

    /// Lines that STR_PRINT, STATUS_PRINT and ALERT wrote since the last call.
    pub fn take_printed(&self) -> Vec<String> {
        self.printed.take()
    }

    /// Commands that EXECUTE_VIEW_COMMAND asked for since the last call; they run after the command
    /// whose expression asked.
    pub fn take_commands(&self) -> Vec<String> {
        self.commands.take()
    }

    /// Processor time of this process.
    pub(crate) fn processor(&self) -> Duration {
        (self.processor)()
    }

    pub(crate) fn print(&self, line: String) {
        self.printed.borrow_mut().push(line);
    }

    pub(crate) fn ask_for(&self, command: String) {
        self.commands.borrow_mut().push(command);
    }

    pub(crate) fn now(&self) -> Duration {
        (self.clock)()
    }

    /// The next of a fixed sequence of numbers from 0 to 1 (`SplitMix64`).
    pub(crate) fn random(&self) -> f64 {
        let state = self.random.get().wrapping_add(0x9E37_79B9_7F4A_7C15);
        self.random.set(state);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        (z >> 11) as f64 / ((1_u64 << 53) - 1) as f64
    }

    /// Starts one of the timers (0 elapsed, 1 processor), or gives the time since it was started.
    pub(crate) fn timer(&self, which: usize, now: Duration, end: bool) -> Duration {
        let Some(timer) = self.timers.get(which) else { return now };
        if end {
            return now.saturating_sub(timer.get().unwrap_or_default());
        }
        timer.set(Some(now));
        now
    }

    pub(crate) fn variable(&self, name: &str) -> Option<String> {
        let set = self.environment.borrow().get(name).cloned();
        set.or_else(|| std::env::var_os(name).map(|v| v.to_string_lossy().into_owned()))
    }

    pub(crate) fn set_variable(&self, name: &str, value: String) {
        self.environment.borrow_mut().insert(name.to_string(), value);
    }
}

/// From the kernel's table of processes, in its ticks of 10 ms; zero where there is none.
fn processor_time() -> Duration {
    let table = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The name of the program, in parentheses, may hold blanks.
    let fields = table.rsplit(')').next().unwrap_or("").split_whitespace();
    let ticks: u64 = fields.skip(11).take(2).filter_map(|t| t.parse::<u64>().ok()).sum();
    Duration::from_millis(ticks * 10)
}
