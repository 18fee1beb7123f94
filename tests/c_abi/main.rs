//! The C ABI from outside: the header, the exported symbols, C, C++ and Fortran hosts, and what `make install` leaves behind.
//!
//! These tests call cc, c++, gfortran, nm, readelf, valgrind, make, pkg-config and cmake; `make test` installs what is missing.

mod declarations;
mod febio;
mod fortran;
mod generated;
mod growth;
mod header;
mod histories;
mod hosts;
mod install;
mod order;
mod pages;
mod program;
mod readme;
mod record;
mod symbols;
