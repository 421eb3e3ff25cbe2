//! Vector instructions that the processor has, found out at run time.

#[cfg(target_arch = "x86_64")]
use pulp::{NullaryFnOnce, x86::V3};

/// Does `work` in a function compiled for AVX2 where the processor has that, else as it is.
///
/// The work and the functions that it calls are to be inlined: what is called would be compiled for
/// any processor. No operation is fused or reordered, so that both ways give the same bits.
#[inline]
pub fn with_vectors<R>(mut work: impl FnMut() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = V3::try_new() {
        return simd.vectorize(Work(work));
    }
    work()
}

/// Work that is compiled for the instructions of a processor and done once. It is one that could be
/// done again: to such a closure as one that is used up leads a function that is not inlined.
#[cfg(target_arch = "x86_64")]
pub struct Work<F>(pub F);

#[cfg(target_arch = "x86_64")]
impl<R, F: FnMut() -> R> NullaryFnOnce for Work<F> {
    type Output = R;

    #[inline(always)]
    fn call(mut self) -> R {
        (self.0)()
    }
}
