//! Results as bytes, bit for bit.
//!
//! By hand, since arrays of a generic length and vectors of nalgebra stand in the same structs, for which no crate of
//! serialisation has both. The bytes never leave one run of one program: ranks have the same byte order.

use crate::geometry::Vector;

/// What can be sent from one rank to another.
pub(crate) trait Packed: Sized {
    /// Appends its bytes.
    fn pack(&self, bytes: &mut Vec<u8>);

    /// Takes its bytes from the front; `None` where they are not those of such a value, or where it was an error, which cannot
    /// be sent: the one who reads finds it again by itself.
    fn unpack(bytes: &mut &[u8]) -> Option<Self>;

    /// Any value, to fill an array with before its bytes are read.
    fn blank() -> Self;
}

/// Implements [`Packed`] for a struct, field by field.
macro_rules! packed {
    ($name:ident<D> { $($field:ident),* $(,)? }) => {
        impl<const D: usize> $crate::ranks::Packed for $name<D> {
            packed!(@functions $($field),*);
        }
    };
    ($name:ident { $($field:ident),* $(,)? }) => {
        impl $crate::ranks::Packed for $name {
            packed!(@functions $($field),*);
        }
    };
    (@functions $($field:ident),*) => {
        fn pack(&self, bytes: &mut Vec<u8>) {
            $($crate::ranks::Packed::pack(&self.$field, bytes);)*
        }

        fn unpack(bytes: &mut &[u8]) -> Option<Self> {
            Some(Self { $($field: $crate::ranks::Packed::unpack(bytes)?),* })
        }

        fn blank() -> Self {
            Self { $($field: $crate::ranks::Packed::blank()),* }
        }
    };
}
pub(crate) use packed;

macro_rules! number {
    ($($kind:ty),*) => { $(
        impl Packed for $kind {
            fn pack(&self, bytes: &mut Vec<u8>) {
                bytes.extend_from_slice(&self.to_ne_bytes());
            }

            fn unpack(bytes: &mut &[u8]) -> Option<Self> {
                let (first, rest) = bytes.split_first_chunk()?;
                *bytes = rest;
                Some(Self::from_ne_bytes(*first))
            }

            fn blank() -> Self {
                Self::default()
            }
        }
    )* };
}

number!(f64, u8, u32, u64, i32, usize);

impl Packed for bool {
    fn pack(&self, bytes: &mut Vec<u8>) {
        u8::from(*self).pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        u8::unpack(bytes).map(|byte| byte != 0)
    }

    fn blank() -> Self {
        false
    }
}

impl<T: Packed, const N: usize> Packed for [T; N] {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.iter().for_each(|entry| entry.pack(bytes));
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let mut is_whole = true;
        let entries = std::array::from_fn(|_| {
            T::unpack(bytes).unwrap_or_else(|| {
                is_whole = false;
                T::blank()
            })
        });
        is_whole.then_some(entries)
    }

    fn blank() -> Self {
        std::array::from_fn(|_| T::blank())
    }
}

impl<const D: usize> Packed for Vector<D> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.iter().for_each(|entry| entry.pack(bytes));
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let mut vector = Self::zeros();
        for entry in vector.iter_mut() {
            *entry = f64::unpack(bytes)?;
        }
        Some(vector)
    }

    fn blank() -> Self {
        Self::zeros()
    }
}

impl<T: Packed> Packed for Vec<T> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.len().pack(bytes);
        self.iter().for_each(|entry| entry.pack(bytes));
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let count = usize::unpack(bytes)?;
        // An entry has a byte at least, so that no number that is not one asks for memory.
        let mut entries = Vec::with_capacity(count.min(bytes.len()));
        for _ in 0..count {
            entries.push(T::unpack(bytes)?);
        }
        Some(entries)
    }

    fn blank() -> Self {
        Self::new()
    }
}

impl<T: Packed> Packed for Option<T> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.is_some().pack(bytes);
        self.iter().for_each(|value| value.pack(bytes));
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        if bool::unpack(bytes)? { T::unpack(bytes).map(Some) } else { Some(None) }
    }

    fn blank() -> Self {
        None
    }
}

impl<T: Packed, E> Packed for Result<T, E> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.is_ok().pack(bytes);
        self.iter().for_each(|value| value.pack(bytes));
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        if bool::unpack(bytes)? { T::unpack(bytes).map(Ok) } else { None }
    }

    fn blank() -> Self {
        Ok(T::blank())
    }
}

impl<T: Packed, U: Packed> Packed for (T, U) {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.0.pack(bytes);
        self.1.pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        Some((T::unpack(bytes)?, U::unpack(bytes)?))
    }

    fn blank() -> Self {
        (T::blank(), U::blank())
    }
}

impl<T: Packed, U: Packed, V: Packed> Packed for (T, U, V) {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.0.pack(bytes);
        self.1.pack(bytes);
        self.2.pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        Some((T::unpack(bytes)?, U::unpack(bytes)?, V::unpack(bytes)?))
    }

    fn blank() -> Self {
        (T::blank(), U::blank(), V::blank())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comes_back_bit_for_bit() {
        type Value = Result<Vec<(Option<[f64; 3]>, u32, (bool, Vector<2>))>, ()>;
        let value: Value = Ok(vec![
            (Some([-0.0, f64::MIN_POSITIVE, 1e300]), 7, (true, Vector::<2>::new(0.1, -3.0))),
            (None, u32::MAX, (false, Vector::<2>::zeros())),
        ]);
        let mut bytes = Vec::new();
        value.pack(&mut bytes);
        let mut rest = &bytes[..];
        let found = Value::unpack(&mut rest);
        assert_eq!((format!("{found:?}"), rest.len()), (format!("{:?}", Some(value)), 0));
    }

    #[test]
    fn errors_and_bytes_of_something_else_are_none() {
        let mut bytes = Vec::new();
        Err::<f64, &str>("none").pack(&mut bytes);
        assert!(Result::<f64, &str>::unpack(&mut &bytes[..]).is_none());
        assert!(Vec::<f64>::unpack(&mut &[255; 12][..]).is_none());
        assert!(f64::unpack(&mut &[0; 7][..]).is_none());
    }
}
