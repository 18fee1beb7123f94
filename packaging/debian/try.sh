#!/usr/bin/env bash
# Installs the packages in a bare Debian of their own and computes a first force there, in C, C++, Fortran, Python and with fmc:
#
#     packaging/debian/try.sh PACKAGES ROOT [SUITE]
#
# PACKAGES: the folder of the .deb files. ROOT becomes a root file system of about 1.5 GB, and is used again the next time.
# SUITE: bookworm, or a later one. To be run as root. The programs are those of docs/first-contact.md.
set -euo pipefail
cd "$(dirname "$0")/../.."
packages=$1 root=$2 suite=${3:-bookworm}
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep /debian/ | grep -v security | head -1)

run() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
purge() {
  installed=$(run dpkg-query -W -f '${Package} ' 'libfmc-contact*' python3-fmc-contact fmc-tools 2>/dev/null || true)
  [ -z "$installed" ] || run dpkg --purge $installed >/dev/null
}
if [ ! -e "$root/ready" ]; then
  command -v debootstrap >/dev/null || { apt-get update -q; apt-get install -q -y --no-install-recommends debootstrap; }
  rm -rf "$root" && mkdir -p "$root"
  debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" "$mirror"
  run apt-get -q -o Acquire::Check-Valid-Until=false update
  run apt-get -q -y --no-install-recommends install g++ gfortran pkg-config cmake make man-db
  touch "$root/ready"
fi

# As on any machine: apt brings what the packages depend on, and nothing else is there.
rm -rf "$root/try" && mkdir "$root/try"
cp "$packages"/*.deb "$root/try"
purge
run sh -c 'apt-get -q -y --no-install-recommends install /try/*.deb'
run sh -c '! command -v rustc'

program() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/ { /^\`\`\`/d; p }" docs/first-contact.md; }
program c >"$root/try/squares.c"
program cpp >"$root/try/squares.cpp"
program fortran >"$root/try/squares.f90"
program python | sed '/scikit-fem\|^from fmc_contact_/,$d' | sed '/^print("overlap/q' >"$root/try/squares.py"
cp hosts/c/two_squares.c hosts/c/CMakeLists.txt examples/star.msh examples/block.msh "$root/try"
cat >"$root/try/all.sh" <<'END'
set -eu
cd /try
flags=$(pkg-config --cflags --libs fmc_contact)
cc squares.c -o in_c $flags
cc squares.c -o in_c_static $(pkg-config --cflags fmc_contact) -static $(pkg-config --static --libs fmc_contact) 2>/dev/null
c++ -std=c++17 squares.cpp -o in_cpp $flags
gfortran /usr/include/fmc_contact_c.f90 /usr/include/fmc_contact.f90 squares.f90 -o in_fortran $flags
# The force on the second square, whose nodes are the last four.
for program in in_c in_c_static in_cpp in_fortran; do
  ./$program | awk -v program=$program '/^node/ { force[++n] = $3 }
    END { sum = force[5] + force[6] + force[7] + force[8]; print program, sum; exit !(sum > 793 && sum < 795) }'
done
python3 squares.py | tee in_python
grep -q 'force on the second square \[79[34]\.' in_python
cmake -S . -B built >/dev/null && cmake --build built >/dev/null && built/two_squares | head -1
fmc force star.msh block.msh --stiffness 2.8e7 | tail -3
man -P cat fmc-force | head -4
END
run sh /try/all.sh

# Gone as if they had never been there.
purge
left=$(find "$root/usr" -name '*fmc*contact*' -o -name 'fmc*.1*')
[ -z "$left" ] || { echo "left behind: $left" >&2; exit 1; }
echo "the packages of $packages work in $suite"
