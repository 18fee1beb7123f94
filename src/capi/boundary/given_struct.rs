//! One rule for every struct that a host fills: its `_init` function was called, and it asks for nothing that only a later
//! version of the library knows.

use super::failure::Failure;
use super::status::fmc_status::{FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE};

/// Refuses a struct `name` that has another size than `T`, or a reserved field that is not zero.
pub(crate) fn check_struct<T>(
    name: &str,
    struct_size: usize,
    reserved: impl IntoIterator<Item = u64>,
) -> Result<(), Failure> {
    let expected = size_of::<T>();
    if struct_size != expected {
        let text = format!("{name} has struct_size {struct_size}, expected {expected}: call {name}_init first");
        return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, text));
    }
    if reserved.into_iter().any(|field| field != 0) {
        let text = format!("a reserved field of {name} is not zero: one of a later version of the library");
        return Err(Failure::new(FMC_ERROR_RESERVED_FIELD, text));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_is_looked_at_before_what_is_reserved() {
        let checked = |size, reserved: [u64; 2]| {
            check_struct::<[u64; 3]>("fmc_thing", size, reserved).map_err(|failure| (failure.status, failure.text))
        };
        assert_eq!(checked(24, [0, 0]), Ok(()));
        let text = "fmc_thing has struct_size 16, expected 24: call fmc_thing_init first";
        assert_eq!(checked(16, [0, 1]), Err((FMC_ERROR_STRUCT_SIZE, text.into())));
        let text = "a reserved field of fmc_thing is not zero: one of a later version of the library";
        assert_eq!(checked(24, [0, 1]), Err((FMC_ERROR_RESERVED_FIELD, text.into())));
    }
}
