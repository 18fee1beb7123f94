# make check     the library alone: format, lints, tests; below two minutes after a build
# make test      what CI runs: format, lints, all tests in release mode, C and C++ hosts, valgrind, installation, the adapters for
#                scikit-fem, FEniCSx, GetFEM and PETSc, the Python package, arbitrary input for 60 s; seconds of CPU of each suite
# make release   everything that takes long, step by step: test, packages, compat, peers, agree, dealii, examples, sanitizers, fuzz-long, mutants; log: docs/release-log.md
#
# make demo      forces of two meshes in examples/, printed and written as VTU
# make python    the Python package, in an environment of its own under target/, and its tests
# make examples  NGSolve and FElupe with contact, and the notebook, in an environment of their own
# make hosts     the adapters for scikit-fem, FEniCSx, GetFEM and PETSc, and their tests, against the reference host too
# make agree     the cases in all hosts, deal.II too, side by side: table and pictures in out/agree
# make peers     wedge, cone, two balls, punch and ironing in GetFEM too, on the same meshes in the same run: table in out/peers
# make compat    the FEniCSx adapter under another Debian's dolfinx, SUITE=trixie, in a root file system of 3 GB
# make fuzz      arbitrary input for 60 s; make fuzz-long: ten million executions
# make large     two blocks of a million unknowns by multigrid, in PETSc: iterations in out/large; hours
# make getfem    Hertz and a punch in GetFEM beside the reference host, and beside GetFEM's own contact in the same run
# make dealii    Hertz, a punch, hanging nodes and friction in deal.II beside the reference host; installs libdeal.ii-dev through apt
# make bench     benchmarks
# make figures   runs the cases that pages name; writes docs/results.json, from it the tables of README and docs, and docs/gallery.md
# make header    include/fmc_contact.h from src/capi, and from it bindings/fortran/fmc_contact_c.f90 and docs/c-reference.md
# make install   PREFIX=/usr/local LIBDIR=lib: shared and static library, stripped, headers, Fortran modules, pkg-config and CMake files (Linux)
# make install-command, install-python   the command fmc and its manual; the Python package for the installed library
# make deb       packages for Debian in out/deb: library, development files, Python, command
# make wheel     the Python package as a wheel in out/wheel, for any Linux since glibc 2.17
# make try-deb, try-install, try-wheel  packages, `make install` with the crate, and wheel, used in bare root file systems of $(DEBIANS)
# make packages  all of these, built and tried; the recipes for conda-forge and Spack, read; the book
# make book      the documentation as pages that are read in a browser, with the references of C, Python and Rust, in out/book
# make clean
#
# demo and install need Rust (https://rustup.rs) and nothing else; check and test fetch what they lack through apt.

PREFIX ?= /usr/local
CARGO ?= cargo
TARGET = $(or $(CARGO_TARGET_DIR),target)
VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)
SOVERSION := $(basename $(VERSION))
SUDO = $(if $(filter-out 0,$(shell id -u)),sudo)

.PHONY: check demo examples test suites fuzz fuzz-long release sanitizers mutants check-tools tools python hosts host-environment agree peer-environment peers peers-test compat large getfem dealii-program dealii bench figures figures-check book header build install install-command install-python deb try-deb try-install wheel try-wheel recipes packages clean

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

check: check-tools
	$(CARGO) fmt --all --check
	$(CARGO) clippy -p fmc-contact --all-targets --release -- -D warnings
	$(CARGO) test -p fmc-contact --release

# Every step, and every program of tests, is a suite; .ci/suite notes its processor time.
export SUITES = $(abspath $(TARGET))/suites.txt
SUITE_OF = $(CURDIR)/.ci/suite
TRIPLE = $(shell rustc -vV | sed -n 's/^host: //p')
TESTS = --lib --bins --tests --examples
AS_SUITES = $(shell echo CARGO_TARGET_$(TRIPLE)_RUNNER | tr 'a-z-' 'A-Z_')=$(SUITE_OF)

