# Figures, pages, the book, and what is generated from the header.
#
# make bench     benchmarks
# make figures   runs the cases that pages name; writes docs/results.json, from it the tables of README and docs, and docs/gallery.md
# make header    include/fmc_contact.h from src/capi, and from it what Fortran, Python and the fuzz targets declare, and docs/c-reference.md
# make book      the documentation as pages that are read in a browser, with the references of C, Python and Rust, in out/book

bench:
	$(CARGO) bench -p fmc-benchmarks

# What the pages link to outside of docs is not in the book: there the links lead to the repository, those of a release to its tag.
REPOSITORY := $(shell sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
REVISION = $(or $(shell git describe --tags --exact-match 2>/dev/null),main)

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

# One build, by default that of the tests; CARGO_FLAGS="--profile quick" takes less.
CARGO_FLAGS ?= --release

header:
	UPDATE_HEADER=1 $(CARGO) test $(CARGO_FLAGS) -p fmc-contact --test c_abi generated
	.ci/c-reference write
