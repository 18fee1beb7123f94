#!/usr/bin/env bash
# Builds CalculiX of Debian with contact by this library: build.sh FOLDER PREFIX, PREFIX/include and PREFIX/lib having the library.
# The sources come by apt into FOLDER; the program is FOLDER/ccx_fmc. It needs gfortran, libspooles-dev and libarpack2-dev.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/apt/lists/partial"
cd "$1"
prefix=$(cd "$2" && pwd)
version=2.20
key=/usr/share/keyrings/debian-archive-keyring.gpg
source=calculix-ccx-$version/ccx_$version/src

if [ ! -e "$source/fmc_host.c" ]; then
  echo "deb-src [signed-by=$key] http://deb.debian.org/debian bookworm main" >apt/sources.list
  apt=(apt-get -q -o "Dir::Etc::SourceList=$PWD/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null -o "Dir::State::Lists=$PWD/apt/lists")
  "${apt[@]}" update
  rm -rf "calculix-ccx-$version"
  "${apt[@]}" source "calculix-ccx=$version-1"
  patch -d "calculix-ccx-$version" -p1 <"$here/calculix-ccx_$version-1.patch"
fi
cp "$here"/src/fmc_* "$source"
flags="-O2 -w -I/usr/include/spooles -I$prefix/include -DARCH=Linux -DSPOOLES -DARPACK -DMATRIXSTORAGE -DUSE_MT=1"
nice make -s -C "$source" -j "${JOBS:-2}" CFLAGS="$flags" FFLAGS="-O2 -w -fallow-argument-mismatch" \
  LDFLAGS="-L$prefix/lib -lfmc_contact -Wl,-rpath,$prefix/lib"
cp "$source/ccx_$version" ccx_fmc