test: tools
	@mkdir -p $(TARGET) && rm -f $(SUITES)
	$(CARGO) fmt --all --check
	$(SUITE_OF) "figures of the pages" $(MAKE) figures-check
	$(SUITE_OF) "lints (clippy)" $(CARGO) clippy --workspace --all-targets --release -- -D warnings
	$(SUITE_OF) "fmc with force alone" $(CARGO) check --release -p fmc --no-default-features
	$(SUITE_OF) "build of the tests" $(CARGO) test --workspace --release $(TESTS) --no-run
	$(AS_SUITES) $(CARGO) test --workspace --release $(TESTS)
	$(SUITE_OF) "examples in the docs" $(CARGO) test --workspace --release --doc
	$(MAKE) -j2 -O hosts fuzz BUILD_FMC=
	$(MAKE) python
	@.ci/suites

# Most of it, like most of `hosts`, has one thread: side by side they take little more than the longer of the two.
fuzz:
	$(SUITE_OF) "fuzz, 60 s" fuzz/run.sh 60

# Ten million executions, an hour or two.
FUZZ_RUNS ?= 10000000

fuzz-long:
	SAID=$(abspath $(TARGET))/said-$@ fuzz/run.sh runs=$(FUZZ_RUNS)

RELEASE_STEPS ?= test packages compat peers-test peers agree dealii examples sanitizers fuzz-long mutants

release:
	.ci/release $(RELEASE_STEPS)

# What is not installed leaves its reason for the log, and fails: nothing counts as passed that was not run.
LEFT_OUT = { echo "$(1)" | tee $(TARGET)/left-out-$@ >&2; exit 1; }

# Address and undefined-behaviour sanitizers over hosts and library, thread sanitizer over what has threads.
sanitizers: check-tools
	.ci/sanitizers hosts
	.ci/sanitizers library
	$(SUDO) .ci/sanitizers threads $(ROOTS)/forky-rust

MUTANTS ?= --file 'src/overlap/**'

mutants:
	@$(CARGO) mutants --version >/dev/null 2>&1 || $(call LEFT_OUT,cargo-mutants is not installed)
	$(CARGO) mutants --package fmc-contact --output $(TARGET) --profile release $(MUTANTS)

# Programs that the tests call, with the Debian package that has each.
CHECK_TOOLS = cc:gcc c++:g++ nm:binutils gfortran:gfortran valgrind:valgrind pkg-config:pkg-config cmake:cmake
TOOLS = $(CHECK_TOOLS) chromium:chromium

FETCH_MISSING = missing=; for tool in $(1); do command -v $${tool%%:*} >/dev/null || missing="$$missing $${tool\#\#*:}"; done; \
	if [ -n "$$missing" ]; then \
	  echo "installing$$missing"; \
	  $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends $$missing; \
	fi

check-tools: TOOLS = $(CHECK_TOOLS)
check-tools tools:
	@$(call FETCH_MISSING,$(TOOLS))
	@$(CARGO) clippy --version >/dev/null 2>&1 && $(CARGO) fmt --version >/dev/null 2>&1 \
	  || rustup component add clippy rustfmt

PYTHON ?= python3
VENV = $(TARGET)/python

# Debian has the module that makes environments in a package of its own.
ENVIRONMENT = $(PYTHON) -c 'import ensurepip' 2>/dev/null \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends python3 python3-venv; }; \
	$(1)/bin/python -m pip --version >/dev/null 2>&1 || $(PYTHON) -m venv --clear $(1)

python:
	@$(call ENVIRONMENT,$(VENV))
	$(VENV)/bin/python -m pip install -q ./bindings/python pytest scipy
	$(SUITE_OF) "Python package" $(VENV)/bin/python -m pytest -q bindings/python

# What is stored in the notebook is renewed with UPDATE_NOTEBOOK=1.
EXAMPLES = $(abspath $(TARGET))/examples

