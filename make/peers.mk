# Other programs with contact of their own, and other versions of hosts.
#
# make peers     wedge, cone, two balls, punch and ironing in GetFEM too, on the same meshes in the same run: table in out/peers
# make compat    the FEniCSx adapter under another Debian's dolfinx, SUITE=trixie, in a root file system of 3 GB
# make dealii    Hertz, a punch, hanging nodes and friction in deal.II beside the reference host; installs libdeal.ii-dev through apt

# GetFEM is a package for the system's own Python. Its BLAS is unpacked here for it alone: installed, OpenBLAS would change every
# other program's.
PEER_BLAS = $(abspath $(TARGET))/peers
BLAS_FOLDER = $(PEER_BLAS)/usr/lib/$(shell $(CC) -print-multiarch)/openblas-serial
RUN_PEERS = FMC=$(abspath $(TARGET))/release/fmc OMP_NUM_THREADS=1 \
  PYTHONPATH=$(CURDIR)/benchmarks/peers:$(CURDIR)/benchmarks/agreement/src LD_LIBRARY_PATH=$(BLAS_FOLDER):$(dir $(BLAS_FOLDER)) \
  $(SYSTEM_PYTHON)

peer-environment:
	$(CARGO) build --release -p fmc
	@$(SYSTEM_PYTHON) -c 'import getfem, jinja2, matplotlib, numpy' 2>/dev/null \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends python3-getfem python3-scipy \
	    $(PAGE_PACKAGES); }
	@test -e $(BLAS_FOLDER)/libblas.so.3 || { mkdir -p $(PEER_BLAS) && cd $(PEER_BLAS) \
	  && { apt-get download -q libopenblas0-serial || { $(SUDO) apt-get update -q && apt-get download -q libopenblas0-serial; }; } \
	  && dpkg -x libopenblas0-serial*.deb .; }

peers: peer-environment
	$(RUN_PEERS) -m fmc_peers out/peers $(PEERS)

peers-test: peer-environment
	$(RUN_PEERS) -m unittest discover -v benchmarks/peers/tests

SUITE ?= trixie

compat: host-environment
	$(SUDO) hosts/dolfinx/compat.sh $(abspath $(TARGET))/compat/$(SUITE) $(HOSTS)/lib/libfmc_contact.so $(SUITE)

# deal.II is built with Debian's MPI and UMFPACK; some 700 MB.
DEALII = $(abspath $(TARGET))/dealii

dealii-program: host-environment
	@test -e /usr/include/deal.II/base/config.h \
	  || { $(SUDO) apt-get update -q && $(SUDO) apt-get install -q -y --no-install-recommends libdeal.ii-dev cmake g++; }
	cmake -S hosts/dealii -B $(DEALII) -DCMAKE_PREFIX_PATH=$(HOSTS) -DCMAKE_BUILD_TYPE=Release
	cmake --build $(DEALII)

dealii: dealii-program
	$(RUN_HOSTS) FMC_DEALII=$(DEALII)/press $(HOSTS)/bin/python hosts/dealii/compare.py out/dealii
