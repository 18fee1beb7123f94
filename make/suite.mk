# Contact problems with known answers, in several codes.
#
# make suite     every problem of suite/ in every code: a table and a page in out/suite; goes on where it stopped; some 15 minutes

SUITE_VENV = $(abspath $(TARGET))/suite
SUITE_PACKAGES = ipctk KratosMultiphysics KratosStructuralMechanicsApplication KratosContactStructuralMechanicsApplication \
  KratosLinearSolversApplication
SUITE_TOOLS = ccx:calculix-ccx

# A code that cannot be had leaves the others, and its cells say "failed". GetFEM is for the system's own Python.
suite:
	@$(call ENVIRONMENT,$(SUITE_VENV))
	$(SUITE_VENV)/bin/python -m pip install -q ./bindings/python ./hosts/skfem scipy
	@for package in $(SUITE_PACKAGES); do $(SUITE_VENV)/bin/python -m pip install -q $$package || echo "left out: $$package" >&2; done
	@{ $(call FETCH_MISSING,$(SUITE_TOOLS)); } || echo "left out: CalculiX" >&2
	@$(SYSTEM_PYTHON) -c 'import getfem' 2>/dev/null \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends python3-getfem; } || echo "left out: GetFEM" >&2
	PYTHONPATH=$(CURDIR)/suite SUITE_PYTHON_GETFEM=$(SYSTEM_PYTHON) $(SUITE_VENV)/bin/python -m fmc_suite --out out/suite run $(SUITE_WORDS)
	PYTHONPATH=$(CURDIR)/suite $(SUITE_VENV)/bin/python -m fmc_suite --out out/suite page
	@echo "out/suite/table.md, out/suite/index.html"
