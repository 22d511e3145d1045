//! Hot loops with the widest registers that the processor has.

use std::iter::Sum;
use std::ops::{AddAssign, Mul};

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

/// The sum of the products of numbers at the same places, so many side by side; what the longer slice has more is
/// left out.
#[inline(always)]
pub(crate) fn sum_of_products<const LANES: usize, T>(a: &[T], b: &[T]) -> T
where
    T: Copy + Default + AddAssign + Mul<Output = T> + Sum,
{
    let length = a.len().min(b.len());
    let (a, rest_a) = a[..length].as_chunks::<LANES>();
    let (b, rest_b) = b[..length].as_chunks::<LANES>();
    let mut lanes = [T::default(); LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            lanes[lane] += a[lane] * b[lane];
        }
    }
    let rest: T = rest_a.iter().zip(rest_b).map(|(&x, &y)| x * y).sum();
    let mut sum: T = lanes.into_iter().sum();
    sum += rest;
    sum
}
