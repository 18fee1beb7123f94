# Libraries, headers, the command and the Python package below PREFIX.

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
	@[ -n "$(DESTDIR)" ] || printf '%s\n' "fmc_contact $(VERSION) is in $(PREFIX). Next, in README.md: Quick start." \
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
