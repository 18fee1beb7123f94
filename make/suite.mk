# Contact problems with known answers, in several codes.
#
# make suite     every problem of suite/ in every code: a table and a page in out/suite; goes on where it stopped; some 20 minutes

SUITE_VENV = $(abspath $(TARGET))/suite
SUITE_SYSTEM_VENV = $(abspath $(TARGET))/suite-system
SUITE_PACKAGES = ipctk KratosMultiphysics KratosStructuralMechanicsApplication KratosContactStructuralMechanicsApplication \
  KratosLinearSolversApplication
SUITE_TOOLS = ccx:calculix-ccx
SUITE_SYSTEM_PACKAGES = python3-dolfinx python3-getfem python3-venv

# A code that cannot be had leaves the others, and its cells say "failed". dolfinx and GetFEM are for the system's own Python: its
# environment sees the system's packages, and nothing is installed that brings numpy.
suite:
	@$(call ENVIRONMENT,$(SUITE_VENV))
	$(SUITE_VENV)/bin/python -m pip install -q ./bindings/python ./hosts/skfem scipy
	@for package in $(SUITE_PACKAGES); do $(SUITE_VENV)/bin/python -m pip install -q $$package || echo "left out: $$package" >&2; done
	@{ $(call FETCH_MISSING,$(SUITE_TOOLS)); } || echo "left out: CalculiX" >&2
	@$(SYSTEM_PYTHON) -c 'import dolfinx, ensurepip, getfem' 2>/dev/null \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends $(SUITE_SYSTEM_PACKAGES); } \
	  || echo "left out: FEniCSx, GetFEM" >&2
	@$(SUITE_SYSTEM_VENV)/bin/python -m pip --version >/dev/null 2>&1 \
	  || $(SYSTEM_PYTHON) -m venv --clear --system-site-packages $(SUITE_SYSTEM_VENV)
	$(SUITE_SYSTEM_VENV)/bin/python -m pip install -q --no-deps ./bindings/python ./hosts/dolfinx ./hosts/getfem
	PYTHONPATH=$(CURDIR)/suite SUITE_PYTHON_GETFEM=$(SUITE_SYSTEM_VENV)/bin/python SUITE_PYTHON_FENICSX=$(SUITE_SYSTEM_VENV)/bin/python \
	  $(SUITE_VENV)/bin/python -m fmc_suite --out out/suite run $(SUITE_WORDS)
	PYTHONPATH=$(CURDIR)/suite $(SUITE_VENV)/bin/python -m fmc_suite --out out/suite page
	@echo "out/suite/table.md, out/suite/index.html"
