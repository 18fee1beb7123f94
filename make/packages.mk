# Packages, and bare root file systems in which they are tried.
#
# make deb       packages for Debian in out/deb: library, development files, Python, command
# make wheel     the Python package as a wheel in out/wheel, for any Linux since glibc 2.17
# make try-deb, try-install, try-wheel  packages, `make install` with the crate, and wheel, used in bare root file systems of $(DEBIANS)
# make sdist     the source distribution of the Python package in out/sdist; make try-sdist installs it and computes a force
# make crate     the crate for crates.io, packed and offered to it without publishing
# make packages  all of these, built and tried; the recipes for conda-forge, Spack and containers, read; the site with its references

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

# For PyPI beside the wheels: checked, unpacked, and built by pip in an environment without anything else.
sdist:
	@$(call ENVIRONMENT,$(WHEEL_TOOLS))
	$(WHEEL_TOOLS)/bin/python -m pip install -q 'maturin>=1.9,<2' twine
	rm -rf out/sdist
	cd bindings/python && $(WHEEL_TOOLS)/bin/maturin sdist --out ../../out/sdist
	$(WHEEL_TOOLS)/bin/twine check --strict out/sdist/*.tar.gz

try-sdist: sdist
	@$(call ENVIRONMENT,$(abspath $(TARGET))/of-sdist)
	$(abspath $(TARGET))/of-sdist/bin/python -m pip install -q --force-reinstall out/sdist/*.tar.gz
	rm -rf $(abspath $(TARGET))/of-sdist/try && packaging/try/programs $(abspath $(TARGET))/of-sdist/try
	cp packaging/try/first-force $(abspath $(TARGET))/of-sdist/try
	PYTHON=$(abspath $(TARGET))/of-sdist/bin/python $(abspath $(TARGET))/of-sdist/try/first-force python

# What crates.io would get, listed and packed, not built; only one crate is published.
crate:
	$(CARGO) package -p fmc-contact --list --allow-dirty >$(TARGET)/crate-files.txt
	$(CARGO) package -p fmc-contact --no-verify --allow-dirty
	$(CARGO) publish -p fmc-contact --dry-run --no-verify --allow-dirty

# The recipes for conda-forge, Spack and containers are read, not built; the workflows and the citation keep to their schemas.
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
	$(MAKE) try-sdist crate
	$(MAKE) recipes book
