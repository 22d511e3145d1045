//! Hot loops with the widest registers that the processor has.

/// Does this work, compiled for the registers that this processor has: eight numbers at a time where
/// every x86-64 processor has four. What the work calls takes part only if it is inlined, and so must
/// the closure itself be: `dispatch(#[inline(always)] || ...)`.
///
/// The operations and their order stay the same, and so does the result, to the last bit.
#[cfg(target_arch = "x86_64")]
#[inline]
pub(crate) fn dispatch<R>(work: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(work)
}

/// Does this work: the registers are as wide as the compiler knows.
#[cfg(not(target_arch = "x86_64"))]
#[inline]
pub(crate) fn dispatch<R>(work: impl FnOnce() -> R) -> R {
    work()
}