examples:
	@$(call ENVIRONMENT,$(EXAMPLES))
	$(EXAMPLES)/bin/python -m pip install -q ./bindings/python ./hosts/skfem matplotlib ngsolve felupe nbclient ipykernel pytest
	$(SUITE_OF) "examples" $(EXAMPLES)/bin/python -m pytest -q -p no:cacheprovider examples/python

# dolfinx and GetFEM are for the system's own Python, and scikit-fem has to use that one's numpy: a second one beside it would not
# fit their compiled parts. So the environment sees the system's packages, and nothing is installed that brings numpy.
SYSTEM_PYTHON ?= /usr/bin/python3
HOSTS = $(abspath $(TARGET))/hosts
PAGE_PACKAGES = python3-jinja2 python3-matplotlib
HOST_PACKAGES = python3-dolfinx python3-getfem python3-venv libpetsc-real-dev openmpi-bin libopenmpi-dev pkg-config gcc $(PAGE_PACKAGES)

# fmc comes first: the build of the Python package strips the library, after which cargo would build everything again.
# After the tests of the workspace it is there, and BUILD_FMC is empty.
BUILD_FMC = $(CARGO) build --release -p fmc-contact -p fmc

host-environment:
	$(BUILD_FMC)
	@{ $(SYSTEM_PYTHON) -c 'import dolfinx, ensurepip, getfem, jinja2, matplotlib' && mpicc --version && pkg-config PETSc; } >/dev/null 2>&1 \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends $(HOST_PACKAGES); }
	@$(HOSTS)/bin/python -m pip --version >/dev/null 2>&1 \
	  || $(SYSTEM_PYTHON) -m venv --clear --system-site-packages $(HOSTS)
	@$(MAKE) -s install PREFIX=$(HOSTS) BUILT=$(TARGET)/release/deps
	$(MAKE) -C hosts/petsc PREFIX=$(HOSTS) OUT=$(HOSTS)/bin
	$(HOSTS)/bin/python -m pip install -q pytest
	$(HOSTS)/bin/python -m pip install -q --no-deps \
	  scikit-fem ./bindings/python ./benchmarks/agreement ./hosts/skfem ./hosts/dolfinx ./hosts/getfem

RUN_HOSTS = FMC=$(abspath $(TARGET))/release/fmc FMC_PETSC=$(HOSTS)/bin/equilibrium FMC_PRESS=$(HOSTS)/bin/press \
  FMC_DRIVERS=$(CURDIR)/benchmarks/agreement/drivers \
  OMP_NUM_THREADS=1

# Its programs: the host's, the case as a model, and GetFEM's own contact.
GETFEM_FOLDERS = hosts/getfem benchmarks/agreement/drivers/getfem benchmarks/peers
RUN_GETFEM = $(RUN_HOSTS) PYTHONPATH=$(subst $(SPACE),:,$(addprefix $(CURDIR)/,$(GETFEM_FOLDERS)))

hosts: host-environment
	$(RUN_HOSTS) $(SUITE_OF) "scikit-fem" $(HOSTS)/bin/python -m pytest -q hosts/skfem
	$(RUN_HOSTS) $(SUITE_OF) "FEniCSx" $(HOSTS)/bin/python -m pytest -q hosts/dolfinx
	$(RUN_HOSTS) $(SUITE_OF) "PETSc" $(HOSTS)/bin/python -m pytest -q hosts/petsc
	$(RUN_GETFEM) $(SUITE_OF) "GetFEM" $(HOSTS)/bin/python -m pytest -q hosts/getfem
	$(RUN_HOSTS) $(SUITE_OF) "agreement of the hosts" $(HOSTS)/bin/python -m pytest -q benchmarks/agreement

# One stiffness of contact, k h / E, after the other; a million unknowns take some 6 GB, and on one core up to half an hour each.
LARGE_CELLS ?= 56
LARGE_RANKS ?= 1
RATIOS ?= 1 10 100 1000
LARGE = out/large/$(LARGE_CELLS)-$(LARGE_RANKS).md

