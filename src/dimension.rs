//! Work that is compiled in this crate once for the plane and once for space.
//!
//! The public interface is generic over the dimension D. Were the kernels generic up to there, every crate that calls
//! them would compile them again. So the public functions hand over to functions of a fixed dimension, and results come
//! back as what they are: for D = 2, a value of dimension 2 has the very type that is asked for.

use crate::Error;
use std::any::Any;

/// Coordinates of dimension D as such of dimension N; empty where the two differ.
pub(crate) fn rows<const D: usize, const N: usize>(coords: &[[f64; D]]) -> &[[f64; N]] {
    if D == N { coords.as_flattened().as_chunks().0 } else { &[] }
}

/// A value as what it is.
///
/// # Errors
/// [`Error::Dimension`] where it is something else: the dimension asked for was neither 2 nor 3.
pub(crate) fn recast<T: Any, U: Any>(value: T) -> Result<U, Error> {
    let value: Box<dyn Any> = Box::new(value);
    value.downcast::<U>().map(|value| *value).map_err(|_| Error::Dimension { block: 0, expected: 3, found: 0 })
}
