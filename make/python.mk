# The Python package and the examples, each in an environment of its own.
#
# make python    the Python package, in an environment of its own under target/, and its tests
# make python-lint   ruff over all Python, mypy --strict on the package, plain English in pages, headers, docstrings and messages
# make support   docs/support.md: what the library answers for every law and feature
# make examples  NGSolve and FElupe with contact, and the notebooks, in an environment of their own
# make notebooks the tutorials as notebooks, run and stored with output and pictures

PYTHON ?= python3
VENV = $(TARGET)/python

# Debian has the module that makes environments in a package of its own.
ENVIRONMENT = $(PYTHON) -c 'import ensurepip' 2>/dev/null \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends python3 python3-venv; }; \
	$(1)/bin/python -m pip --version >/dev/null 2>&1 || $(PYTHON) -m venv --clear $(1)

python:
	@$(call ENVIRONMENT,$(VENV))
	$(VENV)/bin/python -m pip install -q ./bindings/python pytest pytest-xdist scipy
	$(SUITE_OF) "Python package" $(VENV)/bin/python -m pytest -q -n auto --dist worksteal bindings/python

support:
	@$(call ENVIRONMENT,$(VENV))
	$(VENV)/bin/python -m pip install -q ./bindings/python pytest scipy
	cd bindings/python/tests && $(abspath $(VENV))/bin/python support_matrix.py write

# Lower bounds, so that newer releases are taken; numpy brings types of its own.
LINT = $(TARGET)/lint

python-lint:
	@$(call ENVIRONMENT,$(LINT))
	@$(LINT)/bin/python -m pip install -q 'ruff>=0.14' 'mypy>=1.19' 'numpy>=2.0'
	.ci/plain-english check
	$(LINT)/bin/ruff check .
	cd bindings/python && $(abspath $(LINT))/bin/mypy

EXAMPLES = $(abspath $(TARGET))/examples

EXAMPLE_PACKAGES = ./bindings/python ./hosts/skfem matplotlib nbclient ipykernel pytest

examples:
	@$(call ENVIRONMENT,$(EXAMPLES))
	$(EXAMPLES)/bin/python -m pip install -q $(EXAMPLE_PACKAGES) ngsolve felupe
	$(SUITE_OF) "examples" $(EXAMPLES)/bin/python -m pytest -q -p no:cacheprovider examples/python

# Pages and notebooks have the same programs: `make figures-check` compares them without running anything.
notebooks:
	@$(call ENVIRONMENT,$(EXAMPLES))
	$(EXAMPLES)/bin/python -m pip install -q $(EXAMPLE_PACKAGES)
	$(EXAMPLES)/bin/python .ci/notebooks write
