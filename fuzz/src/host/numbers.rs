//! Lists of nodes, cells and degrees of freedom, 32 or 64 bits wide, that end where memory ends.

use crate::guarded::Guarded;
use std::ffi::c_void;

/// Numbers in the width of a context.
pub(crate) enum Numbers {
    Narrow(Guarded<i32>),
    Wide(Guarded<i64>),
}

impl Numbers {
    pub(crate) fn new(list: &[i64], is_wide: bool) -> Self {
        match is_wide {
            true => Self::Wide(Guarded::new(list)),
            false => Self::Narrow(Guarded::new(&list.iter().map(|&number| number as i32).collect::<Vec<_>>())),
        }
    }

    pub(crate) fn size(is_wide: bool) -> i32 {
        if is_wide { 8 } else { 4 }
    }

    pub(crate) fn ptr(&self) -> *mut c_void {
        match self {
            Self::Narrow(list) => list.ptr().cast(),
            Self::Wide(list) => list.ptr().cast(),
        }
    }

    pub(crate) fn values(&self) -> Vec<i64> {
        match self {
            Self::Narrow(list) => list.values().into_iter().map(i64::from).collect(),
            Self::Wide(list) => list.values().to_vec(),
        }
    }
}
