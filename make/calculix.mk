# make calculix  CalculiX of Debian with contact by this library: builds it under target/calculix, some minutes, runs its tests, and
#                writes a table of five decks beside `fmc solve` and ccx's own contact to out/calculix

CALCULIX = $(abspath $(TARGET))/calculix
CALCULIX_PACKAGES = calculix-ccx gfortran gcc make patch dpkg-dev libspooles-dev libarpack2-dev liblapack-dev

calculix:
	$(BUILD_FMC)
	@{ which ccx gfortran && dpkg -s libspooles-dev libarpack2-dev dpkg-dev; } >/dev/null 2>&1 \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends $(CALCULIX_PACKAGES); }
	@$(MAKE) -s install PREFIX=$(CALCULIX) BUILT=$(TARGET)/release/deps
	hosts/calculix/build.sh $(CALCULIX) $(CALCULIX)
	@$(call ENVIRONMENT,$(CALCULIX)/python)
	$(CALCULIX)/python/bin/python -m pip install -q numpy pytest
	$(RUN_CALCULIX) $(SUITE_OF) "CalculiX" $(CALCULIX)/python/bin/python -m pytest -q -p no:cacheprovider hosts/calculix
	mkdir -p out/calculix
	$(RUN_CALCULIX) $(CALCULIX)/python/bin/python hosts/calculix/compare.py out/calculix >out/calculix/table.md
	@cat out/calculix/table.md

RUN_CALCULIX = CCX_FMC=$(CALCULIX)/ccx_fmc FMC=$(abspath $(TARGET))/release/fmc CCX=ccx
