//! Ctrl-C where something would be lost: the first asks the run to stop after the present step, the
//! second ends the process. While nothing runs (a command window that waits) one is enough. Commands
//! that only read, and write what they found in the end, install nothing: they end at once.

use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();
static WAITING: AtomicBool = AtomicBool::new(false);

/// Set when the user asked to stop.
pub fn flag() -> Arc<AtomicBool> {
    FLAG.get_or_init(|| Arc::new(AtomicBool::new(false))).clone()
}

pub fn requested() -> bool {
    flag().load(Ordering::Relaxed)
}

/// Says whether the program waits for input, so that nothing is lost when it ends.
pub fn wait(waiting: bool) {
    WAITING.store(waiting, Ordering::Relaxed);
}

pub fn install() {
    let flag = flag();
    // Installing fails only if a handler is there already (inside Python, which has its own).
    let _ = ctrlc::set_handler(move || {
        if WAITING.load(Ordering::Relaxed) || flag.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        eprintln!("\nstopping after this step; press Ctrl-C again to stop at once");
    });
}
