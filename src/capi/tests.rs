//! The C functions called as C calls them.
