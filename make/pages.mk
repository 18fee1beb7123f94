# Figures, pages, the site, and what is generated from the header.
#
# make bench     benchmarks
# make figures   runs the cases that pages name; writes docs/results.json, from it the tables of README and docs, and docs/gallery.md
# make header    include/fmc_contact.h from src/capi, and from it what Fortran, Python and the fuzz targets declare, and docs/c-reference.md
# make pictures  docs/*.svg that explain one idea each, computed by the library; seconds
# make site      the documentation as a static site in out/site: pages, suite, notebooks, a page to try; nothing is compiled
# make site-check   links, every page in a browser, pictures and the page to try against the library; below a minute after a build
# make paper     paper/paper.md as out/paper/paper.pdf, with pandoc and chromium
# make book      the site with the references of Python and Rust, checked

bench:
	$(CARGO) bench -p fmc-benchmarks

# What the pages link to outside of docs is not in the site: there the links lead to the repository, those of a release to its tag.
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
	.ci/notebooks check
	paper/check.py
	paper/figures.py check

# pandoc writes HTML with MathML, chromium prints it: no TeX is needed. JOSS builds the same paper.md with its own tools.
PAPER_TOOLS = pandoc:pandoc chromium:chromium

paper:
	@$(call FETCH_MISSING,$(PAPER_TOOLS))
	paper/figures.py write
	paper/check.py
	paper/build out/paper

# The pages, the suite, the notebooks and a page to try, in one style; seconds, as nothing is compiled. Formulas become MathML.
SITE = out/site
SITE_TOOLS = $(abspath $(TARGET))/site-tools

site:
	@$(call ENVIRONMENT,$(SITE_TOOLS))
	@$(SITE_TOOLS)/bin/python -m pip install -q 'markdown-it-py>=3,<5' 'Pygments>=2.17' 'latex2mathml>=3.77,<4' numpy scipy
	PYTHONPATH=tools/site:suite $(SITE_TOOLS)/bin/python -m fmc_site $(SITE) $(REPOSITORY) $(REVISION)

PICTURES = PYTHONPATH=tools/pictures:bindings/python/src FMC_CONTACT_LIBRARY=$(LIBRARY_OF_SITE) $(SITE_TOOLS)/bin/python -m fmc_pictures

pictures:
	@$(call ENVIRONMENT,$(SITE_TOOLS))
	$(if $(FMC_CONTACT_LIBRARY),,$(MAKE) build)
	@$(SITE_TOOLS)/bin/python -m pip install -q numpy scipy typing_extensions
	$(PICTURES) write

# Links and anchors; every page in a browser, as wide as a telephone; the page to try, against the library.
site-check: TOOLS = chromium:chromium
site-check: site
	@$(call FETCH_MISSING,$(TOOLS))
	.ci/site-links $(SITE) $(REPOSITORY)
	tools/site/check.py $(SITE)
	$(if $(FMC_CONTACT_LIBRARY),,$(MAKE) build)
	@$(SITE_TOOLS)/bin/python -m pip install -q typing_extensions
	PYTHONPATH=bindings/python/src FMC_CONTACT_LIBRARY=$(LIBRARY_OF_SITE) $(SITE_TOOLS)/bin/python tools/site/compare.py $(SITE)
	$(PICTURES) check

# Another library may be given; else the one of this checkout is built, in no time where it is there.
LIBRARY_OF_SITE = $(or $(FMC_CONTACT_LIBRARY),$(abspath $(BUILT))/libfmc_contact.so)

# Beside the pages the references of Python, by pdoc, and of Rust, in $(SITE)/reference.
REFERENCE = $(SITE)/reference

book:
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc -p fmc-contact --no-deps
	rm -rf $(REFERENCE) && mkdir -p $(REFERENCE) && cp -r $(TARGET)/doc $(REFERENCE)/rust
	@$(call ENVIRONMENT,$(SITE_TOOLS))
	$(SITE_TOOLS)/bin/python -m pip install -q pdoc numpy scipy typing_extensions
	$(if $(FMC_CONTACT_LIBRARY),,$(MAKE) build)
	PYTHONPATH=bindings/python/src FMC_CONTACT_LIBRARY=$(LIBRARY_OF_SITE) $(SITE_TOOLS)/bin/python .ci/python-reference $(REFERENCE)/python
	$(MAKE) site-check

# One build, by default that of the tests; CARGO_FLAGS="--profile quick" takes less.
CARGO_FLAGS ?= --release

header:
	UPDATE_HEADER=1 $(CARGO) test $(CARGO_FLAGS) -p fmc-contact --test c_abi generated
	.ci/c-reference write
