//! The C ABI from outside: the header, the exported symbols, C and C++ hosts, and what `make install` leaves behind.
//!
//! These tests call cc, c++, nm, readelf, valgrind, make, pkg-config and cmake; `make test` installs what is missing.

mod header;
mod histories;
mod hosts;
mod install;
mod program;
mod readme;
mod symbols;