large: host-environment
	mkdir -p out/large && rm -f $(LARGE)
	for ratio in $(RATIOS); do OMP_NUM_THREADS=1 mpirun --oversubscribe -n $(LARGE_RANKS) \
	  $(HOSTS)/bin/press -cells $(LARGE_CELLS) -ratio $$ratio >>$(LARGE) || exit 1; tail -$$((1 + $(LARGE_RANKS))) $(LARGE); done

getfem: host-environment
	$(RUN_GETFEM) $(HOSTS)/bin/python hosts/getfem/compare.py out/getfem

agree: dealii-program
	$(RUN_HOSTS) FMC_DEALII=$(DEALII)/press $(HOSTS)/bin/python -m fmc_agreement out/agree
	$(RUN_HOSTS) $(HOSTS)/bin/python -m fmc_agreement.penetration out/agree
	$(RUN_HOSTS) $(HOSTS)/bin/python -m fmc_agreement.beside out/agree

# GetFEM is a package for the system's own Python. Its BLAS is unpacked here for it alone: installed, OpenBLAS would change every
# other program's.
PEER_BLAS = $(abspath $(TARGET))/peers
BLAS_FOLDER = $(PEER_BLAS)/usr/lib/$(shell $(CC) -print-multiarch)/openblas-serial
RUN_PEERS = FMC=$(abspath $(TARGET))/release/fmc OMP_NUM_THREADS=1 \
  PYTHONPATH=$(CURDIR)/benchmarks/peers:$(CURDIR)/benchmarks/agreement/src LD_LIBRARY_PATH=$(BLAS_FOLDER):$(dir $(BLAS_FOLDER)) \
  $(SYSTEM_PYTHON)

peer-environment:
	$(CARGO) build --release -p fmc
	@$(SYSTEM_PYTHON) -c 'import getfem, jinja2, matplotlib, numpy' 2>/dev/null \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends python3-getfem python3-scipy \
	    $(PAGE_PACKAGES); }
	@test -e $(BLAS_FOLDER)/libblas.so.3 || { mkdir -p $(PEER_BLAS) && cd $(PEER_BLAS) \
	  && { apt-get download -q libopenblas0-serial || { $(SUDO) apt-get update -q && apt-get download -q libopenblas0-serial; }; } \
	  && dpkg -x libopenblas0-serial*.deb .; }

peers: peer-environment
	$(RUN_PEERS) -m fmc_peers out/peers $(PEERS)

peers-test: peer-environment
	$(RUN_PEERS) -m unittest discover -v benchmarks/peers/tests

SUITE ?= trixie

compat: host-environment
	$(SUDO) hosts/dolfinx/compat.sh $(abspath $(TARGET))/compat/$(SUITE) $(HOSTS)/lib/libfmc_contact.so $(SUITE)

bench:
	$(CARGO) bench -p fmc-benchmarks

# What the pages link to outside of docs is not in the book: there the links lead to the repository, those of a release to its tag.
REPOSITORY := $(shell sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
REVISION = $(or $(shell git describe --tags --exact-match 2>/dev/null),main)

# deal.II is built with Debian's MPI and UMFPACK; some 700 MB.
DEALII = $(abspath $(TARGET))/dealii

dealii-program: host-environment
	@test -e /usr/include/deal.II/base/config.h \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends libdeal.ii-dev cmake g++; }
	cmake -S hosts/dealii -B $(DEALII) -DCMAKE_PREFIX_PATH=$(HOSTS) -DCMAKE_BUILD_TYPE=Release
	cmake --build $(DEALII)

dealii: dealii-program
	$(RUN_HOSTS) FMC_DEALII=$(DEALII)/press $(HOSTS)/bin/python hosts/dealii/compare.py out/dealii

# The cases that pages name, two minutes; what agree, peers and bench have left is taken too.
figures:
	$(CARGO) build --release -p fmc
	python3 benchmarks/results record $(TARGET)/release/fmc
	python3 benchmarks/results write

