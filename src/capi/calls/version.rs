//! What this library is.

use crate::capi::boundary::entry::quietly;
use crate::capi::boundary::pointer::text;
use std::ffi::{CStr, c_char};

/// Version of the binary interface that this header describes. It grows when a struct or a function changes in a way
/// that a compiled host would notice. A host that loads the library at run time compares it with `fmc_abi_version()`.
pub const FMC_ABI_VERSION: i32 = 3;

/// What a build can lack, by name.
const FEATURES: &[&str] = &[
    #[cfg(feature = "shapes")]
    "shapes",
    #[cfg(feature = "solver")]
    "solver",
];

const VERSION: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
    Ok(version) => version,
    Err(_) => panic!("the version holds a zero"),
};

/// Version of the library, such as "0.1.0". The text is constant and never freed. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn fmc_version() -> *const c_char {
    VERSION.as_ptr()
}

/// Version of the binary interface of the library: `FMC_ABI_VERSION` of the header it was built with. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn fmc_abi_version() -> i32 {
    FMC_ABI_VERSION
}

/// 1 if this build of the library has a feature that a build can lack, else 0: "shapes" (convex hulls and compounds),
/// "solver" (`fmc_condensation`). 0 for any other name and for NULL. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_has_feature(name: *const c_char) -> i32 {
    quietly(0, || {
        // SAFETY: the host passes a text that ends in zero, or NULL.
        let name = unsafe { text("name", name) };
        name.is_ok_and(|name| FEATURES.contains(&name)).into()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names in the documentation of `fmc_has_feature`, as hosts read it.
    #[test]
    fn every_feature_that_the_header_names_is_there() {
        let header = include_str!("../../../include/fmc_contact.h");
        let (before, _) = header.split_once("int32_t fmc_has_feature").expect("the function");
        let comment: Vec<&str> = before.lines().rev().take_while(|line| line.starts_with("//")).collect();
        let comment = comment.into_iter().rev().collect::<Vec<_>>().join(" ");
        let names: Vec<&str> = comment.split('"').skip(1).step_by(2).collect();
        assert_eq!(names.len(), 2, "{names:?}");
        for name in &names {
            let text = std::ffi::CString::new(*name).expect("no zero");
            // SAFETY: a text that ends in zero.
            let found = unsafe { fmc_has_feature(text.as_ptr()) };
            assert!(
                found == 1
                    || *name == "shapes" && cfg!(not(feature = "shapes"))
                    || *name == "solver" && cfg!(not(feature = "solver")),
                "{name}"
            );
        }
        assert!(FEATURES.iter().all(|name| names.contains(name)), "{names:?}");
    }
}
