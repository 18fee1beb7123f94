# What takes long: every step of a release.
#
# make release   every step below and more, one after another; log: packaging/release-log.md
#                test packages compat peers agree press starts dealii calculix examples sanitizers scenes fuzz-long mutants
# make fuzz      arbitrary input for 60 s; make fuzz-long: ten million executions

# Ten million executions, an hour or two.
FUZZ_RUNS ?= 10000000

fuzz-long:
	SAID=$(abspath $(TARGET))/said-$@ fuzz/run.sh runs=$(FUZZ_RUNS)

# Random positions of two blocks, judged by what must hold in each: some ten minutes.
SCENES ?= 1000..20000

scenes:
	FMC_SCENES=$(SCENES) $(CARGO) test -p fmc-contact --release --test scenes

RELEASE_STEPS ?= test packages compat peers-test peers agree press starts dealii calculix examples sanitizers scenes fuzz-long mutants

release:
	.ci/release $(RELEASE_STEPS)

# What is not installed leaves its reason for the log, and fails: nothing counts as passed that was not run.
LEFT_OUT = { echo "$(1)" | tee $(TARGET)/left-out-$@ >&2; exit 1; }

# Problems in which contact has to start by itself; benchmarks/starts/table.py prints what comes out.
starts: host-environment
	$(RUN_HOSTS) $(HOSTS)/bin/python -m pytest -q --slow benchmarks/starts

# Address and undefined-behaviour sanitizers over hosts and library, thread sanitizer over what has threads.
sanitizers: check-tools
	.ci/sanitizers hosts
	.ci/sanitizers library
	$(SUDO) .ci/sanitizers threads $(ROOTS)/forky-rust

MUTANTS ?= $(addprefix --file ,$(patsubst %,'src/%/**',overlap contact capi partition depth_field))

mutants:
	@$(CARGO) mutants --version >/dev/null 2>&1 || $(call LEFT_OUT,cargo-mutants is not installed)
	$(CARGO) mutants --package fmc-contact --output $(TARGET) --profile release $(MUTANTS)
