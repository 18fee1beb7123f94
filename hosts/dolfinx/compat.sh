#!/bin/sh
# The tests of the dolfinx adapter in another release of Debian, which has another dolfinx:
#
#     compat.sh FOLDER LIBRARY [SUITE]
#
# FOLDER becomes a root file system of about 3 GB, and is used again the next time; LIBRARY is libfmc_contact.so, built
# anywhere older. SUITE: trixie (dolfinx 0.9) or sid, what comes next. To be run as root.
set -eu
root=$1 library=$2 suite=${3:-trixie}
here=$(cd "$(dirname "$0")/../.." && pwd)
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep /debian/ | grep -v security | head -1)

if [ ! -e "$root/ready" ]; then
  command -v debootstrap >/dev/null || { apt-get update -q; apt-get install -q -y --no-install-recommends debootstrap; }
  mkdir -p "$root"
  debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" "$mirror"
fi
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
# Before anything removes the folder, what is mounted in it has to go.
trap 'umount "$root/proc"' EXIT INT TERM
run() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root OMP_NUM_THREADS=1 "$@"; }

if [ ! -e "$root/ready" ]; then
  run DEBIAN_FRONTEND=noninteractive apt-get -q -o Acquire::Check-Valid-Until=false update
  run DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install \
    python3-dolfinx openmpi-bin gcc pkg-config python3-scipy python3-pytest
  touch "$root/ready"
fi
rm -rf "$root/project"
mkdir -p "$root/project"
cp "$library" "$root/project/libfmc_contact.so"
cp -r "$here/bindings/python/src" "$root/project/package"
cp -r "$here/hosts/dolfinx/src" "$root/project/adapter"
mkdir -p "$root/project/hosts/dolfinx"
cp -r "$here/hosts/dolfinx/tests" "$here/hosts/dolfinx/examples" "$here/hosts/dolfinx/README.md" "$root/project/hosts/dolfinx"
mkdir -p "$root/project/docs"
cp "$here/docs/first-contact.md" "$root/project/docs"
run python3 -c 'import dolfinx; print("dolfinx", dolfinx.__version__)'
run PYTHONPATH=/project/package:/project/adapter FMC_CONTACT_LIBRARY=/project/libfmc_contact.so OMPI_MCA_btl=self,sm \
  python3 -m pytest -q -p no:cacheprovider /project/hosts/dolfinx/tests
