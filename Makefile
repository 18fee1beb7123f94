# For users
#
# make demo      forces of two meshes in examples/, printed and written as VTU
# make install   PREFIX=/usr/local LIBDIR=lib: shared and static library, stripped, headers, Fortran modules, pkg-config and CMake files (Linux)
# make install-command, install-python   the command fmc and its manual; the Python package for the installed library
# make check     the library alone: format, lints, tests; below two minutes after a build
# make test      all that the repository promises: the library, C and C++ hosts, adapters, the Python package
# make help      all other targets, for those who work on it
#
# demo and install need Rust 1.89 (https://rustup.rs) and nothing else; check and test fetch what they lack through apt.

PREFIX ?= /usr/local
CARGO ?= cargo
TARGET = $(or $(CARGO_TARGET_DIR),target)
VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)
SOVERSION := $(basename $(VERSION))
SUDO = $(if $(filter-out 0,$(shell id -u)),sudo)

.PHONY: check demo examples notebooks test suites fuzz fuzz-long release sanitizers mutants check-tools tools python python-lint hosts host-environment site-suite agree press peer-environment peers peers-test suite compat large getfem dealii-program dealii calculix bench figures figures-check pictures site site-check paper book support header build install install-command install-python deb try-deb try-install wheel try-wheel sdist try-sdist crate recipes packages clean help

# The command with `force` alone: no solver and no pictures are compiled.
demo:
	$(CARGO) run --profile quick -p fmc --no-default-features -- force examples/star.msh examples/block.msh --stiffness 2.8e7
	@printf '%s\n' "" "A point of the star stands 0.01 m deep in the block; their meshes do not match. From the overlap follow the energy and, as its" \
	  "derivative, the force on every node: those on the star and on the block add up to zero. A picture of them, for any browser:" \
	  "  $(CURDIR)/out/force/picture.svg" "" \
	  "To try next:" \
	  "  target/quick/fmc force examples/star.msh examples/block.msh --stiffness 2.8e7 --rotate 1=5      the star turned by 5 degrees" \
	  "  target/quick/fmc force examples/ball.vtu --stiffness 1e6 --obstacle \"half-space axis=0,0,1\"     a ball on a rigid floor, in 3D" \
	  "  target/quick/fmc force --help                                                                   your own meshes, Gmsh or VTK" \
	  "  cargo run --release -p fmc -- run hertz                                                         an equilibrium beside Hertz" \
	  "  docs/first-contact.md                                                                           the same from C, C++, Fortran, Python, Rust"

help:
	@sed -n 's/^# //p' Makefile; grep -h '^# make ' make/*.mk | sed 's/^# //'

# The first of these says where cargo builds; what the others name stands in the parts before them.
include make/check.mk make/release.mk make/calculix.mk make/python.mk make/hosts.mk make/peers.mk make/suite.mk make/pages.mk make/install.mk make/packages.mk

clean:
	$(CARGO) clean
