# Checks of the library and of all that belongs to it.

check: check-tools
	$(CARGO) fmt --all --check
	$(CARGO) clippy -p fmc-contact --all-targets --release -- -D warnings
	$(CARGO) test -p fmc-contact --release
	$(MAKE) python-lint

# Every step, and every program of tests, is a suite; .ci/suite notes its processor time.
export SUITES = $(abspath $(TARGET))/suites.txt
SUITE_OF = $(CURDIR)/.ci/suite
TRIPLE = $(shell rustc -vV | sed -n 's/^host: //p')
TESTS = --lib --bins --tests --examples
AS_SUITES = $(shell echo CARGO_TARGET_$(TRIPLE)_RUNNER | tr 'a-z-' 'A-Z_')=$(SUITE_OF)

# Half the time to build, and tests that take little longer: whatever `make test` starts builds alike.
test: export CARGO_PROFILE_RELEASE_OPT_LEVEL = 2
test: export CARGO_PROFILE_RELEASE_LTO = off

test: tools
	@mkdir -p $(TARGET) && rm -f $(SUITES)
	$(CARGO) fmt --all --check
	$(SUITE_OF) "figures of the pages" $(MAKE) figures-check
	$(SUITE_OF) "lints (clippy)" $(CARGO) clippy --workspace --all-targets --release -- -D warnings
	$(SUITE_OF) "lints (Python)" $(MAKE) python-lint
	$(SUITE_OF) "library and tests without features" $(CARGO) clippy --release -p fmc-contact --all-targets --no-default-features -- -D warnings
	$(SUITE_OF) "fmc with force alone" $(CARGO) clippy --release -p fmc --no-default-features -- -D warnings
	$(SUITE_OF) "build of the tests" $(CARGO) test --workspace --release $(TESTS) --no-run
	$(AS_SUITES) $(CARGO) test --workspace --release $(TESTS)
	$(SUITE_OF) "examples in the docs" $(CARGO) test --workspace --release --doc
	$(MAKE) -j2 -O hosts fuzz site-suite BUILD_FMC=
	$(MAKE) python
	@.ci/suites

# Most of these, like each suite of `hosts`, has one thread: side by side they take half the time.
# Case files need the solver and the benchmarks, which take long to build: fuzz-long has them.
fuzz: export CARGO_PROFILE_RELEASE_OPT_LEVEL = 1
fuzz:
	$(SUITE_OF) "fuzz, 60 s" fuzz/run.sh 60 c_calls gmsh inp vtu

# With the library of the tests.
site-suite:
	$(SUITE_OF) "site" $(MAKE) site-check FMC_CONTACT_LIBRARY=$(abspath $(TARGET))/release/deps/libfmc_contact.so

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
