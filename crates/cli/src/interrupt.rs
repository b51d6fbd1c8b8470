//! Ctrl-C: the first asks the run to stop after the present step, the second ends the process.

use std::sync::Arc;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

static FLAG: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// Set when the user asked to stop.
pub fn flag() -> Arc<AtomicBool> {
    FLAG.get_or_init(|| Arc::new(AtomicBool::new(false))).clone()
}

pub fn requested() -> bool {
    flag().load(Ordering::Relaxed)
}

pub fn install() {
    let flag = flag();
    // Installing fails only if a handler is there already (inside Python, which has its own).
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        eprintln!("\nstopping after this step; press Ctrl-C again to stop at once");
    });
}
