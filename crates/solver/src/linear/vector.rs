//! Runs the block kernels with the vector instructions that the machine has.

/// Says once what the machine has.
#[derive(Clone, Copy, Debug)]
pub struct Vectors {
    #[cfg(target_arch = "x86_64")]
    wide: bool,
}

impl Vectors {
    pub fn detect() -> Self {
        Self {
            #[cfg(target_arch = "x86_64")]
            wide: std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma"),
        }
    }

    /// Calls `work`, whose kernels are inlined here and compiled for those instructions.
    #[inline(always)]
    pub fn run<R>(self, work: impl FnOnce() -> R) -> R {
        #[cfg(target_arch = "x86_64")]
        if self.wide {
            // SAFETY: the instructions were detected when `self` was made.
            #[allow(unsafe_code)]
            return unsafe { run_wide(work) };
        }
        work()
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn run_wide<R>(work: impl FnOnce() -> R) -> R {
    work()
}
