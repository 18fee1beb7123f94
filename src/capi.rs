//! The C ABI: checks, conversions and the panic boundary; no mechanics.
