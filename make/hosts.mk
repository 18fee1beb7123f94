# The adapters, in one environment, and what runs in it.
#
# make hosts     the adapters for scikit-fem, FEniCSx, GetFEM and PETSc, and their tests, against the reference host too
# make agree     the cases in all hosts, deal.II too, side by side: table and pictures in out/agree
# make large     two blocks of a million unknowns by multigrid, in PETSc: iterations in out/large; hours
# make press     the same press in eight hosts that pip installs, some 1.5 GB: tests, and a table in out/press
# make getfem    Hertz and a punch in GetFEM beside the reference host, and beside GetFEM's own contact in the same run

# dolfinx and GetFEM are for the system's own Python, and scikit-fem has to use that one's numpy: a second one beside it would not
# fit their compiled parts. So the environment sees the system's packages, and nothing is installed that brings numpy.
SYSTEM_PYTHON ?= /usr/bin/python3
HOSTS = $(abspath $(TARGET))/hosts
PAGE_PACKAGES = python3-jinja2 python3-matplotlib
HOST_PACKAGES = python3-dolfinx python3-getfem python3-venv libpetsc-real-dev openmpi-bin libopenmpi-dev pkg-config gcc $(PAGE_PACKAGES)

# After the tests of the workspace both are there, and BUILD_FMC is empty.
BUILD_FMC = $(CARGO) build --release -p fmc-contact -p fmc

host-environment:
	$(BUILD_FMC)
	@{ $(SYSTEM_PYTHON) -c 'import dolfinx, ensurepip, getfem, jinja2, matplotlib' && mpicc --version && pkg-config PETSc; } >/dev/null 2>&1 \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends $(HOST_PACKAGES); }
	@$(HOSTS)/bin/python -m pip --version >/dev/null 2>&1 \
	  || $(SYSTEM_PYTHON) -m venv --clear --system-site-packages $(HOSTS)
	@$(MAKE) -s install install-python PREFIX=$(HOSTS) PYTHON=$(HOSTS)/bin/python BUILT=$(TARGET)/release/deps
	$(MAKE) -C hosts/petsc PREFIX=$(HOSTS) OUT=$(HOSTS)/bin
	$(HOSTS)/bin/python -m pip install -q pytest
	$(HOSTS)/bin/python -m pip install -q --no-deps \
	  scikit-fem ./benchmarks/agreement ./hosts/skfem ./hosts/dolfinx ./hosts/getfem

RUN_HOSTS = FMC=$(abspath $(TARGET))/release/fmc FMC_PETSC=$(HOSTS)/bin/equilibrium FMC_PRESS=$(HOSTS)/bin/press \
  FMC_DRIVERS=$(CURDIR)/benchmarks/agreement/drivers \
  OMP_NUM_THREADS=1

# Its programs: the host's, the case as a model, and GetFEM's own contact.
GETFEM_FOLDERS = hosts/getfem benchmarks/agreement/drivers/getfem benchmarks/peers
RUN_GETFEM = $(RUN_HOSTS) PYTHONPATH=$(subst $(SPACE),:,$(addprefix $(CURDIR)/,$(GETFEM_FOLDERS)))

# Each has one thread: with -j2 they run side by side. The longest chain comes first.
HOST_SUITES = dolfinx known-answers agreement skfem petsc getfem

.PHONY: $(HOST_SUITES:%=hosts-%)
hosts: $(HOST_SUITES:%=hosts-%)

hosts-skfem: host-environment
	$(RUN_HOSTS) $(SUITE_OF) "scikit-fem" $(HOSTS)/bin/python -m pytest -q hosts/skfem benchmarks/skfem

hosts-dolfinx: host-environment
	$(RUN_HOSTS) $(SUITE_OF) "FEniCSx" $(HOSTS)/bin/python -m pytest -q hosts/dolfinx

hosts-petsc: host-environment
	$(RUN_HOSTS) $(SUITE_OF) "PETSc" $(HOSTS)/bin/python -m pytest -q hosts/petsc

hosts-getfem: host-environment
	$(RUN_GETFEM) $(SUITE_OF) "GetFEM" $(HOSTS)/bin/python -m pytest -q hosts/getfem

# One after the other: FEniCSx compiles forms into one folder, and gives up where another process takes long for the same.
hosts-known-answers: hosts-dolfinx
	$(RUN_HOSTS) $(SUITE_OF) "problems with known answers" $(HOSTS)/bin/python -m pytest -q -p no:cacheprovider suite

hosts-agreement: hosts-known-answers
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

# Each by itself: one that cannot be had leaves the others. SfePy is compiled, for some minutes; OpenSees loads the system's BLAS.
PRESS = $(abspath $(TARGET))/press
PRESS_PACKAGES = akantu felupe KratosMultiphysics KratosStructuralMechanicsApplication mfem ngsolve openseespy sfepy

press:
	@$(call ENVIRONMENT,$(PRESS))
	$(PRESS)/bin/python -m pip install -q ./bindings/python ./hosts/skfem scipy pytest
	@for package in $(PRESS_PACKAGES); do $(PRESS)/bin/python -m pip install -q $$package || echo "left out: $$package" >&2; done
	@ldconfig -p | grep -q 'libblas\.so\.3' || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends libblas3; }
	$(SUITE_OF) "hosts from pip" $(PRESS)/bin/python -m pytest -q -rs -p no:cacheprovider benchmarks/press
	$(PRESS)/bin/python benchmarks/press/table.py out/press >$(TARGET)/said-press
	@cat out/press/table.md $(TARGET)/said-press