# Seconds: nothing is run.
figures-check:
	python3 -m unittest discover benchmarks/results
	python3 benchmarks/results check
	.ci/c-reference check

# Beside the pages the references of Python, by pdoc, and of Rust. mdbook is fetched where it is missing, into target/.
BOOK_TOOLS = $(abspath $(TARGET))/book-tools
MDBOOK = $(or $(shell command -v mdbook),$(BOOK_TOOLS)/bin/mdbook)
REFERENCE = out/book/reference

book:
	@test -x $(MDBOOK) || $(CARGO) install --locked --root $(BOOK_TOOLS) --target-dir $(BOOK_TOOLS)/build mdbook
	$(MDBOOK) build docs
	sed -i -e 's|href="\.\./README\.html">fmc-contact<|href="index.html">fmc-contact<|g' -e 's|\(href="\.\./[^"]*\)\.html|\1.md|g' \
	  -e 's|href="\.\./\([^"]*"\)|href="$(REPOSITORY)/tree/$(REVISION)/\1|g' out/book/*.html
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc -p fmc-contact --no-deps
	rm -rf $(REFERENCE) && mkdir -p $(REFERENCE) && cp -r $(TARGET)/doc $(REFERENCE)/rust
	@$(call ENVIRONMENT,$(BOOK_TOOLS)/python)
	$(BOOK_TOOLS)/python/bin/python -m pip install -q pdoc numpy scipy typing_extensions
	@test -e $(BUILT)/libfmc_contact.so || $(MAKE) build
	PYTHONPATH=bindings/python/src FMC_CONTACT_LIBRARY=$(abspath $(BUILT))/libfmc_contact.so \
	  $(BOOK_TOOLS)/python/bin/python .ci/python-reference $(REFERENCE)/python
	.ci/book-links out/book $(REPOSITORY)

header:
	UPDATE_HEADER=1 $(CARGO) test --release --test c_abi header::
	UPDATE_HEADER=1 $(CARGO) test --release --test c_abi fortran::the_committed
	.ci/c-reference write

# Where cargo puts them, also if the environment asks for a target by name.
RELEASE = $(TARGET)$(CARGO_BUILD_TARGET:%=/%)/release

# A folder that holds the built libraries may be given as BUILT; otherwise they are built.
ifdef BUILT
build:
else
BUILT = $(RELEASE)
build:
	$(CARGO) build --release --lib -p fmc-contact
endif

# Where libraries go below PREFIX, as lib/x86_64-linux-gnu; the pkg-config and CMake files find the prefix from there.
LIBDIR ?= lib
STRIP ?= strip
LIB = $(DESTDIR)$(PREFIX)/$(LIBDIR)
EMPTY =
SPACE = $(EMPTY) $(EMPTY)
UP_FROM = $(subst $(SPACE),/,$(foreach part,$(subst /,$(SPACE),$(LIBDIR)/$(1)),..))
INCLUDE = $(DESTDIR)$(PREFIX)/include
FILL = sed -e 's/@VERSION@/$(VERSION)/; s/@SOVERSION@/$(SOVERSION)/; s/@SOVERSION_PATTERN@/$(subst .,\\\\.,$(SOVERSION))/; \
  s|@LIBDIR@|$(LIBDIR)|; s|@UP_FROM_PKGCONFIG@|$(call UP_FROM,pkgconfig)|; s|@UP_FROM_CMAKE@|$(call UP_FROM,cmake/fmc_contact)|'

install: build
	install -d $(LIB)/pkgconfig $(LIB)/cmake/fmc_contact $(INCLUDE)/fmc_contact
	install -m 755 $(BUILT)/libfmc_contact.so $(LIB)/libfmc_contact.so.$(VERSION)
	ln -sf libfmc_contact.so.$(VERSION) $(LIB)/libfmc_contact.so.$(SOVERSION)
	ln -sf libfmc_contact.so.$(SOVERSION) $(LIB)/libfmc_contact.so
	install -m 644 $(BUILT)/libfmc_contact.a $(LIB)
	$(STRIP) --strip-unneeded $(LIB)/libfmc_contact.so.$(VERSION)
	$(STRIP) --strip-debug $(LIB)/libfmc_contact.a
	install -d $(DESTDIR)$(PREFIX)/share/doc/fmc-contact
	install -m 644 LICENSE-MIT LICENSE-APACHE README.md CHANGELOG.md CITATION.cff $(DESTDIR)$(PREFIX)/share/doc/fmc-contact
	install -m 644 include/fmc_contact.h include/fmc_contact.hpp include/fmc_mpi.h $(INCLUDE)
	install -m 644 bindings/fortran/fmc_contact_c.f90 bindings/fortran/fmc_contact.f90 $(INCLUDE)
	install -m 644 include/fmc_contact/*.hpp $(INCLUDE)/fmc_contact
	$(FILL) hosts/c/package/fmc_contact.pc.in > $(LIB)/pkgconfig/fmc_contact.pc
	for file in fmc_contactConfig fmc_contactConfigVersion; do \
	  $(FILL) hosts/c/package/$$file.cmake.in > $(LIB)/cmake/fmc_contact/$$file.cmake || exit 1; \
	done
	@[ -n "$(DESTDIR)" ] || printf '%s\n' "fmc_contact $(VERSION) is in $(PREFIX). Next, in README.md: First force." \
	  "  Not found at compile time: export PKG_CONFIG_PATH=$(PREFIX)/$(LIBDIR)/pkgconfig" \
	  "  Not found at run time: ldconfig as root if $(PREFIX)/$(LIBDIR) is one of the system's, else link with -Wl,-rpath,$(PREFIX)/$(LIBDIR)"

# The Python package for the library that `make install` has put below the same prefix: nothing is compiled, a link leads there.
PYTHONDIR ?= $(shell $(PYTHON) -c 'import sys; print("lib/python%d.%d/site-packages" % sys.version_info[:2])')
PACKAGES = $(DESTDIR)$(PREFIX)/$(PYTHONDIR)
METADATA = $(PACKAGES)/fmc_contact-$(VERSION).dist-info

install-python:
	cd bindings/python/src && find fmc_contact \( -name '*.py' -o -name py.typed \) -exec install -D -m 644 {} $(abspath $(PACKAGES))/{} \;
	install -d $(PACKAGES)/fmc_contact/_native $(METADATA)
	ln -sf $$(realpath -m --relative-to=/$(PYTHONDIR)/fmc_contact/_native /$(LIBDIR)/libfmc_contact.so.$(SOVERSION)) \
	  $(PACKAGES)/fmc_contact/_native/libfmc_contact.so
	sed -n -e '1i Metadata-Version: 2.1\nName: fmc_contact\nVersion: $(VERSION)\nHome-page: $(REPOSITORY)\nLicense: MIT OR Apache-2.0' \
	  -e 's/^requires-python = "\(.*\)"/Requires-Python: \1/p; s/^dependencies = \["\(.*\)"\]/Requires-Dist: \1/p' \
	  bindings/python/pyproject.toml >$(METADATA)/METADATA

# The command, with the pages of the manual, which it writes itself.
install-command:
ifndef COMMAND
	$(CARGO) build --release -p fmc
endif
	install -d $(DESTDIR)$(PREFIX)/bin
	install -m 755 $(or $(COMMAND),$(RELEASE)/fmc) $(DESTDIR)$(PREFIX)/bin/fmc
	$(STRIP) $(DESTDIR)$(PREFIX)/bin/fmc
	$(DESTDIR)$(PREFIX)/bin/fmc man $(DESTDIR)$(PREFIX)/share/man/man1

# Packages for Debian, of the libraries in the folder LIBRARIES and the program COMMAND where those are given.
DEB_TOOLS = dpkg-shlibdeps:dpkg-dev lintian:lintian

deb:
	@$(call FETCH_MISSING,$(DEB_TOOLS))
ifndef COMMAND
	$(CARGO) build --release -p fmc-contact -p fmc
endif
	rm -rf out/deb
	packaging/debian/build.sh $(or $(LIBRARIES),$(RELEASE)/deps) $(or $(COMMAND),$(RELEASE)/fmc) out/deb
	lintian --allow-root --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs out/deb/*.deb

# Root file systems of oldstable, stable and testing, where what is handed out is installed and used; the packages are for the release
# of Debian on which they were built, and later ones.
DEBIANS ?= bookworm trixie forky
ROOTS ?= $(abspath $(TARGET))/debian
NUMPY = $(abspath $(TARGET))/numpy
IN_EACH = for suite in $(1); do $(SUDO) packaging/try/$(2) $(ROOTS)/$$suite $$suite $(3) || exit 1; done

try-deb:
	$(call IN_EACH,$(DEBIANS),deb out/deb)

# What `make install` leaves behind, and the crate, used by projects of their own in C, C++, Fortran, Python and Rust.
INSTALLED = $(abspath $(TARGET))/installed

try-install:
ifndef COMMAND
	$(CARGO) build --release -p fmc-contact -p fmc
endif
	rm -rf $(INSTALLED)
	$(MAKE) -s install BUILT=$(or $(LIBRARIES),$(RELEASE)/deps) DESTDIR=$(INSTALLED) PREFIX=/usr/local
	$(MAKE) -s install-command COMMAND=$(or $(COMMAND),$(RELEASE)/fmc) DESTDIR=$(INSTALLED) PREFIX=/usr/local
	$(MAKE) -s install-python DESTDIR=$(INSTALLED) PREFIX=/usr/local PYTHONDIR=lib/python
	packaging/try/crate $(abspath $(TARGET))/crate
	$(call IN_EACH,$(DEBIANS),install $(INSTALLED) $(abspath $(TARGET))/crate $(NUMPY))

# zig links against a C library as old as is asked for, and comes as a Python package; so the wheel runs where glibc is far older
# than here. The licences of the crates are in the wheel alone.
WHEEL_TOOLS = $(abspath $(TARGET))/wheel-tools
MANYLINUX ?= manylinux_2_17
CRATES = bindings/python/LICENSES-COMPILED-IN

wheel:
	@$(call ENVIRONMENT,$(WHEEL_TOOLS))
	$(WHEEL_TOOLS)/bin/python -m pip install -q 'maturin>=1.9,<2' ziglang auditwheel cffi
	packaging/licences fmc-contact >$(CRATES)
	rm -rf out/wheel
	cd bindings/python && PATH=$(WHEEL_TOOLS)/bin:$$PATH maturin build --release --zig --compatibility $(MANYLINUX) --out ../../out/wheel
	rm -f $(CRATES)
	$(WHEEL_TOOLS)/bin/auditwheel show out/wheel/*.whl

# In each of these, and in a Debian with the oldest Python, numpy and C library that are promised.
try-wheel:
	$(call IN_EACH,$(DEBIANS),wheel out/wheel $(NUMPY))
	$(call IN_EACH,bullseye,wheel out/wheel $(NUMPY),1.20.0)

# The recipes for conda-forge and Spack are read, not built; the workflows and the citation keep to their schemas.
recipes:
	@$(call ENVIRONMENT,$(WHEEL_TOOLS))
	$(WHEEL_TOOLS)/bin/python -m pip install -q py-rattler-build check-jsonschema
	$(WHEEL_TOOLS)/bin/python packaging/check-recipes
	$(WHEEL_TOOLS)/bin/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml
	$(WHEEL_TOOLS)/bin/check-jsonschema --builtin-schema vendor.citation-file-format CITATION.cff

# A step of the release: everything that is handed out, built and tried.
packages:
	$(MAKE) deb try-deb
	$(MAKE) try-install
	$(MAKE) wheel try-wheel
	$(MAKE) recipes book

clean:
	$(CARGO) clean
